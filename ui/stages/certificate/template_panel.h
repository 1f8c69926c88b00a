// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <QLabel>

class QComboBox;

namespace dyncal {

class InspectorForm;

/// The controls of recipe keys certificate.template and certificate.languages: a built-in template
/// or a file, with what is wrong with it below, and the languages of the document, which a template
/// may state itself.
class TemplatePanel : public QObject
{
    Q_OBJECT

public:
    TemplatePanel(Session &session, InspectorForm &form, QObject *parent);

    /// A file that was chosen; one that is none is refused with its reason.
    void take(const QString &path);

signals:
    void browseRequested();

private:
    void build(InspectorForm &form);
    void chooseTemplateAt(int choice);
    void chooseLanguages(int choice);
    void showRecipe(const Recipe &recipe);
    void showTemplate(const std::string &name);
    void showLanguages(const Recipe &recipe);

    Session &m_session;
    QComboBox *m_template;
    QWidget *m_browse;
    QLabel *m_note;
    QComboBox *m_languages;
};

} // namespace dyncal

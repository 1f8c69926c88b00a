// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/current_utc.h"
#include "ui/stages/frame/stage_page.h"

class QLineEdit;
class QPlainTextEdit;

namespace dyncal {

class DccPanel;
class DecisionPanel;
class InspectorScroll;
class PreviewPanel;
class TemplatePanel;

/// Stage 12: what the certificate says beside the results, the document itself, and its export.
class CertificatePage : public StagePage
{
    Q_OBJECT

public:
    /// `currentUtc`: for the preview, which states when it was made as an export does.
    CertificatePage(Session &session, CurrentUtc currentUtc);

    /// The file of a template that the operator chose.
    void takeTemplate(const QString &path);

signals:
    void exportRequested();
    void templateFileRequested(); ///< which takeTemplate() is to be given

protected:
    void showRecipe() override;
    void showResults() override;

private:
    InspectorScroll *builtForm();
    void buildInspector();
    void setField(const std::string &key, const QString &text, const QString &mergeKey);
    QString field(const std::string &key) const;
    void showMissing();

    void goTo(const std::string &key);

    QWidget *withNote(const std::string &key, QLineEdit *edit);

    std::vector<std::pair<std::string, QLineEdit *>> m_edits;
    std::vector<std::pair<std::string, QLabel *>>
        m_notes; ///< beside dates and countries: what is wrong with them
    InspectorScroll *m_form;
    QPlainTextEdit *m_remarks;
    TemplatePanel *m_template;
    PreviewPanel *m_preview;
    DecisionPanel *m_decision;
    DccPanel *m_dcc;
    QLabel *m_missing;
    QLabel *m_cautions;
};

} // namespace dyncal

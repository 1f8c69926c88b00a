// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/reference/reference_dcc.h"
#include "ui/session/session.h"

#include <QLabel>

#include <functional>
#include <string>

class QComboBox;
class QLineEdit;
class QPushButton;

namespace dyncal {

class InspectorForm;
class Prompts;

/// A section of the recipe that names a file with a response over frequency.
struct SourceSection
{
    QString name; ///< begins the object names: "reference", "chain"
    std::function<std::string(const Recipe &)> path; ///< "" = none
    std::function<std::string(const Recipe &)> list; ///< id in a certificate, "" = the only one
    std::function<std::string(const Recipe &)> content; ///< as it was read, "" = not read
    std::function<Result<CertifiedReference>(const Recipe &)> read; ///< what it states; needs one
    std::function<void(Recipe &, const std::string &path)> take; ///< and reads it; "" = none
    std::function<void(Recipe &, const std::string &id)> choose;
    std::function<std::string(const Recipe &)> unit; ///< of the magnitudes
    std::function<std::string &(Recipe &)> certificate; ///< its number, where the file states none
};

/// The controls of such a file: chosen, left out, which list of a certificate is meant, the number
/// of its certificate, and what it states. A file that states nothing is refused below the button,
/// and nothing changes.
class SourcePanel : public QObject
{
    Q_OBJECT

public:
    SourcePanel(Session &session, Prompts &prompts, InspectorForm &form,
        const SourceSection &section, QObject *parent);

private:
    void build(InspectorForm &form);
    void browse();
    void take(const QString &path);
    void chooseList();
    void setNumber();
    void showRecipe(const Recipe &recipe);
    void showLists(const Recipe &recipe);
    QString faultOf(const Recipe &recipe) const;
    QString stated(const Recipe &recipe) const;

    Session &m_session;
    Prompts &m_prompts;
    SourceSection m_section;
    QLabel *m_file;
    QPushButton *m_browse;
    QPushButton *m_remove;
    QComboBox *m_list;
    QLineEdit *m_number;
    QLabel *m_stated;
    std::string m_shown; ///< of which file, list and unit m_stated speaks
};

SourceSection referenceSection(); ///< recipe section "comparison"
SourceSection chainSection(); ///< "chain"

/// Describes the reference transducer in place of a file.
void useModel(Recipe &recipe, const ReferenceModel &model);

/// Takes the reference transducer out of the recipe, and what rests on it.
void dropReference(Recipe &recipe);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <QObject>

#include <optional>
#include <vector>

class QComboBox;
class QLineEdit;

namespace dyncal {

class EntryList;
class InspectorForm;
class OptionalEdit;

/// "p1: u = 50 Pa, certificate R-1, due 2027-01-31".
QString statedText(const BudgetEntry &entry);

/// The controls of recipe key uncertainty.budget: the u that are stated with their references, and
/// the fields that one is added from or replaced by.
class StatedPanel : public QObject
{
    Q_OBJECT

public:
    StatedPanel(Session &session, InspectorForm &form, QObject *parent);

private:
    void buildFields(InspectorForm &form);
    void buildReference(InspectorForm &form);
    void chooseQuantity();
    void showRecipe(const Recipe &recipe);
    void showEntry(); ///< the selected one in the fields
    void showU(); ///< in a unit that fits it
    void allowWhatIsComplete();
    BudgetEntry typed() const;

    Session &m_session;
    EntryList *m_list;
    QComboBox *m_quantity;
    OptionalEdit *m_uField;
    QComboBox *m_distribution;
    OptionalEdit *m_dofField;
    QLineEdit *m_certificate;
    QLineEdit *m_due;
    std::optional<double> m_u; ///< as its field has it
    std::optional<double> m_dof;
    std::vector<BudgetEntry> m_shown; ///< as the recipe had it when the fields were filled
};

} // namespace dyncal

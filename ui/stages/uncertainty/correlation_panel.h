// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <QObject>

#include <optional>

class QComboBox;

namespace dyncal {

class EntryList;
class InspectorForm;
class OptionalEdit;

/// "Pressure p1 with temperature T1: r = 0.7".
QString correlationText(const CorrelationEntry &entry);

/// The controls of recipe key uncertainty.correlations: the pairs, and the fields that one is added
/// from or replaced by.
class CorrelationPanel : public QObject
{
    Q_OBJECT

public:
    CorrelationPanel(Session &session, InspectorForm &form, QObject *parent);

private:
    QComboBox *addQuantities(InspectorForm &form, const QString &label, const QString &name);
    void showRecipe(const Recipe &recipe);
    void showEntry(); ///< the selected one in the fields
    void allowWhatIsComplete();
    CorrelationEntry typed() const;
    std::size_t selected() const;

    Session &m_session;
    EntryList *m_list;
    QComboBox *m_quantity;
    QComboBox *m_with;
    OptionalEdit *m_coefficient;
    std::optional<double> m_typed; ///< r, as the field has it
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"
#include "ui/stages/uncertainty/tried_changes.h"

#include <QLabel>

class QComboBox;
class QPushButton;

namespace dyncal {

class InspectorForm;
class OptionalEdit;

/// The controls with which another u is tried, taken over into the recipe, or dropped.
class WhatIfPanel : public QObject
{
    Q_OBJECT

public:
    WhatIfPanel(Session &session, InspectorForm &form, QObject *parent);

    const TriedChanges &tried() const { return m_tried; }
    void keepThoseOf(const std::vector<Budget> &budgets) { m_tried.keepThoseOf(budgets); }
    /// Offers the inputs of this value; null = none.
    void show(const Budget *budget);
    void choose(const std::string &quantity);
    void showRecipe(); ///< whether there is something to take over

signals:
    void changed(); ///< what is tried

private:
    void build(InspectorForm &form);
    void fillInputs();
    void showU();
    void tryU(const std::optional<double> &u);
    void takeOver();
    void reset();
    const UncertaintyLine *chosen() const;
    QString stateText() const;

    Session &m_session;
    TriedChanges m_tried;
    ReportedValue m_reported; ///< as computed
    QComboBox *m_input;
    OptionalEdit *m_u;
    QLabel *m_now;
    QLabel *m_note;
    QPushButton *m_takeOver;
    QPushButton *m_reset;
};

} // namespace dyncal

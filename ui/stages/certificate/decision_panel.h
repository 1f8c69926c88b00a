// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <QLabel>

class QComboBox;

namespace dyncal {

class InspectorForm;
class NeededNumbers;
class OptionalEdit;

/// The controls of recipe key certificate.decision, and what the certificate will say by it. A rule
/// that is chosen waits for the limits of the claim.
class DecisionPanel : public QObject
{
    Q_OBJECT

public:
    DecisionPanel(Session &session, InspectorForm &form, QObject *parent);

    void showOutcome(); ///< from the results

private:
    void build(InspectorForm &form);
    void chooseRule(int choice);
    void takeClaim(const std::vector<double> &values, QWidget *field);
    void takeRisk(const std::optional<double> &risk_percent);
    void showRecipe(const Recipe &recipe);
    void allowWhatCounts(const std::optional<DecisionSettings> &decision);

    Session &m_session;
    QComboBox *m_rule;
    NeededNumbers *m_claim;
    std::vector<OptionalEdit *> m_edits;
    OptionalEdit *m_risk;
    QLabel *m_outcome;
    bool m_isMade = false; ///< the recipe has a decision
};

} // namespace dyncal

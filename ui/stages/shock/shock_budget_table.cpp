// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock/shock_budget_table.h"

#include "ui/text/quantity_column.h"
#include "ui/text/quantity_format.h"
#include "ui/text/uncertainty_words.h"

#include <QCoreApplication>

#include <cmath>
#include <map>
#include <vector>

namespace dyncal {

namespace {

struct ShockBudget
{
    Q_DECLARE_TR_FUNCTIONS(ShockBudget)
};

/// Value and u of every input; those of one unit in one, prefix included.
std::vector<ShownResult> shownEstimates(const GumBudget &budget)
{
    std::map<QString, std::vector<Estimate>> byUnit;
    for (const BudgetLine &line : budget.lines)
        byUnit[inputWords(line.input.quantity).unit].push_back({line.input.value, line.input.u});
    std::map<QString, std::vector<ShownResult>> shown;
    for (const auto &[unit, column] : byUnit)
        shown[unit] = shownColumn(column, unit);
    std::map<QString, std::size_t> taken;
    std::vector<ShownResult> estimates;
    estimates.reserve(budget.lines.size());
    for (const BudgetLine &line : budget.lines) {
        const QString unit = inputWords(line.input.quantity).unit;
        estimates.push_back(shown[unit][taken[unit]++]);
    }
    return estimates;
}

} // namespace

ShownTable budgetTable(const ShockConditions &shot)
{
    ShownTable table{{ShockBudget::tr("Quantity"), ShockBudget::tr("Value"), ShockBudget::tr("u"),
                         ShockBudget::tr("Distribution"), ShockBudget::tr("Degrees of freedom"),
                         ShockBudget::tr("To the step"), ShockBudget::tr("Share"),
                         ShockBudget::tr("Common to all shots")},
        {}};
    if (!shot.uncertainty)
        return table;
    constexpr auto kStep = static_cast<Index>(StepResult::Step);
    const GumBudget &budget = shot.uncertainty->budget;
    std::vector<std::optional<double>> contributions_Pa;
    std::vector<std::optional<double>> shares_percent;
    contributions_Pa.reserve(budget.lines.size());
    shares_percent.reserve(budget.lines.size());
    for (std::size_t i = 0; i < budget.lines.size(); ++i) {
        const auto &contribution = budget.lines[i].contribution;
        const bool known = contribution.size() > kStep;
        contributions_Pa.push_back(
            known ? std::optional(std::abs(contribution[kStep])) : std::nullopt);
        shares_percent.push_back(
            known ? std::optional(budget.sharePercent(i, kStep)) : std::nullopt);
    }
    const std::vector<ShownResult> estimates = shownEstimates(budget);
    const QStringList contributions = shownColumn(contributions_Pa, "Pa", 3);
    const QStringList shares = shownColumn(shares_percent, "%", 3);
    for (std::size_t i = 0; i < budget.lines.size(); ++i) {
        const BudgetLine &line = budget.lines[i];
        const UncertainInput &input = line.input;
        const QString name = inputWords(input.quantity).name;
        const auto row = static_cast<qsizetype>(i);
        const ShownResult &estimate = estimates[i];
        table.rows.push_back({name, estimate.value, estimate.u,
            distributionText(input.distribution), dofText(input.dof), contributions[row],
            shares[row], input.common ? ShockBudget::tr("yes") : ShockBudget::tr("no")});
    }
    return table;
}

} // namespace dyncal

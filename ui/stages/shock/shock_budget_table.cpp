// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock/shock_budget_table.h"

#include "ui/text/quantity_column.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace dyncal {

namespace {

struct ShockBudget
{
    Q_DECLARE_TR_FUNCTIONS(ShockBudget)
};

/// An input of the budget in words.
struct InputWords
{
    const char *key; ///< as in the budget, without the place in brackets
    const char *name; ///< %1 = the place
    const char *unit;
};

constexpr std::array<InputWords, 13> kInputs{{
    {"distance_m", QT_TRANSLATE_NOOP("ShockBudget", "Distance, %1"), "m"},
    {"arrival_s", QT_TRANSLATE_NOOP("ShockBudget", "Arrival, %1"), "s"},
    {"delay_s", QT_TRANSLATE_NOOP("ShockBudget", "Delay, %1"), "s"},
    {"time_s", QT_TRANSLATE_NOOP("ShockBudget", "Time, %1"), "s"},
    {"velocity_m_s", QT_TRANSLATE_NOOP("ShockBudget", "Velocity"), "m/s"},
    {kAttenuation, QT_TRANSLATE_NOOP("ShockBudget", "Attenuation along the tube"), "1/m"},
    {"velocity_scatter", QT_TRANSLATE_NOOP("ShockBudget", "Scatter of the velocity"), "m/s"},
    {"p1_pa", QT_TRANSLATE_NOOP("ShockBudget", "p1"), "Pa"},
    {"t1_k", QT_TRANSLATE_NOOP("ShockBudget", "T1"), "K"},
    {"relative_humidity", QT_TRANSLATE_NOOP("ShockBudget", "Relative humidity"), ""},
    {"carbon_dioxide_fraction", QT_TRANSLATE_NOOP("ShockBudget", "CO₂"), ""},
    {"gamma", QT_TRANSLATE_NOOP("ShockBudget", "γ"), ""},
    {"molar_mass_kg_mol", QT_TRANSLATE_NOOP("ShockBudget", "Molar mass in kg/mol"), ""},
}};

/// Name and unit of an input; one that is not in the list keeps its key.
std::pair<QString, QString> wordsFor(const std::string &quantity)
{
    const auto bracket = quantity.find('[');
    const std::string key = quantity.substr(0, bracket);
    for (const InputWords &words : kInputs) {
        if (key != words.key)
            continue;
        QString name = ShockBudget::tr(words.name);
        if (bracket != std::string::npos)
            name = name.arg(shownText(quantity.substr(bracket + 1, quantity.size() - bracket - 2)));
        return {name, words.unit};
    }
    return {shownText(quantity), {}};
}

QString distributionText(Distribution distribution)
{
    switch (distribution) {
    case Distribution::Normal:
        return ShockBudget::tr("normal");
    case Distribution::Rectangular:
        return ShockBudget::tr("rectangular");
    case Distribution::Triangular:
        return ShockBudget::tr("triangular");
    case Distribution::UShaped:
        return ShockBudget::tr("u-shaped");
    }
    return {};
}

/// Value and u of every input; those of one unit in one, prefix included.
std::vector<ShownResult> shownEstimates(const GumBudget &budget)
{
    std::map<QString, std::vector<Estimate>> byUnit;
    for (const BudgetLine &line : budget.lines)
        byUnit[wordsFor(line.input.quantity).second].push_back({line.input.value, line.input.u});
    std::map<QString, std::vector<ShownResult>> shown;
    for (const auto &[unit, column] : byUnit)
        shown[unit] = shownColumn(column, unit);
    std::map<QString, std::size_t> taken;
    std::vector<ShownResult> estimates;
    estimates.reserve(budget.lines.size());
    for (const BudgetLine &line : budget.lines) {
        const QString unit = wordsFor(line.input.quantity).second;
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
        const QString name = wordsFor(input.quantity).first;
        const auto row = static_cast<qsizetype>(i);
        const ShownResult &estimate = estimates[i];
        table.rows.push_back(
            {name, estimate.value, estimate.u, distributionText(input.distribution),
                std::isfinite(input.dof) ? shownNumber(input.dof, 3) : QStringLiteral("∞"),
                contributions[row], shares[row],
                input.common ? ShockBudget::tr("yes") : ShockBudget::tr("no")});
    }
    return table;
}

} // namespace dyncal

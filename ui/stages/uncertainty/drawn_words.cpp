// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/drawn_words.h"

#include "ui/stages/uncertainty/budget_words.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <string>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct DrawnWords
{
    Q_DECLARE_TR_FUNCTIONS(DrawnWords)
};

constexpr double kDegrees = 360.0 / kTwoPi;

DrawnBudget ofValue(const ChainMonteCarlo &drawn, const std::string &of)
{
    const DrawnValue *one = drawn.find(of);
    return one ? DrawnBudget{&one->drawn, &one->gum} : DrawnBudget();
}

DrawnBudget ofRow(const ChainMonteCarlo &drawn, const Budget &budget)
{
    const auto row = std::ranges::find(drawn.rows, budget.frequency_Hz, &DrawnRow::frequency_Hz);
    if (row == drawn.rows.end())
        return {};
    if (budget.kind == BudgetOf::Magnitude)
        return row->withMagnitude ? DrawnBudget{&row->magnitude, &row->gumMagnitude}
                                  : DrawnBudget();
    return row->withPhase ? DrawnBudget{&row->phase, &row->gumPhase} : DrawnBudget();
}

/// `level`: position of a level among the levels.
DrawnBudget drawnOfOne(const ChainMonteCarlo &drawn, const Budget &budget, std::size_t level)
{
    if (budget.isOverFrequency())
        return ofRow(drawn, budget);
    if (budget.kind == BudgetOf::Level)
        return ofValue(drawn, "sensitivity.per_level[" + std::to_string(level) + "]");
    return ofValue(drawn, budget.reported.of);
}

/// Of the budget, which has a phase in degrees.
double inUnitOf(const Budget &budget, double value)
{
    return budget.kind == BudgetOf::Phase ? kDegrees * value : value;
}

QString expandedOf(double U, const Budget &budget)
{
    return relativeText(inUnitOf(budget, U), budget);
}

QString endText(double end, const Budget &budget)
{
    return shownQuantityBeside(
        inUnitOf(budget, end), budget.reported.value, shownText(budget.reported.unit), 5);
}

} // namespace

std::vector<DrawnBudget> drawnOf(const std::vector<Budget> &budgets, const ChainMonteCarlo *drawn)
{
    std::vector<DrawnBudget> list(budgets.size());
    std::size_t level = 0;
    for (std::size_t i = 0; drawn && i < budgets.size(); ++i) {
        list[i] = drawnOfOne(*drawn, budgets[i], level);
        level += budgets[i].kind == BudgetOf::Level ? 1 : 0;
    }
    return list;
}

QString drawnCell(const DrawnBudget &drawn, const Budget &budget)
{
    if (!drawn.drawn || !std::isfinite(drawn.drawn->expanded))
        return QStringLiteral("–");
    return drawn.gum->validated
        ? DrawnWords::tr("validated")
        : QStringLiteral("U = ") + expandedOf(drawn.drawn->expanded, budget);
}

QString drawnSentence(const DrawnBudget &drawn, const Budget &budget)
{
    if (!drawn.drawn)
        return DrawnWords::tr("Monte Carlo: none of this value yet.");
    const QString trials = QString::number(drawn.drawn->trials);
    if (drawn.drawn->undefined > 0)
        return DrawnWords::tr("Monte Carlo, %1 trials: in %2 of them the value does not exist.")
            .arg(trials, QString::number(drawn.drawn->undefined));
    const QString found
        = DrawnWords::tr("Monte Carlo, %1 trials: from %2 to %3, U = %4.")
              .arg(trials, endText(drawn.drawn->low, budget), endText(drawn.drawn->high, budget),
                  expandedOf(drawn.drawn->expanded, budget));
    const QString byLaw = expandedOf(drawn.gum->expanded(), budget);
    return found + QLatin1Char(' ')
        + (drawn.gum->validated
                ? DrawnWords::tr("It validates the law of propagation (U = %1).").arg(byLaw)
                : DrawnWords::tr("It does not validate the law of propagation (U = %1).")
                      .arg(byLaw));
}

} // namespace dyncal

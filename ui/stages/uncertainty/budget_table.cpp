// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/budget_table.h"

#include "core/uncertainty/more_shots.h"
#include "ui/stages/uncertainty/budget_words.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"
#include "ui/text/uncertainty_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct BudgetTable
{
    Q_DECLARE_TR_FUNCTIONS(BudgetTable)
};

const QString kNoValue = QStringLiteral("–");

QString estimateText(const UncertaintyLine &line)
{
    const InputWords words = inputWords(line.quantity);
    if (words.in != CountedIn::Unit || !std::isfinite(line.value))
        return kNoValue;
    return shownResult(line.value, line.u, words.unit).value;
}

/// Of the variance; what counts for nothing has no digits.
QString shareText(double percent)
{
    constexpr double kLeastShown = 0.01;
    if (percent > 0.0 && percent < kLeastShown)
        return QStringLiteral("< ") + shownNumber(kLeastShown, 1) + QStringLiteral(" %");
    return shownFigures(percent, 2) + QStringLiteral(" %");
}

QString sensitivityText(const UncertaintyLine &line, const ReportedValue &reported)
{
    const InputWords words = inputWords(line.quantity);
    const QString c = shownQuantity(line.sensitivity, shownText(reported.unit), 3);
    if (words.in == CountedIn::Own && line.sensitivity == 1.0)
        return QStringLiteral("1");
    return words.unit.isEmpty() ? c : BudgetTable::tr("%1 per %2").arg(c, words.unit);
}

QString neededText(
    const UncertaintyLine &line, const ReportedValue &reported, const std::optional<WayToU> &way)
{
    if (!way || line.contribution == 0.0)
        return kNoValue;
    const auto input = std::ranges::find(way->inputs, line.quantity, &InputShare::quantity);
    if (input == way->inputs.end() || !input->factor)
        return BudgetTable::tr("not enough alone");
    return QStringLiteral("≤ ") + uText(*input->factor * line.u, line, reported);
}

QString nameOfLine(const UncertaintyLine &line, const TriedChanges &tried)
{
    const QString name = lineName(line);
    return tried.has(line) ? BudgetTable::tr("%1 (what if)").arg(name) : name;
}

QString expandedText(const Budget &budget)
{
    const auto U = budget.reported.expanded();
    return U ? relativeText(*U, budget) : kNoValue;
}

QString valueText(const Budget &budget)
{
    return shownResult(budget.reported.value, budget.reported.expanded().value_or(kUnknown),
        shownText(budget.reported.unit))
        .value;
}

QString largestText(const ReportedValue &reported)
{
    const auto order = byContribution(reported.lines);
    if (!reported.u || order.empty())
        return kNoValue;
    const UncertaintyLine &line = reported.lines[order.front()];
    return BudgetTable::tr("%1, %2").arg(lineName(line), shareText(reported.sharePercent(line)));
}

QStringList shotsRow(Index shots, const Budget &budget)
{
    const auto U = budget.reported.expanded();
    if (!U)
        return {QString::number(shots), kNoValue, kNoValue, kNoValue};
    return {QString::number(shots), shownQuantity(*U, shownText(budget.reported.unit), 2),
        relativeText(*U, budget), factorText(budget.reported)};
}

} // namespace

std::vector<std::size_t> byContribution(const std::vector<UncertaintyLine> &lines)
{
    std::vector<std::size_t> order(lines.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(
        order, std::greater(), [&](std::size_t i) { return std::abs(lines[i].contribution); });
    return order;
}

ShownTable budgetLines(
    const Budget &budget, const TriedChanges &tried, const std::optional<WayToU> &way)
{
    ShownTable table{
        {BudgetTable::tr("Input"), BudgetTable::tr("Value"), BudgetTable::tr("u"),
            BudgetTable::tr("Share"), BudgetTable::tr("Contribution"),
            BudgetTable::tr("Distribution"), BudgetTable::tr("Degrees of\nfreedom"),
            BudgetTable::tr("Sensitivity\ncoefficient"), BudgetTable::tr("u for the\nwanted U")},
        {}};
    const ReportedValue &reported = budget.reported;
    const QString unit = shownText(reported.unit);
    const double u = reported.u.value_or(kUnknown);
    for (const std::size_t i : byContribution(reported.lines)) {
        const UncertaintyLine &line = reported.lines[i];
        table.rows.push_back({nameOfLine(line, tried), estimateText(line),
            uText(line.u, line, reported), shareText(reported.sharePercent(line)),
            shownQuantityBeside(std::abs(line.contribution), u, unit, 2),
            distributionText(line.distribution), dofText(line.dof), sensitivityText(line, reported),
            neededText(line, reported, way)});
    }
    return table;
}

ShownTable allValues(const std::vector<Budget> &budgets, const std::vector<Budget> &tried,
    const std::vector<DrawnBudget> &drawn)
{
    ShownTable table{{BudgetTable::tr("Quantity"), BudgetTable::tr("Value"), BudgetTable::tr("U"),
                         BudgetTable::tr("U, what if"), BudgetTable::tr("k"),
                         BudgetTable::tr("Largest input"), BudgetTable::tr("Monte Carlo")},
        {}};
    for (std::size_t i = 0; i < budgets.size(); ++i) {
        const Budget &budget = budgets[i];
        table.rows.push_back({budgetName(budget), valueText(budget), expandedText(budget),
            i < tried.size() ? expandedText(tried[i]) : kNoValue,
            budget.reported.u ? factorText(budget.reported) : kNoValue,
            largestText(budget.reported),
            i < drawn.size() ? drawnCell(drawn[i], budget) : kNoValue});
    }
    return table;
}

ShownTable shotsTable(const Budget &budget)
{
    ShownTable table{{BudgetTable::tr("Shots"), BudgetTable::tr("U"),
                         BudgetTable::tr("U, relative"), BudgetTable::tr("k")},
        {}};
    Budget one = budget;
    for (const ReportedValue &reported : forShots(budget.reported, budget.shots)) {
        one.reported = reported;
        table.rows.push_back(shotsRow(table.rows.size() + 1, one));
    }
    return table;
}

} // namespace dyncal

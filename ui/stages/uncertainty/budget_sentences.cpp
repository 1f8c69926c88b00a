// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/budget_sentences.h"

#include "core/base/rounding.h"
#include "core/uncertainty/more_shots.h"
#include "ui/stages/uncertainty/budget_words.h"
#include "ui/text/core_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"
#include "ui/text/uncertainty_words.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <set>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct BudgetSentences
{
    Q_DECLARE_TR_FUNCTIONS(BudgetSentences)
};

constexpr Index kMostShotsTold = 20;
constexpr double kHardlyLess = 0.95; ///< of U: nobody shoots for that

QString percentText(double relative)
{
    return shownNumber(100.0 * relative, 3) + QStringLiteral(" %");
}

const UncertaintyLine &firstOf(const std::string &quantity, const ReportedValue &reported)
{
    return *std::ranges::find(reported.lines, quantity, &UncertaintyLine::quantity);
}

/// "T1: u ≤ 0.12 K", of those that are enough alone.
QStringList enoughAlone(const ReportedValue &reported, const WayToU &way)
{
    QStringList list;
    for (const InputShare &input : way.inputs) {
        if (!input.factor)
            continue;
        const UncertaintyLine &line = firstOf(input.quantity, reported);
        list << BudgetSentences::tr("%1, u ≤ %2")
                    .arg(inputWords(input.quantity).name,
                        uText(*input.factor * line.u, line, reported));
    }
    return list;
}

QString smallestSet(const WayToU &way)
{
    QStringList names;
    for (std::size_t i = 0; i < way.toRemove; ++i)
        names << inputWords(way.inputs[i].quantity).name;
    return names.join(QStringLiteral("; "));
}

std::set<Index> numbersOfShots(Index made)
{
    std::set<Index> numbers{1, made};
    for (const Index shots : {2 * made, 4 * made, kMostShotsTold})
        if (shots <= kMostShotsTold)
            numbers.insert(shots);
    return numbers;
}

QString uOf(ReportedValue reported, Budget budget)
{
    budget.reported = std::move(reported);
    const auto U = budget.reported.expanded();
    return U ? relativeText(*U, budget) : BudgetSentences::tr("not known");
}

} // namespace

QString resultSentence(const Budget &budget)
{
    const ReportedValue &reported = budget.reported;
    const QString unit = shownText(reported.unit);
    const auto U = reported.expanded();
    if (!U)
        return BudgetSentences::tr("%1 = %2; its uncertainty is not complete: %3.")
            .arg(budgetName(budget),
                shownResult(reported.value, kUnknown, unit, kDigitsWithoutUncertainty).value,
                translated(reported.missing));
    const ShownResult shown = shownResult(reported.value, *U, unit);
    const QString result = BudgetSentences::tr("%1 = %2, U = %3 (k = %4)")
                               .arg(budgetName(budget), shown.value, shown.u, factorText(reported));
    return budget.kind == BudgetOf::Phase
        ? result
        : BudgetSentences::tr("%1, %2 of it").arg(result, relativeText(*U, budget));
}

QString wantedSentence(
    const Budget &budget, const WantedU &wanted, const std::optional<WayToU> &way)
{
    if (!way)
        return BudgetSentences::tr("No relative U can be asked of this value.");
    const QString asked = percentText(wanted.relative);
    if (way->isReached)
        return BudgetSentences::tr("U of %1 is reached.").arg(asked);
    if (way->isBelowCapability)
        return BudgetSentences::tr(
            "U of %1 is less than the laboratory's least uncertainty (CMC); no input changes that.")
            .arg(asked);
    const QStringList alone = enoughAlone(budget.reported, *way);
    const QString first = alone.isEmpty()
        ? BudgetSentences::tr("For U of %1 no input alone is enough.").arg(asked)
        : BudgetSentences::tr("For U of %1 one of these is enough: %2.")
              .arg(asked, alone.join(QStringLiteral("; ")));
    if (!alone.isEmpty())
        return first;
    return first + QLatin1Char(' ')
        + BudgetSentences::tr("Known exactly, these together are: %1.").arg(smallestSet(*way));
}

QString shotsSentence(const Budget &budget)
{
    if (!budget.reported.u || budget.shots < 1)
        return {};
    const ReportedValue endless = withEndlessShots(budget.reported);
    if (*endless.expanded() > kHardlyLess * *budget.reported.expanded())
        return BudgetSentences::tr("More shots do not make it smaller: U is %1, never below %2.")
            .arg(uOf(budget.reported, budget), uOf(endless, budget));
    QStringList list;
    for (const Index shots : numbersOfShots(budget.shots))
        list << BudgetSentences::tr("%1: %2").arg(shots).arg(
            uOf(withShots(budget.reported, budget.shots, shots), budget));
    return BudgetSentences::tr("U by the number of shots: %1; never below %2.")
        .arg(list.join(QStringLiteral(", ")), uOf(endless, budget));
}

} // namespace dyncal

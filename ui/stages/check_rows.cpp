// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/check_rows.h"

#include "core/consistency/way_words.h"
#include "ui/text/core_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

struct CheckRows
{
    Q_DECLARE_TR_FUNCTIONS(CheckRows)
};

const QString kNone = QStringLiteral("–");

QString shotText(Index shot)
{
    return shot > 0 ? QString::number(shot) : CheckRows::tr("all");
}

QString verdict(const WayComparison &check)
{
    if (!check.isMade())
        return CheckRows::tr("not made");
    return check.agrees() ? CheckRows::tr("agree") : CheckRows::tr("contradict each other");
}

/// With the reason, where they could not be compared.
QString waysText(const WayComparison &check)
{
    const QString ways
        = CheckRows::tr("%1 / %2").arg(translated(wayText(check.a)), translated(wayText(check.b)));
    return check.isMade() ? ways : CheckRows::tr("%1: %2").arg(ways, translated(*check.missing));
}

/// To the digits of u, with the prefix of the second way: a row is read across.
ShownResult inRowsUnit(double value, const WayComparison &check)
{
    return shownResultBeside(value, check.u, check.value_b, shownText(check.unit));
}

QStringList rowOf(const WayComparison &check)
{
    QStringList row{
        translated(comparedText(check.of)), shotText(check.shot), verdict(check), waysText(check)};
    if (!check.isMade() || !std::isfinite(check.u)) {
        row << kNone << kNone << kNone << kNone << kNone;
    } else {
        row << inRowsUnit(check.value_a, check).value << inRowsUnit(check.value_b, check).value
            << shownFigures(check.difference() / check.u, 2)
            << shownQuantityBeside(
                   check.smallestDetectable(), check.value_b, shownText(check.unit), 2)
            << shownWithStandardU(inRowsUnit(check.difference(), check));
    }
    return row << (check.channel.empty() ? kNone : shownText(check.channel));
}

} // namespace

// What is read first stands first: a narrow window shows no more.
QStringList checkHeaders()
{
    return {CheckRows::tr("Quantity"), CheckRows::tr("Shot"), CheckRows::tr("Verdict"),
        CheckRows::tr("Two ways"), CheckRows::tr("First"), CheckRows::tr("Second"),
        CheckRows::tr("in u"), CheckRows::tr("Smallest fault seen"), CheckRows::tr("Difference"),
        CheckRows::tr("Place")};
}

QVector<QStringList> checkRows(const std::vector<WayComparison> &checks)
{
    // What contradicts comes first, what could not be made last.
    std::vector<const WayComparison *> sorted(checks.size());
    std::ranges::transform(
        checks, sorted.begin(), [](const WayComparison &check) { return &check; });
    std::ranges::stable_sort(sorted, {}, [](const WayComparison *check) {
        return !check->isMade() ? 2 : check->agrees() ? 1 : 0;
    });
    QVector<QStringList> rows;
    for (const WayComparison *check : sorted)
        rows << rowOf(*check);
    return rows;
}

QString checkSummary(const std::vector<WayComparison> &checks)
{
    const auto made = std::ranges::count_if(checks, &WayComparison::isMade);
    const auto against
        = std::ranges::count_if(checks, [](const WayComparison &check) { return !check.agrees(); });
    return CheckRows::tr("Comparisons made: %1; contradicting: %2; not possible: %3.")
        .arg(made)
        .arg(against)
        .arg(std::ssize(checks) - made);
}

} // namespace dyncal

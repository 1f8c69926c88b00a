// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/recheck_text.h"

#include "app/cli/columns_text.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Cells = std::vector<std::string>;

constexpr int kDigitsOfRatio = 3;

std::string nameOf(const QuantityPair &pair)
{
    return presentableInBrief(pair.where.empty() ? pair.of : pair.of + " (" + pair.where + ")");
}

std::string valueText(double value, double u, const std::string &unit)
{
    if (!std::isfinite(value))
        return "none";
    return roundedText(value, u, presentableInBrief(unit));
}

std::string expandedText(const QuantityDifference &difference)
{
    if (!std::isfinite(difference.U))
        return "none";
    return numberWithUnit(difference.U, presentableInBrief(difference.pair.unit), 2)
        + (difference.isKAssumed ? " (k = 2 assumed)" : "")
        + (difference.pair.isOfNoiseAlone ? " (of the noise alone)" : "");
}

std::string ratioText(const RecheckRow &row)
{
    switch (row.kind) {
    case RecheckKind::Withdrawn:
        return "withdrawn";
    case RecheckKind::UnitChanged:
        return "other unit";
    case RecheckKind::StatedNow:
        return "stated now";
    default:
        return numberText(row.difference->overU, kDigitsOfRatio);
    }
}

Cells cellsOf(const RecheckRow &row)
{
    const QuantityPair &pair = row.difference->pair;
    const bool isSameUnit = row.kind != RecheckKind::UnitChanged;
    return {ratioText(row), nameOf(pair), valueText(pair.issued, pair.u, pair.unit),
        isSameUnit ? valueText(pair.now, pair.u, pair.unit)
                   : valueText(pair.now, pair.uNow, pair.unitNow),
        expandedText(*row.difference), presentableInBrief(row.answer->folder)};
}

std::string tableOfQuantities(const std::vector<RecheckRow> &rows)
{
    std::vector<Cells> cells{{"over U", "quantity", "issued", "now", "U as issued", "folder"}};
    for (const RecheckRow &row : rows)
        if (row.difference)
            cells.push_back(cellsOf(row));
    return cells.size() > 1 ? columnsText(cells) + '\n' : std::string();
}

std::string verdictOf(const RecheckedRun &run)
{
    if (run.isNewlyBlocked())
        return "now blocked by " + presentable(run.blockedNow);
    const auto count = std::ranges::count_if(
        run.quantities.list, [](const auto &one) { return one.isOverU() || one.isGone(); });
    return count == 0 ? "none" : std::to_string(count) + " over U, withdrawn or in another unit";
}

bool isAllAsIssued(const QuantityDifferences &quantities)
{
    return std::ranges::none_of(quantities.list, [](const auto &one) { return one.overU > 0.0; });
}

std::string comparedText(const QuantityDifferences &quantities)
{
    std::string text = std::to_string(quantities.compared()) + " quantities with U, "
        + (isAllAsIssued(quantities) ? "all exactly as issued"
                                     : "the largest difference within U is "
                    + numberText(quantities.largestWithinU(), kDigitsOfRatio) + " U");
    if (quantities.withoutU > 0)
        text += "; " + std::to_string(quantities.withoutU)
            + " stated without an uncertainty, not compared";
    return text;
}

void addPoint(std::string &text, const std::string &head, const std::string &words)
{
    text += "  " + head + std::string(12 - head.size(), ' ') + presentable(words) + '\n';
}

void addFindingChanges(std::string &text, const FindingChanges &findings)
{
    for (const StatedFinding &one : findings.appeared)
        addPoint(text, "appeared", one.text());
    for (const StatedFinding &one : findings.gone)
        addPoint(text, "gone", one.text());
}

/// What the folder is, and what became of it.
std::string runText(const std::string &folder, const RecheckedRun &run)
{
    std::string text = presentable(folder) + ": " + verdictOf(run) + '\n';
    addPoint(text, "made", run.createdUtc + " by dyncal " + run.software);
    addPoint(text, "methods", run.methods.empty() ? "as now" : methodChangesText(run));
    addPoint(text, "compared", comparedText(run.quantities));
    if (!run.blockedThen.empty())
        addPoint(text, "blocked",
            run.blockedThen + (run.blockedNow.empty() ? " (then; not now)" : " (then and now)"));
    addFindingChanges(text, run.findings);
    for (const Message &remark : run.remarks)
        addPoint(text, "note", english(remark));
    return text;
}

} // namespace

std::string recheckText(const std::vector<RecheckAnswer> &answers)
{
    std::string text = tableOfQuantities(recheckRows(answers));
    for (const RecheckAnswer &answer : answers)
        if (answer.run)
            text += runText(answer.folder, *answer.run);
    return text;
}

} // namespace dyncal

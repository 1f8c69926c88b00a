// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/what_if.h"

#include "core/shock/shock_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

/// What is not known yet (`from` 0) has no proportion.
double changedU(const ChangedU &change, double u)
{
    return change.from > 0.0 && u != change.from ? u * (change.to / change.from) : change.to;
}

/// Without its place. The times of counters are stated as arrivals.
std::string withoutPlace(const std::string &quantity)
{
    const std::string key = quantity.substr(0, quantity.find('['));
    return key == "time_s" ? "arrival_s" : key;
}

void changeLine(const ChangedU &change, UncertaintyLine &line)
{
    if (!isMeant(change, line))
        return;
    line.u = changedU(change, line.u);
    line.contribution = line.sensitivity * line.u;
}

} // namespace

bool isMeant(const ChangedU &change, const UncertaintyLine &line)
{
    return line.quantity == change.quantity
        || (withoutPlace(line.quantity) == change.quantity && line.u == change.from);
}

ReportedValue withChanges(ReportedValue reported, const std::vector<ChangedU> &changes)
{
    if (!reported.u || changes.empty())
        return reported;
    for (const ChangedU &change : changes)
        for (UncertaintyLine &line : reported.lines)
            changeLine(change, line);
    combineLines(reported);
    return reported;
}

std::string budgetKeyOf(const UncertaintyLine &line, const std::vector<BudgetEntry> &budget)
{
    const auto &known = statedQuantities();
    if (std::ranges::find(known, line.quantity) != known.end())
        return line.quantity;
    const std::string key = withoutPlace(line.quantity);
    const auto found = std::ranges::find(budget, key, &BudgetEntry::quantity);
    return found != budget.end() && found->u == line.u ? key : std::string();
}

std::vector<BudgetEntry> withStated(
    std::vector<BudgetEntry> budget, const std::string &key, const UncertaintyLine &line, double to)
{
    if (key.empty())
        return budget;
    BudgetEntry entry{key, to, distributionName(line.distribution), {}};
    if (std::isfinite(line.dof) && line.dof > 0.0)
        entry.dof = line.dof;
    const auto found = std::ranges::find(budget, key, &BudgetEntry::quantity);
    if (found == budget.end()) {
        budget.push_back(std::move(entry));
        return budget;
    }
    entry.certificate = found->certificate;
    entry.due = found->due;
    *found = std::move(entry);
    return budget;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/uncertainty/tried_changes.h"

#include <algorithm>
#include <utility>

namespace dyncal {

namespace {

bool isIn(const UncertaintyLine &line, const std::vector<Budget> &budgets)
{
    const auto isSame = [&](const UncertaintyLine &other) {
        return other.quantity == line.quantity && other.u == line.u;
    };
    return std::ranges::any_of(budgets,
        [&](const Budget &budget) { return std::ranges::any_of(budget.reported.lines, isSame); });
}

} // namespace

void TriedChanges::set(const UncertaintyLine &line, double to)
{
    std::erase_if(
        m_trials, [&](const Trial &trial) { return trial.line.quantity == line.quantity; });
    if (to != line.u)
        m_trials.push_back({line, to});
}

bool TriedChanges::has(const std::string &quantity) const
{
    return std::ranges::any_of(
        m_trials, [&](const Trial &trial) { return trial.line.quantity == quantity; });
}

void TriedChanges::keepThoseOf(const std::vector<Budget> &budgets)
{
    std::erase_if(m_trials, [&](const Trial &trial) { return !isIn(trial.line, budgets); });
}

std::vector<ChangedU> TriedChanges::changes() const
{
    std::vector<ChangedU> changes;
    for (const Trial &trial : m_trials)
        changes.push_back({trial.line.quantity, trial.line.u, trial.to});
    return changes;
}

std::vector<Budget> TriedChanges::appliedTo(std::vector<Budget> budgets) const
{
    const std::vector<ChangedU> tried = changes();
    for (Budget &budget : budgets)
        budget.reported = withChanges(std::move(budget.reported), tried);
    return budgets;
}

std::vector<BudgetEntry> TriedChanges::stated(std::vector<BudgetEntry> budget) const
{
    for (const Trial &trial : m_trials)
        budget = withStated(std::move(budget), trial.line, trial.to);
    return budget;
}

std::vector<std::string> TriedChanges::notStatable() const
{
    std::vector<std::string> names;
    for (const Trial &trial : m_trials)
        if (budgetKeyOf(trial.line).empty())
            names.push_back(trial.line.quantity);
    return names;
}

} // namespace dyncal

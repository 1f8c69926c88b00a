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

ChangedU TriedChanges::Trial::change() const
{
    return {key.empty() ? line.quantity : key, line.u, to};
}

void TriedChanges::set(
    const UncertaintyLine &line, double to, const std::vector<BudgetEntry> &budget)
{
    const Trial next{line, to, budgetKeyOf(line, budget)};
    std::erase_if(m_trials, [&](const Trial &trial) {
        return trial.line.quantity == line.quantity || (!next.key.empty() && trial.key == next.key);
    });
    if (to != line.u)
        m_trials.push_back(next);
}

bool TriedChanges::has(const UncertaintyLine &line) const
{
    return std::ranges::any_of(m_trials, [&](const Trial &trial) {
        const ChangedU change = trial.change();
        return isMeant(change, line) || isMeant({change.quantity, change.to, change.to}, line);
    });
}

void TriedChanges::keepThoseOf(const std::vector<Budget> &budgets)
{
    std::erase_if(m_trials, [&](const Trial &trial) { return !isIn(trial.line, budgets); });
}

std::vector<ChangedU> TriedChanges::changes() const
{
    std::vector<ChangedU> changes;
    for (const Trial &trial : m_trials)
        changes.push_back(trial.change());
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
        budget = withStated(std::move(budget), trial.key, trial.line, trial.to);
    return budget;
}

std::vector<std::string> TriedChanges::notStatable() const
{
    std::vector<std::string> names;
    for (const Trial &trial : m_trials)
        if (trial.key.empty())
            names.push_back(trial.line.quantity);
    return names;
}

} // namespace dyncal

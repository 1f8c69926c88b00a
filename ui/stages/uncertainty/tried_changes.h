// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/budgets.h"
#include "core/uncertainty/what_if.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// The u that are tried on the page, none of which the recipe knows.
class TriedChanges
{
public:
    /// `line` as computed with this budget; its own u takes the trial back.
    void set(const UncertaintyLine &line, double to, const std::vector<BudgetEntry> &budget);
    void clear() { m_trials.clear(); }
    bool isEmpty() const { return m_trials.empty(); }
    bool has(const UncertaintyLine &line) const; ///< as computed, or as tried
    /// Drops those whose line is no longer as it was: a newer run, or they were taken over.
    void keepThoseOf(const std::vector<Budget> &budgets);

    std::vector<ChangedU> changes() const;
    std::vector<Budget> appliedTo(std::vector<Budget> budgets) const;
    /// A budget that states what it can of them, and what it cannot.
    std::vector<BudgetEntry> stated(std::vector<BudgetEntry> budget) const;
    std::vector<std::string> notStatable() const;

private:
    struct Trial
    {
        UncertaintyLine line;
        double to = 0.0;
        std::string key; ///< of the budget; empty: it cannot state it

        ChangedU change() const;
    };
    std::vector<Trial> m_trials;
};

} // namespace dyncal

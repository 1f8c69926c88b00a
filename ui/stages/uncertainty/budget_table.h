// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/budgets.h"
#include "core/uncertainty/wanted_u.h"
#include "ui/stages/frame/shown_table.h"
#include "ui/stages/uncertainty/drawn_words.h"
#include "ui/stages/uncertainty/tried_changes.h"

#include <vector>

namespace dyncal {

/// Positions of the lines, from the largest contribution down.
std::vector<std::size_t> byContribution(const std::vector<UncertaintyLine> &lines);

/// The column that has the share in percent.
inline constexpr int kShareColumn = 3;

/// The budget of one value as metrologists read it, in the order byContribution(). What is tried is
/// marked; the last column says with which u of this input alone the wanted U is reached.
ShownTable budgetLines(
    const Budget &budget, const TriedChanges &tried, const std::optional<WayToU> &way);

/// Every value with its U, as it is, by Monte Carlo and as tried (same order; `drawn` and `tried`
/// may be empty), and the input that contributes most.
ShownTable allValues(const std::vector<Budget> &budgets, const std::vector<Budget> &tried,
    const std::vector<DrawnBudget> &drawn = {});

/// U of a value by the number of shots.
ShownTable shotsTable(const Budget &budget);

} // namespace dyncal

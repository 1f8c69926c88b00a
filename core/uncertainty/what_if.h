// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/uncertainty_settings.h"
#include "core/uncertainty/reported_value.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// The u of an input as it is and as it might be. Every line of this name has the same input: lines
/// whose u is `from` get `to`, those that know it otherwise (another shot, another frequency)
/// change in proportion.
struct ChangedU
{
    std::string quantity; ///< of the line: "t1_k", "distance_m[Side 1]", "noise"
    double from = 0.0;
    double to = 0.0;

    bool operator==(const ChangedU &) const = default;
};

/// The value with these u in its lines; u, dof and k follow. Without a u it stays without.
ReportedValue withChanges(ReportedValue reported, const std::vector<ChangedU> &changes);

/// The key of `uncertainty.budget` that states the u of this line and nothing else; empty where the
/// budget cannot: what is computed ("noise"), has its own key ("attenuation_per_m") or belongs to
/// one of several sensors ("distance_m[Side 1]").
std::string budgetKeyOf(const UncertaintyLine &line);

/// The budget that states `to` for `line`, with its distribution and degrees of freedom; an entry
/// of this quantity is replaced. Unchanged where budgetKeyOf() is empty.
std::vector<BudgetEntry> withStated(
    std::vector<BudgetEntry> budget, const UncertaintyLine &line, double to);

} // namespace dyncal

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
/// change in proportion. A name without its place ("arrival_s") is what the budget states for all
/// places at once: the lines of every place that have `from` get `to`.
struct ChangedU
{
    std::string quantity; ///< of the line: "t1_k", "distance_m[Side 1]", "noise"
    double from = 0.0;
    double to = 0.0;

    bool operator==(const ChangedU &) const = default;
};

bool isMeant(const ChangedU &change, const UncertaintyLine &line);

/// The value with these u in its lines; u, dof and k follow. Without a u it stays without.
ReportedValue withChanges(ReportedValue reported, const std::vector<ChangedU> &changes);

/// The key of `uncertainty.budget` that states the u of this line: its name, or, where `budget`
/// states it for all places already ("arrival_s" of "arrival_s[Side 1]"), that. Empty where the
/// budget cannot: what is computed ("noise"), has a key of its own ("attenuation_per_m") or is
/// known from the sensor of one place.
std::string budgetKeyOf(const UncertaintyLine &line, const std::vector<BudgetEntry> &budget);

/// The budget that states `to` by `key`, with distribution and degrees of freedom of `line`; an
/// entry of this key is replaced and keeps its reference. Unchanged without a key.
std::vector<BudgetEntry> withStated(std::vector<BudgetEntry> budget, const std::string &key,
    const UncertaintyLine &line, double to);

} // namespace dyncal

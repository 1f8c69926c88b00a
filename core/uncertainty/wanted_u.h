// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/reported_value.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A U that is wanted, relative to the value.
struct WantedU
{
    double relative = 0.015;
    double k = kUsualFactor;
};

/// One input of a value: all lines of its name, as they change together.
struct InputShare
{
    std::string quantity;
    double contribution = 0.0; ///< root of the sum of squares of its lines
    /// By what its u has to be multiplied for U to be as wanted while all others stay (below 1: it
    /// must be known better; above 1: it may be known worse); empty where it alone is not enough.
    std::optional<double> factor = {};
};

/// What stands between a value and a wanted U.
struct WayToU
{
    double wanted_u = kUnknown; ///< k = 1, in the value's unit
    bool isReached = false;
    bool isBelowCapability = false; ///< less than the laboratory's CMC: no input is in the way
    std::vector<InputShare> inputs; ///< from the largest contribution down
    /// How many of the largest inputs have to be without any uncertainty for U to be as wanted: the
    /// smallest set that does it; 0 where it is reached.
    std::size_t toRemove = 0;
};

/// The line of the CMC is no input. Empty for a value without u, or of nothing (no relative U).
std::optional<WayToU> wayToU(const ReportedValue &reported, const WantedU &wanted);

} // namespace dyncal

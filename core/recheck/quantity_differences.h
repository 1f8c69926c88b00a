// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/recheck/stated_quantities.h"

#include <vector>

namespace dyncal {

/// What became of a stated quantity.
enum class QuantityFate {
    Withdrawn, ///< stated then, with U or without, not determined now
    Compared,
    StatedNow, ///< not determined then
};

struct QuantityDifference
{
    QuantityPair pair;
    QuantityFate fate = QuantityFate::Compared;
    double U = kUnknown; ///< as issued, expanded; NaN where none was stated
    double k = kUnknown; ///< that makes U of u
    bool isKAssumed = false; ///< the results state none
    double overU = kUnknown; ///< |now - issued|/U; NaN unless compared

    bool isOverU() const { return overU > 1.0; }
};

/// k of results that state none.
inline constexpr double kAssumedCoverage = 2.0;

struct QuantityDifferences
{
    std::vector<QuantityDifference> list; ///< withdrawn, compared with the worst first, stated now
    int withoutU = 0; ///< values stated without an uncertainty, which cannot be compared

    /// The largest of overU that is not above 1, 0 where nothing was compared.
    double largestWithinU() const;
    /// How many were compared.
    int compared() const;
};

/// U = k u as issued; differences of angles are those of the nearest turn. Quantities that are
/// determined neither then nor now are left out. Order among equals as in `pairs`.
QuantityDifferences quantityDifferences(const std::vector<QuantityPair> &pairs);

} // namespace dyncal

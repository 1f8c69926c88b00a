// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/recheck/stated_quantities.h"

#include <vector>

namespace dyncal {

/// What became of a stated quantity.
enum class QuantityFate {
    Withdrawn, ///< stated then, with U or without, not determined now
    UnitChanged, ///< stated now in another unit: the numbers cannot be compared
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
    double overU = kUnknown; ///< |now - issued|/U; NaN unless compared, infinite where U is 0

    bool isOverU() const { return overU > 1.0; }
    /// What was stated is no longer, or not as that.
    bool isGone() const
    {
        return fate == QuantityFate::Withdrawn || fate == QuantityFate::UnitChanged;
    }
};

/// k of results that state none.
inline constexpr double kAssumedCoverage = 2.0;

struct QuantityDifferences
{
    /// Withdrawn, in another unit, compared with the worst first, stated now.
    std::vector<QuantityDifference> list;
    int withoutU = 0; ///< values stated without an uncertainty, which cannot be compared

    /// The largest of overU that is not above 1, 0 where nothing was compared.
    double largestWithinU() const;
    /// How many were compared.
    int compared() const;
};

/// U = k u as issued; differences of angles are those of the nearest turn. Values that are stated
/// with u = 0 then and now are exact: any difference is over U. Quantities that are determined
/// neither then nor now are left out. Order among equals as in `pairs`.
QuantityDifferences quantityDifferences(const std::vector<QuantityPair> &pairs);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace dyncal {

/// A quantity that earlier results state, beside what it is now. NaN: null, or not there.
struct QuantityPair
{
    std::string of; ///< as `budget[].of` of the earlier results: "sensitivity", "shots[0].step_pa"
    std::string where; ///< for people: "shot 1", "10 kHz"; empty: there is only one
    std::string unit; ///< as issued; "1" = a number
    double issued = kUnknown;
    double u = kUnknown; ///< standard uncertainty as issued
    double k = kUnknown; ///< as issued; NaN where the results state none
    double now = kUnknown;
    bool isOfNoiseAlone = false; ///< u, of results from before the budget was complete
    bool isAngle = false; ///< a difference of whole turns is none
    double uNow = kUnknown; ///< standard uncertainty now
    std::string unitNow = {}; ///< of the value now; empty: not stated
};

/// Every quantity that `issued` has a place for a value and an uncertainty of, and characteristics
/// that only `now` has, in the order of the results: characteristics and the amplitudes of the
/// poles (of results without them the poles of the sensor and the bands, which had no u),
/// sensitivity with its levels, linearity and shots, the shock of each shot, the rows of S(f) and
/// of a comparison, with its difference from the step. They are matched by name, level, number of
/// the shot, and frequency (within 1e-9), poles by the nearest frequency. Both are results.json as
/// parseResults() reads it; what is missing gives no pair.
std::vector<QuantityPair> statedQuantities(const nlohmann::json &issued, const nlohmann::json &now);

} // namespace dyncal

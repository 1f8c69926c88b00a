// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_sum.h"

#include <vector>

namespace dyncal {

/// A step response taken apart into the sensor's own and what is slower than the sensor: heat of
/// the shocked gas, an AC coupling (docs/method/onset.md).
///
/// Pressure and chain before the sensor make h_0 + sum h_i e^(s_i t) of the step; the sensor, with
/// gain g(s) and g(0) = 1, answers with c_i = g(s_i) h_i at its poles and c_0 = h_0. So the level
/// of the step itself is L = c_0 + sum c_i / g(s_i).
struct OnsetLevel
{
    double value = 0.0; ///< L, in the unit of the response
    std::vector<double> slow; ///< h_i of the slow poles, in their order
    ExponentialSum
        sensor; ///< the sensor's answer to a step of 1 without them: 1 + sum a_k e^(s_k t)
};

/// `sum`: the response, time 0 at the onset; `isSlow`: one for each pole, real poles only. Without
/// slow poles L is c_0. L is 0 where no level can be found (the sensor's part answers nothing).
OnsetLevel onsetLevel(const ExponentialSum &sum, const std::vector<bool> &isSlow);

} // namespace dyncal

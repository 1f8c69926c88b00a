// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/model_inputs.h"

namespace dyncal::testing {

/// Response of a second-order sensor to a pressure that rises evenly over `front_s`, `t_s` from the
/// middle of the front on: the mean of its step response over the front, by Simpson's rule.
inline double rampResponse(double f0_Hz, double zeta, double front_s, double t_s)
{
    constexpr int kParts = 400;
    double sum = 0.0;
    for (int i = 0; i <= kParts; ++i) {
        const double weight = i == 0 || i == kParts ? 1.0 : i % 2 ? 4.0 : 2.0;
        sum += weight
            * secondOrderStep(f0_Hz, zeta, t_s + front_s * (static_cast<double>(i) / kParts - 0.5));
    }
    return sum / (3.0 * kParts);
}

} // namespace dyncal::testing

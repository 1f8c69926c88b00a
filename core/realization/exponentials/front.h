// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_sum.h"

#include <complex>

namespace dyncal {

/// How long the pressure rises at the DUT, known from elsewhere.
struct FrontDuration
{
    double duration_s = 0.0;
    double u_s = 0.0;
};

bool isFrontStated(const FrontDuration &front);

/// Longest rise of a front that nobody stated: a tilt of half a degree over 5.5 mm. Uncertainties
/// allow for it; a longer one is told.
inline constexpr double kUnstatedFront_s = 100e-9;

/// What a front that rises evenly over `duration_s` makes of e^(s t), t from its middle on:
/// sinh(s T/2)/(s T/2), sinc(f T) at s = jw (docs/method/front.md). 1 without a duration.
std::complex<double> frontFactor(double duration_s, std::complex<double> s);

/// Behind a front a response has the poles and the level of that to a sharp step at the front's
/// middle, and amplitudes larger by frontFactor(): the sum for the sharp step.
ExponentialSum asIfSharp(ExponentialSum behindFront, double duration_s);

} // namespace dyncal

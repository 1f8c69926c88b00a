// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace dyncal {

/// Where a record of a step is taken to end: after so many samples it stays at the mean of its own
/// last tenth.
struct TransformEnd
{
    Index samples = 0;
    Index averaged = 0; ///< of them, for the level
    double level = 0.0;
};

/// The record cut `cuts` times, evenly over its last third, and whole: the last one. Of an empty
/// record nothing but its end at 0.
std::vector<TransformEnd> transformEnds(const Eigen::Ref<const Eigen::VectorXd> &y, Index cuts);

/// Response at one frequency from a sampled step response, without any model
/// (docs/method/response.md): S(f) = D(f) [jwTs / (1 - e^(-jwTs))] e^(jw onset), D(f) = sum (y_n -
/// y_(n-1)) e^(-jwnTs). `y` starts at time 0 (y before it is 0) and stays at the level of its end;
/// the bracket turns the sampled unit step into the true one. Exact up to aliasing and truncation.
/// One value for each of `ends`, which lie within y, in ascending order.
std::vector<std::complex<double>> stepTransforms(const Eigen::Ref<const Eigen::VectorXd> &y,
    double rate_Hz, const std::vector<TransformEnd> &ends, double onset_s, double frequency_Hz);

/// Variance of Re S and of Im S from noise in y: `density` is that of the noise at the frequency,
/// `atZero` at low ones, both as the variance of white noise with that density. What the level
/// adds has a direction of its own in the plane and is counted in full.
double stepTransformVariance(
    const TransformEnd &end, double rate_Hz, double density, double atZero, double frequency_Hz);

/// Largest error that aliasing makes in S(f), relative to the largest |S| between 0.4 and 0.5 of
/// the rate, if the response is nowhere stronger above half the rate and falls there as 1/f or
/// faster: sum over m != 0 of (fs/2)/|f + m fs| f/|f + m fs| (docs/method/response.md).
double aliasShare(double rate_Hz, double frequency_Hz);

} // namespace dyncal

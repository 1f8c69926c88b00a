// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/resampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

/// Half length in output samples. Longer would sharpen the edge and lose more of the response,
/// because the model input starts a whole filter length behind the onset (README decision 11).
constexpr Index kHalfLength = 6;

/// Kaiser's beta for 70 dB: 0.1102 (A - 8.7).
constexpr double kBeta = 0.1102 * (70.0 - 8.7);

/// sin(pi x) / (pi x).
double sinc(double x)
{
    const double angle = std::numbers::pi * x;
    return angle == 0.0 ? 1.0 : std::sin(angle) / angle;
}

} // namespace

std::complex<double> AntiAliasFilter::gain(std::complex<double> s_rad_s) const
{
    std::complex<double> sum = taps[halfLength()];
    for (Index k = 1; k <= halfLength(); ++k)
        sum += 2.0 * taps[halfLength() + k]
            * std::cosh(s_rad_s * (static_cast<double>(k) / rate_Hz));
    return sum;
}

AntiAliasFilter designAntiAliasFilter(Index factor, double rate_Hz)
{
    eigen_assert(factor >= 1);
    if (factor == 1)
        return {1, Eigen::VectorXd::Ones(1), rate_Hz};
    const Index half = kHalfLength * factor;
    Eigen::VectorXd taps(2 * half + 1);
    for (Index k = 0; k <= half; ++k) {
        const double place = static_cast<double>(k) / static_cast<double>(half);
        const double weight = std::cyl_bessel_i(0.0, kBeta * std::sqrt(1.0 - place * place));
        const double tap = weight * sinc(static_cast<double>(k) / static_cast<double>(factor));
        taps[half + k] = tap;
        taps[half - k] = tap;
    }
    taps /= taps.sum();
    return {factor, std::move(taps), rate_Hz};
}

Eigen::VectorXd decimate(const Eigen::Ref<const Eigen::VectorXd> &values,
    const AntiAliasFilter &filter, Index first, Index count)
{
    const Index half = filter.halfLength();
    eigen_assert(count >= 0);
    eigen_assert(count == 0
        || (first >= half && first + (count - 1) * filter.factor + half < values.size()));
    if (filter.factor == 1)
        return values.segment(count > 0 ? first : 0, count);
    Eigen::VectorXd result(count);
    for (Index k = 0; k < count; ++k) {
        const Index centre = first + k * filter.factor;
        result[k] = filter.taps.dot(values.segment(centre - half, 2 * half + 1));
    }
    return result;
}

std::optional<Index> integerReduction(double from_Hz, double to_Hz)
{
    constexpr double kTolerance = 1e-9;
    constexpr double kLargest = 1e9; // beyond it the tolerance no longer tells integers apart
    const double ratio = from_Hz / to_Hz;
    if (!(from_Hz > 0.0) || !(to_Hz > 0.0) || !(ratio < kLargest))
        return std::nullopt;
    const double whole = std::round(ratio);
    if (whole < 1.0 || std::abs(ratio - whole) > kTolerance * whole)
        return std::nullopt;
    return static_cast<Index>(whole);
}

} // namespace dyncal

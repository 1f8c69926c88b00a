// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/resampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

/// Half length in output samples. A longer filter has a sharper edge but loses more of the
/// response, because all of it must lie after the onset (docs/adr/0008).
constexpr Index kHalfLength = 6;

/// Kaiser's beta for 70 dB: 0.1102 (A - 8.7).
constexpr double kBeta = 0.1102 * (70.0 - 8.7);

/// sin(pi x) / (pi x).
double sinc(double x)
{
    const double angle = std::numbers::pi * x;
    return angle == 0.0 ? 1.0 : std::sin(angle) / angle;
}

bool isWhole(double factor)
{
    return factor == std::round(factor);
}

/// The prototype at whole offsets from a point `beside` (-0.5..0.5) the centre; sum 1.
Eigen::VectorXd tapsAt(double factor, Index half, double beside)
{
    const double reach = static_cast<double>(kHalfLength) * factor;
    Eigen::VectorXd taps = Eigen::VectorXd::Zero(2 * half + 1);
    for (Index k = -half; k <= half; ++k) {
        const double offset = static_cast<double>(k) - beside;
        const double place = offset / reach;
        if (std::abs(place) > 1.0)
            continue;
        const double weight = std::cyl_bessel_i(0.0, kBeta * std::sqrt(1.0 - place * place));
        taps[half + k] = weight * sinc(offset / factor);
    }
    return taps / taps.sum();
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

std::complex<double> AntiAliasFilter::delayedGain(
    std::complex<double> s_rad_s, double delay_s) const
{
    std::complex<double> sum = 0.0;
    for (Index k = -halfLength(); k <= halfLength(); ++k)
        sum += taps[halfLength() + k]
            * std::exp(s_rad_s * (delay_s + static_cast<double>(k) / rate_Hz));
    return sum;
}

double antiAliasSpan_s(double factor, double rate_Hz)
{
    if (factor == 1.0)
        return 0.0;
    // Between the inputs the prototype reaches one sample further on one side.
    const double half
        = isWhole(factor) ? kHalfLength * factor : std::ceil(kHalfLength * factor) + 1.0;
    return 2.0 * half / rate_Hz;
}

AntiAliasFilter designAntiAliasFilter(double factor, double rate_Hz)
{
    eigen_assert(factor >= 1.0);
    if (factor == 1.0)
        return {1.0, Eigen::VectorXd::Ones(1), rate_Hz};
    const Index half = static_cast<Index>(std::llround(0.5 * antiAliasSpan_s(factor, 1.0)));
    return {factor, tapsAt(factor, half, 0.0), rate_Hz};
}

Eigen::VectorXd decimate(const Eigen::Ref<const Eigen::VectorXd> &values,
    const AntiAliasFilter &filter, Index first, Index count)
{
    const Index half = filter.halfLength();
    eigen_assert(count >= 0);
    eigen_assert(
        count == 0 || (first >= half && count <= outputCount(filter, first, values.size() - 1)));
    if (filter.factor == 1.0)
        return values.segment(count > 0 ? first : 0, count);
    const bool whole = isWhole(filter.factor);
    Eigen::VectorXd result(count);
    for (Index k = 0; k < count; ++k) {
        const double place = static_cast<double>(k) * filter.factor;
        const Index nearest = static_cast<Index>(std::llround(place));
        const auto around = values.segment(first + nearest - half, 2 * half + 1);
        const double beside = place - static_cast<double>(nearest);
        result[k]
            = whole ? filter.taps.dot(around) : tapsAt(filter.factor, half, beside).dot(around);
    }
    return result;
}

Index outputCount(const AntiAliasFilter &filter, Index first, Index last)
{
    const Index room = last - filter.halfLength() - first;
    if (room < 0)
        return 0;
    return static_cast<Index>(std::floor(static_cast<double>(room) / filter.factor + 1e-9)) + 1;
}

std::optional<double> reductionFactor(double from_Hz, double to_Hz)
{
    constexpr double kTolerance = 1e-9;
    constexpr double kLargest = 1e9; // beyond it every number is near a whole one
    const double ratio = from_Hz / to_Hz;
    if (!(from_Hz > 0.0) || !(to_Hz > 0.0) || !(ratio < kLargest))
        return std::nullopt;
    const double whole = std::round(ratio);
    const double factor = std::abs(ratio - whole) <= kTolerance * whole ? whole : ratio;
    return factor >= 1.0 ? std::optional<double>(factor) : std::nullopt;
}

} // namespace dyncal

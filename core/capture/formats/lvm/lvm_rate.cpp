// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/lvm/lvm_rate.h"

#include "core/capture/formats/bytes/time_axis.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// The mean of the X cells is preferred to Delta_X if it is finer by this factor.
constexpr double kClearlyFiner = 4.0;
/// Relative half digit of Delta_X up to which it is taken as it is.
constexpr double kEnoughDigits = 1e-5;

LvmRate rateOf(double step, double uncertainty, double meanStep)
{
    return {1.0 / step, uncertainty / step, false, meanStep};
}

} // namespace

LvmRate lvmRate(const LvmChannel &channel, std::span<const double> x, double resolution)
{
    const bool stated = channel.deltaX > 0.0;
    const double deltaHalf = 0.5 * channel.deltaResolution;
    const auto isThere = [](double value) { return std::isfinite(value); };
    if (x.size() < 2 || std::none_of(x.begin(), x.end(), isThere))
        return stated ? rateOf(channel.deltaX, deltaHalf, 0.0) : LvmRate();
    const TimeAxis axis = timeAxisOf(x, resolution);
    const double steps = static_cast<double>(x.size() - 1);
    const double mean = (x.back() - x.front()) / steps;
    const double meanHalf = resolution / steps; // half a digit at both ends
    const double step = stated ? channel.deltaX : axis.step;
    const double tolerance = std::max(kRateTolerance * step, deltaHalf) + 2.0 * meanHalf;
    const bool coarse = resolution > 0.5 * std::min(step, mean); // single steps say nothing
    const bool agrees = std::abs(mean - step) <= tolerance && (coarse || !axis.irregular);
    if (!agrees || (coarse && !stated))
        return {0.0, 0.0, true, mean};
    const bool enough = deltaHalf <= kEnoughDigits * channel.deltaX;
    if (stated && (coarse || enough || kClearlyFiner * meanHalf > deltaHalf))
        return rateOf(channel.deltaX, deltaHalf, mean);
    return rateOf(mean, meanHalf, mean);
}

} // namespace dyncal

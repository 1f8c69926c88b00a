// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/lvm_rate.h"

#include "core/capture/formats/time_axis.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kRateTolerance = 0.001; ///< as in CAP-003

} // namespace

LvmRate lvmRate(const LvmChannel &channel, std::span<const double> x, double resolution)
{
    LvmRate rate;
    rate.sampleRate_Hz = channel.deltaX > 0.0 ? 1.0 / channel.deltaX : 0.0;
    const auto isThere = [](double value) { return std::isfinite(value); };
    if (x.size() < 2 || std::none_of(x.begin(), x.end(), isThere))
        return rate;
    const TimeAxis axis = timeAxisOf(x, resolution);
    const double steps = static_cast<double>(x.size() - 1);
    rate.meanStep = (x.back() - x.front()) / steps;
    const double step = channel.deltaX > 0.0 ? channel.deltaX : axis.step;
    const double tolerance = kRateTolerance * step + 2.0 * resolution / steps;
    const bool coarse = resolution > 0.5 * step; // single steps say nothing
    const bool agrees = std::abs(rate.meanStep - step) <= tolerance && (coarse || !axis.irregular);
    if (agrees && channel.deltaX > 0.0)
        return rate;
    rate.contradicted = !agrees || coarse;
    rate.sampleRate_Hz = rate.contradicted ? 0.0 : 1.0 / axis.step;
    return rate;
}

} // namespace dyncal

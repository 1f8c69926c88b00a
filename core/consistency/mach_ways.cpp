// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/mach_ways.h"

#include "core/base/constants.h"
#include "core/shock/variable_shock.h"

#include <cmath>
#include <functional>

namespace dyncal {
namespace {

constexpr double kLowest = 1.001;
constexpr double kHighest = 8.0;
constexpr double kHighestTried = 3.0; ///< first: gases of variable heat capacity end early

std::optional<ShockStates> statesOf(const GasBefore &before, double mach)
{
    const double a1_m_s = soundSpeed_m_s(before.gas.constants, before.T1_K);
    const auto states = shockStatesOf(before.gas, before.p1_Pa, before.T1_K, mach * a1_m_s);
    return states ? std::optional(*states) : std::nullopt;
}

/// The root of a rising function by the Illinois rule; NaN values count as too large.
std::optional<double> rootOf(const std::function<double(double)> &f)
{
    double low = kLowest;
    double high = kHighestTried;
    double atLow = f(low);
    double atHigh = f(high);
    if (atHigh < 0.0)
        atHigh = f(high = kHighest);
    if (!(atLow <= 0.0) || !(atHigh >= 0.0))
        return std::nullopt;
    int side = 0;
    for (int i = 0; i < 100 && high - low > 1e-13 * high; ++i) {
        const double middle = (low * atHigh - high * atLow) / (atHigh - atLow);
        const double value = f(middle);
        if (!std::isfinite(value))
            return std::nullopt;
        if (std::abs(value) < 1e-14)
            return middle;
        if (value > 0.0) {
            high = middle;
            atHigh = value;
            atLow *= side == 1 ? 0.5 : 1.0;
            side = 1;
        } else {
            low = middle;
            atLow = value;
            atHigh *= side == -1 ? 0.5 : 1.0;
            side = -1;
        }
    }
    return 0.5 * (low + high);
}

} // namespace

std::optional<double> machOfStepRatio(const GasBefore &before, double ratio, double localFactor)
{
    return rootOf([&](double mach) {
        const auto wall = statesOf(before, mach);
        const auto local = statesOf(before, mach * localFactor);
        if (!wall || !local)
            return kUnknown;
        const double p2_Pa = local->shocked.pressure_Pa;
        return (wall->reflected.pressure_Pa - p2_Pa) / (p2_Pa - before.p1_Pa) - ratio;
    });
}

std::optional<double> machOfVelocityRatio(const GasBefore &before, double ratio)
{
    return rootOf([&](double mach) {
        const auto states = statesOf(before, mach);
        return states ? states->velocity_m_s / states->reflectedVelocity_m_s - ratio : kUnknown;
    });
}

} // namespace dyncal

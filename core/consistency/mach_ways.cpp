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

/// Where the function is not above 0, and where it is above it or has no value.
struct Bracket
{
    double low = kLowest;
    double high = kHighestTried;
    double atLow = kUnknown;
    double atHigh = kUnknown;
};

std::optional<Bracket> bracketOf(const std::function<double(double)> &f)
{
    Bracket b;
    b.atLow = f(b.low);
    b.atHigh = f(b.high);
    if (b.atHigh < 0.0)
        b.atHigh = f(b.high = kHighest);
    // The ratio of steps of a shock that gains speed on its way falls with M before it rises: near
    // the sensor the shock is no shock yet. The root on the rising part is that of the tube.
    constexpr double kStep = 0.7;
    for (double excess = kStep * (kHighestTried - 1.0);
         !(b.atLow <= 0.0) && excess >= kLowest - 1.0; excess *= kStep) {
        b.low = 1.0 + excess;
        b.atLow = f(b.low);
        if (b.atLow > 0.0) {
            b.high = b.low;
            b.atHigh = b.atLow;
        }
    }
    return b.atLow <= 0.0 && !(b.atHigh < 0.0) ? std::optional(b) : std::nullopt;
}

/// The root of a rising function by the Illinois rule; where it has no value it is too large, and
/// the interval is halved.
std::optional<double> rootOf(const std::function<double(double)> &f)
{
    auto bracket = bracketOf(f);
    if (!bracket)
        return std::nullopt;
    auto &[low, high, atLow, atHigh] = *bracket;
    int side = 0;
    for (int i = 0; i < 100 && high - low > 1e-13 * high; ++i) {
        const double middle = std::isfinite(atHigh)
            ? (low * atHigh - high * atLow) / (atHigh - atLow)
            : 0.5 * (low + high);
        const double value = f(middle);
        if (std::abs(value) < 1e-14)
            return middle;
        if (value < 0.0) {
            low = middle;
            atLow = value;
            atHigh *= side == -1 ? 0.5 : 1.0;
            side = -1;
        } else {
            high = middle;
            atHigh = value;
            atLow *= side == 1 ? 0.5 : 1.0;
            side = std::isfinite(value) ? 1 : 0;
        }
    }
    return std::isfinite(atHigh) ? std::optional(0.5 * (low + high)) : std::nullopt;
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

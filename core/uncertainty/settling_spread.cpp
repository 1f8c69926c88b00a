// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/settling_spread.h"

#include "core/base/constants.h"
#include "core/base/interval.h"
#include "core/model_analysis/model_characteristics.h"
#include "core/model_analysis/normalised_step.h"
#include "core/model_analysis/step_scan.h"
#include "core/uncertainty/model_noise.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dyncal {
namespace {

constexpr double kReach = 2.0; ///< in u: the interval of 95 %
constexpr double kPointsPerRadian = 20.0;

double deviationAt(const ExponentialSum &y, double t_s)
{
    return y.value(t_s) - 1.0;
}

/// Times between which the response stays on one side of 1, and its largest deviation there.
struct Swing
{
    double begin_s = 0.0;
    double top_s = 0.0;
    double end_s = 0.0;
};

/// From one passage through 1 on, to the next; empty where there is none while more than `least`
/// may be left. Passages are as exact as the spacing of the points: only their times' changes
/// count.
std::optional<Swing> swingFrom(const ExponentialSum &y, double begin_s, double least)
{
    const double step_s = 1.0 / (kPointsPerRadian * y.poles_rad_s.cwiseAbs().maxCoeff());
    Swing swing{begin_s, begin_s + step_s, 0.0};
    const bool isAbove = deviationAt(y, begin_s + step_s) > 0.0;
    double largest = 0.0;
    for (double t_s = begin_s + step_s; restAfter(y, t_s) > least; t_s += step_s) {
        const double now = deviationAt(y, t_s);
        if ((now > 0.0) != isAbove) {
            swing.end_s = t_s;
            return swing;
        }
        if (std::abs(now) > largest) {
            largest = std::abs(now);
            swing.top_s = t_s;
        }
    }
    return std::nullopt;
}

bool isRise(const Swing &swing)
{
    return swing.begin_s == 0.0;
}

/// The swing in which the response settles, and that after it with the largest deviation; the
/// second only where it swings on.
struct LastSwings
{
    Swing last;
    std::optional<Swing> next;
};

std::optional<LastSwings> lastSwings(const ExponentialSum &y, double settling_s)
{
    constexpr double kLeast = 0.2 * kSettledRange; // smaller ones are no noise away from leaving it
    std::optional<Swing> last = swingFrom(y, 0.0, kLeast);
    while (last && last->end_s <= settling_s)
        last = swingFrom(y, last->end_s, kLeast);
    if (!last)
        return std::nullopt;
    LastSwings swings{*last, {}};
    const auto sizeOf = [&](const Swing &swing) { return std::abs(deviationAt(y, swing.top_s)); };
    for (auto later = swingFrom(y, last->end_s, kLeast); later;
         later = swingFrom(y, later->end_s, kLeast))
        if (!swings.next || sizeOf(*later) > sizeOf(*swings.next))
            swings.next = later;
    return swings;
}

/// How the noise moves the deviation at one time.
double spreadAt(const std::vector<ModelVariation> &variations, double t_s)
{
    return spreadOver(
        variations, [=](const SensorModel &one) { return normalisedStep(one).value(t_s); });
}

/// Of the size of the deviation at one time; it turns at a top, so that a shift in time is none.
double relativeSpreadAt(
    const ExponentialSum &y, const std::vector<ModelVariation> &variations, double t_s)
{
    return spreadAt(variations, t_s) / std::abs(deviationAt(y, t_s));
}

/// Where the settling time may go if all deviations are e^(+-2 u) as large.
Interval reachOfSize(const SensorModel &model, ResponseTreatment treatment, double u_relative)
{
    const auto timeAt = [&](double factor) {
        return settlingTime_s(model, treatment, kSettledRange * factor).value_or(0.0);
    };
    const double size = std::exp(kReach * u_relative);
    return {timeAt(size), timeAt(1.0 / size)};
}

/// Relative u of the swings that decide: the last one, unless it is the rise, which begins at -1
/// whatever the model, and the largest one after it.
double spreadOfSizes(const ExponentialSum &y, const std::vector<ModelVariation> &variations,
    const LastSwings &swings)
{
    double u_relative = 0.0;
    if (!isRise(swings.last))
        u_relative = relativeSpreadAt(y, variations, swings.last.top_s);
    if (swings.next)
        u_relative = std::max(u_relative, relativeSpreadAt(y, variations, swings.next->top_s));
    return u_relative;
}

} // namespace

double settlingSpread_s(const SensorModel &model, const std::vector<ModelVariation> &variations,
    ResponseTreatment treatment, double derivative_s, double wider)
{
    const auto settling_s = settlingTime_s(model, treatment, kSettledRange);
    if (variations.empty() || !settling_s)
        return kUnknown;
    const ExponentialSum y = normalisedStep(model);
    const auto swings = lastSwings(y, *settling_s);
    if (!swings)
        return derivative_s;
    const Swing &last = swings->last;
    const Interval reach
        = reachOfSize(model, treatment, wider * spreadOfSizes(y, variations, *swings));
    if (reach.begin > last.begin_s && reach.end < last.end_s)
        return derivative_s;
    const double ofSize_s = std::max(reach.end - *settling_s, *settling_s - reach.begin) / kReach;
    const double ofTime_s = isRise(last)
        ? 0.0
        : spreadAt(variations, last.end_s) / std::abs(y.derivative(last.end_s, 1));
    return std::hypot(ofSize_s, wider * ofTime_s);
}

} // namespace dyncal

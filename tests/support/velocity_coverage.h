// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/portable_random.h"
#include "core/shock/shock_uncertainty.h"

#include <cmath>
#include <vector>

namespace dyncal {

/// How often the interval of +- k u around the estimated velocity holds the truth.
struct Coverage
{
    Index runs = 0;
    Index inside = 0;
    double percent() const
    {
        return 100.0 * static_cast<double>(inside) / static_cast<double>(runs);
    }
};

/// Shots whose sensors stand off their stated places and whose arrivals are read with an error,
/// both normal with the stated uncertainties (0.2 mm, 0.3 us), drawn anew in each run; velocity
/// 512.8 m/s. `stated` = the operator states u of the distances; otherwise the scatter is estimated
/// and k is Student's.
inline Coverage velocityCoverage(const std::vector<double> &distances_m, bool stated, Index runs)
{
    constexpr double kVelocity_m_s = 512.8;
    constexpr double kPlace_m = 2e-4;
    constexpr double kArrival_s = 3e-7;
    constexpr auto kResult = static_cast<Index>(StepResult::Velocity);
    Coverage coverage;
    for (Index run = 0; run < runs; ++run) {
        RandomStream random(20261121, run, 7);
        StepMeasurement m;
        m.state = {101100.0, 294.15, 0.0, 0.0};
        for (const double nominal_m : distances_m) {
            Sighting s;
            s.channel = "toa " + std::to_string(m.velocity.sightings.size());
            s.distance_m = nominal_m;
            s.u_distance_m = stated ? kPlace_m : 0.0;
            const double true_m = nominal_m + kPlace_m * random.nextNormal();
            s.time_s = 2e-3 - true_m / kVelocity_m_s + kArrival_s * random.nextNormal();
            s.u_time_s = kArrival_s;
            m.velocity.sightings.push_back(s);
        }
        auto fit = fitVelocity(m.velocity.sightings, Attenuation::Automatic);
        if (!fit)
            continue;
        m.velocity.velocity_m_s = fit->velocity_m_s;
        m.velocity.fit = std::move(*fit);
        const auto evaluated = evaluateStep(m, {});
        if (!evaluated)
            continue;
        const GumBudget &budget = evaluated->budget;
        const double half = coverageFactor(budget.dof[kResult], 0.95) * budget.u[kResult];
        ++coverage.runs;
        coverage.inside += std::abs(budget.value[kResult] - kVelocity_m_s) <= half ? 1 : 0;
    }
    return coverage;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/portable_random.h"
#include "core/shock/shock_uncertainty.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// How often the interval of +- k u around an estimate holds the truth.
struct Coverage
{
    Index runs = 0;
    Index inside = 0;
    double sumOfZ = 0.0; ///< error over u

    double percent() const
    {
        return 100.0 * static_cast<double>(inside) / static_cast<double>(runs);
    }
    double meanZ() const { return sumOfZ / static_cast<double>(runs); }
    void count(double error, double u, double dof)
    {
        ++runs;
        inside += std::abs(error) <= coverageFactor(dof, 0.95) * u ? 1 : 0;
        sumOfZ += error / u;
    }
};

/// Shots of 512.8 m/s at the wall; places, arrivals, p1 and T1 are off their stated values, normal
/// with the stated uncertainties, drawn anew in each run.
struct CoverageCase
{
    std::vector<double> distances_m; ///< 0: a sensor in the end wall, exactly there
    bool stated = true; ///< the operator states u of the distances; else the scatter is estimated
    std::optional<double> attenuation_per_m = 0.0; ///< empty: drawn from the usual range
    double rise_s = 0.0; ///< delays are drawn from 0 to 0.85 of it, and nobody knows them
    double u_place_m = 2e-4;
    double u_arrival_s = 3e-7;
};

struct StepCoverage
{
    Coverage velocity;
    Coverage step;
};

namespace coverage {

inline constexpr double kVelocity_m_s = 512.8;
inline constexpr SectionState kNoted{101100.0, 294.15, 0.0, 0.0};

/// Time from x to the wall for W(x) = W (1 + a x): the integral of dx/W(x).
inline double travel_s(double x_m, double a_per_m)
{
    return (a_per_m == 0.0 ? x_m : std::log1p(a_per_m * x_m) / a_per_m) / kVelocity_m_s;
}

inline StepMeasurement drawnShot(const CoverageCase &c, RandomStream &random)
{
    StepMeasurement m;
    m.state = kNoted;
    m.u_p1_Pa = 30.0;
    m.u_T1_K = 0.3;
    const Interval &range = kUsualAttenuation_per_m;
    const double a
        = c.attenuation_per_m.value_or(range.begin + range.length() * random.nextUniform());
    for (const double nominal_m : c.distances_m) {
        Sighting s;
        s.channel = "toa " + std::to_string(m.velocity.sightings.size());
        s.isDut = nominal_m == 0.0;
        s.distance_m = nominal_m;
        s.u_distance_m = c.stated && !s.isDut ? c.u_place_m : 0.0;
        const double true_m = nominal_m + (s.isDut ? 0.0 : c.u_place_m * random.nextNormal());
        s.u_time_s = s.isDut ? 1e-8 : c.u_arrival_s;
        s.u_delay_s = s.isDut ? 0.0 : 0.85 * c.rise_s / std::sqrt(12.0);
        const double late_s = s.isDut ? 0.0 : 0.85 * c.rise_s * (random.nextUniform() - 0.5);
        s.time_s = 2e-3 - travel_s(true_m, a) + late_s + s.u_time_s * random.nextNormal();
        m.velocity.sightings.push_back(s);
    }
    return m;
}

} // namespace coverage

inline StepCoverage stepCoverage(const CoverageCase &c, Index runs)
{
    constexpr auto kOfVelocity = static_cast<Index>(StepResult::Velocity);
    constexpr auto kOfStep = static_cast<Index>(StepResult::Step);
    StepCoverage result;
    for (Index run = 0; run < runs; ++run) {
        RandomStream random(20261121, run, 7);
        StepMeasurement m = coverage::drawnShot(c, random);
        auto fit = fitVelocity(m.velocity.sightings, Attenuation::Automatic);
        if (!fit)
            continue;
        m.velocity.velocity_m_s = fit->velocity_m_s;
        m.velocity.fit = std::move(*fit);
        const auto evaluated = evaluateStep(m, {});
        const double p1_Pa = m.state.pressure_Pa + m.u_p1_Pa * random.nextNormal();
        const double T1_K = m.state.temperature_K + m.u_T1_K * random.nextNormal();
        const auto truth = shockStates(Gas{}, p1_Pa, T1_K, coverage::kVelocity_m_s);
        if (!evaluated || !truth)
            continue;
        const GumBudget &budget = evaluated->budget;
        result.velocity.count(budget.value[kOfVelocity] - coverage::kVelocity_m_s,
            budget.u[kOfVelocity], budget.dof[kOfVelocity]);
        result.step.count(budget.value[kOfStep] - (truth->reflected.pressure_Pa - p1_Pa),
            budget.u[kOfStep], budget.dof[kOfStep]);
    }
    return result;
}

} // namespace dyncal

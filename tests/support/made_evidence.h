// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/consistency/fault_isolation.h"
#include "core/consistency/shot_ways.h"
#include "core/shock/shock_relations.h"

#include <memory>
#include <vector>

/// Shots whose ways agree exactly, as an ideal tube and recorder would give them, and what somebody
/// makes of them.
namespace dyncal::testing {

inline constexpr double kMadeVelocity_m_s = 512.8;
inline constexpr double kMadeSensitivity_V_Pa = 12.5e-9;
inline constexpr double kMadeP1_Pa = 101100.0;
inline constexpr double kMadeT1_K = 294.15;

/// What is true, and what is noted of it.
struct MadeShot
{
    double velocity_m_s = kMadeVelocity_m_s; ///< true, at the wall
    std::vector<double> places_m{0.8, 0.5};
    double trueT1_K = kMadeT1_K;
    double trueP1_Pa = kMadeP1_Pa;
    Gas gas{}; ///< true
    double timeFactor = 1.0; ///< noted over true times
    double distanceShift_m = 0.0; ///< of the first place, as noted
    double sideGain = 1.0; ///< what a side sensor reads over the truth
    double dutGain = 1.0; ///< likewise
    std::optional<double> typedVelocity_m_s = std::nullopt;
    std::optional<double> card = kMadeSensitivity_V_Pa;
};

inline Sighting madeSighting(const std::string &name, double x_m, double time_s, bool isDut)
{
    return {name, x_m, isDut ? 0.0 : 2e-4, time_s, 1e-7, isDut ? 0.0 : 3e-7, isDut};
}

inline ShotEvidence madeEvidence(const MadeShot &made, Index shot = 1)
{
    const ShockStates states
        = shockStates(made.gas, made.trueP1_Pa, made.trueT1_K, made.velocity_m_s).value();
    const double wall_s = 2e-3;
    const auto noted = [&](double time_s) { return made.timeFactor * time_s; };
    VelocityEstimate arrivals;
    ShotEvidence evidence;
    evidence.shot = shot;
    for (std::size_t i = 0; i < made.places_m.size(); ++i) {
        const double x = made.places_m[i];
        const std::string name = "side " + std::to_string(i + 1);
        arrivals.sightings.push_back(madeSighting(name, x + (i == 0 ? made.distanceShift_m : 0.0),
            noted(wall_s - x / made.velocity_m_s), false));
        SideArrival found;
        found.time_s = arrivals.sightings.back().time_s;
        found.behind = made.sideGain * (states.shocked.pressure_Pa - made.trueP1_Pa);
        found.back = ReturnPassage{noted(wall_s + x / states.reflectedVelocity_m_s), 1e-7,
            made.sideGain * (states.reflected.pressure_Pa - made.trueP1_Pa)};
        evidence.readings.push_back({name, false, found, 1.0, 0.01});
    }
    arrivals.sightings.push_back(madeSighting("DUT", 0.0, noted(wall_s), true));
    evidence.readings.push_back({"DUT", true, {}, {}, kUnknown});
    arrivals.fit = fitVelocity(arrivals.sightings, Attenuation::None).value();
    arrivals.velocity_m_s = arrivals.fit->velocity_m_s;
    StepMeasurement m;
    m.state = {kMadeP1_Pa, kMadeT1_K, 0.0, 0.0};
    m.u_p1_Pa = 30.0;
    m.u_T1_K = 0.3;
    if (made.typedVelocity_m_s) {
        m.velocity.velocity_m_s = made.typedVelocity_m_s;
        m.recorded = arrivals;
    } else {
        m.velocity = arrivals;
    }
    const double step_Pa = states.reflected.pressure_Pa - made.trueP1_Pa;
    const auto used = shockStates(Gas{}, kMadeP1_Pa, kMadeT1_K, *m.velocity.velocity_m_s).value();
    evidence.step_Pa = used.reflected.pressure_Pa - kMadeP1_Pa;
    evidence.sensitivity = made.dutGain * kMadeSensitivity_V_Pa * step_Pa / *evidence.step_Pa;
    evidence.uLevel_relative = 5e-4;
    evidence.sensitivityUnit = "V/Pa";
    if (made.card)
        evidence.card = SensorCard{*made.card, 0.005};
    evidence.measurement = std::move(m);
    return evidence;
}

/// A shot whose step is typed and whose velocity nobody knows: the card alone can be compared.
inline ShotEvidence madeOfTypedStep(double sensitivity_V_Pa, Index shot = 1)
{
    ShotEvidence evidence;
    evidence.shot = shot;
    evidence.step_Pa = evidence.typedStep_Pa = 4e5;
    evidence.sensitivity = sensitivity_V_Pa;
    evidence.uLevel_relative = 5e-4;
    evidence.sensitivityUnit = "V/Pa";
    evidence.card = SensorCard{kMadeSensitivity_V_Pa, 0.005};
    return evidence;
}

/// Owns everything that ComparedShots looks at.
struct MadeComparison
{
    explicit MadeComparison(const std::vector<MadeShot> &made)
    {
        for (const MadeShot &shot : made)
            evidence.push_back(std::make_unique<ShotEvidence>(
                madeEvidence(shot, static_cast<Index>(evidence.size()) + 1)));
        compare();
    }

    explicit MadeComparison(
        std::vector<ShotEvidence> made, std::vector<StatedUncertainty> statedBefore = {})
        : stated(std::move(statedBefore))
    {
        for (ShotEvidence &shot : made)
            evidence.push_back(std::make_unique<ShotEvidence>(std::move(shot)));
        compare();
    }

    void compare()
    {
        for (const auto &shot : evidence)
            ways.push_back(std::make_unique<ShotWays>(*shot, stated));
        compared = std::make_unique<ComparedShots>(ways);
    }

    std::vector<StatedUncertainty> stated;
    std::vector<std::unique_ptr<ShotEvidence>> evidence;
    std::vector<std::unique_ptr<ShotWays>> ways;
    std::unique_ptr<ComparedShots> compared;
};

} // namespace dyncal::testing

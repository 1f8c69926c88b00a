// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/shock/shock_settings.h"
#include "core/shock/side_arrival.h"
#include "core/shock/velocity_fit.h"

#include <optional>
#include <vector>

namespace dyncal {

inline constexpr const char *kEndWall = "end-wall";
inline constexpr const char *kSideWall = "side-wall";

/// When the DUT felt the shock: shot number and time on the record's axis.
struct DutArrival
{
    Index shot = 0;
    double time_s = 0.0;
    double u_time_s = 0.0; ///< 0 = not known
    bool delayCorrected = true; ///< false: a detected start, late by the sensor's own delay
};

/// Shock velocity of one shot, or why there is none.
struct VelocityEstimate
{
    std::optional<double> velocity_m_s;
    std::optional<double> arrival_s; ///< at the sensor farthest from the end wall, record axis
    double distance_m = 0.0; ///< of that sensor to the end wall
    double relativeDistanceUncertainty = 0.0; ///< what u(distance) alone does to the velocity
    std::vector<Sighting> sightings; ///< what the fit was made of, farthest first
    std::optional<VelocityFit> fit; ///< where the velocity was measured
    bool usesUncorrectedDut = false;
    std::optional<Mend> mend; ///< of the problem
    std::optional<Message> missing; ///< an input that is not there
    std::optional<Error> problem; ///< inputs that contradict each other
};

/// The typed velocity; else the straight line through where and when the shock was seen: the
/// arrival sensors (of the recipe; else the first driven-side channel at the tube's
/// "endflange_to_sensor2_m") and, for a DUT in the end wall, the DUT itself. Two places are
/// needed (fitVelocity()). Counters of the recipe come before all arrivals. A sensor's typed delay
/// is taken off its arrival; where none is typed, its rise time is the half width of what is
/// unknown.
VelocityEstimate estimateVelocity(const CaptureSet &set, const Shot &shot,
    const std::optional<DutArrival> &dutArrival, const ShockSettings &settings);

} // namespace dyncal

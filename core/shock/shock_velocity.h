// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/shock/shock_settings.h"
#include "core/shock/side_arrival.h"
#include "core/shock/velocity_fit.h"
#include "core/signal/record_starts.h"

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

/// What the record of one arrival sensor shows of one shot.
struct SeenArrival
{
    std::string channel; ///< as the sensor is called
    std::optional<SideArrival> found;
};

/// The sensors that mark the passing of the shock: the recipe's, or the one that follows from the
/// tube's description (the first driven-side channel, at "endflange_to_sensor2_m"). Their arrivals
/// are those typed for shot `shot` (from 1).
std::vector<ArrivalSensor> arrivalSensors(
    const CaptureSet &set, Index shot, const ShockSettings &settings);

/// Names (or roles) by which the recipe calls their channels.
std::vector<std::string> arrivalChannels(const ShockSettings &settings);

/// Reads the arrivals of shot `shot` (from 1) from the records. `dutStart_s`: when the DUT in the
/// end wall began to move (its detected or typed start; not the onset, so that the reading does not
/// depend on a model).
std::vector<SeenArrival> seenArrivals(const CaptureSet &set, Index shot,
    const ShockSettings &settings, const RecordStarts &starts,
    const std::optional<double> &dutStart_s);

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
    std::optional<Correction> correction; ///< of the problem
    std::optional<Message> missing; ///< an input that is not there
    std::optional<Error> problem; ///< inputs that contradict each other
};

/// The velocity typed for the shot; else that of the recipe's counters; else recordedVelocity().
VelocityEstimate estimateVelocity(const CaptureSet &set, Index shot,
    const std::optional<DutArrival> &dutArrival, const std::vector<SeenArrival> &seen,
    const ShockSettings &settings);

/// fitVelocity() through where and when the shock was seen: the arrivalSensors(), as far as `seen`
/// has them, and a DUT in the end wall. Two places are needed. A sensor's typed delay is taken off
/// its arrival; an unknown one lies anywhere between 0 and 0.85 of its rise time, so that the
/// middle is taken off.
VelocityEstimate recordedVelocity(const CaptureSet &set, Index shot,
    const std::optional<DutArrival> &dutArrival, const std::vector<SeenArrival> &seen,
    const ShockSettings &settings);

} // namespace dyncal

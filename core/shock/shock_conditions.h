// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/shock/gas_model.h"
#include "core/shock/measured_pressures.h"
#include "core/shock/shock_relations.h"
#include "core/shock/shock_uncertainty.h"
#include "core/shock/shock_velocity.h"
#include "core/shock/side_arrival.h"
#include "core/shock/tube_resonances.h"
#include "core/shock/tube_waves.h"
#include "core/shock/velocity_fit.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Reference pressure step of one shot and how it came about.
struct ShockConditions
{
    Index shot = 0;
    std::optional<ShockStates> states; ///< where a velocity was typed or measured
    std::optional<GasState> driver; ///< region 4, where T4 (and p4 or eq 3.10) is known
    std::optional<double> step_Pa; ///< empty = not determined
    bool stepTyped = false;
    std::optional<double> plateau_s;
    std::optional<double> arrival_s; ///< of the shock at the side sensor, record axis
    double distance_m = 0.0; ///< side sensor to end wall, where used

    std::optional<GasModel> drivenGas; ///< as used, with its source
    std::optional<GasModel> driverGas;
    std::optional<GasState> expandedDriver; ///< region 3
    std::vector<SeenArrival> seen; ///< what the records of the arrival sensors show
    std::vector<Sighting> sightings; ///< what the velocity was fitted to, farthest first
    std::optional<VelocityFit> velocityFit; ///< empty where the velocity was typed
    std::optional<StepUncertainty> uncertainty; ///< where it was asked for and can be computed
    /// The inputs of `uncertainty`; also where the state follows from a pressure, to compare the
    /// velocity of that with what the records say.
    std::optional<StepMeasurement> measurement;
    std::optional<Message> uncertaintyMissing; ///< why there is none
    std::vector<MeasuredPressure> measured; ///< read from the records, with predictions
    std::optional<PlateauEnd> plateauEnd; ///< what ends the plateau `plateau_s`
    std::optional<TubeDiagram> diagram; ///< where length and arrival at the wall are known
    std::vector<TubeResonance> resonances; ///< of the tube, not of the sensor
    std::optional<double> sideWallLimit_Hz; ///< -3 dB of a swept diaphragm in the side wall
};

/// A peak of the spectra followed from shot to shot, against the sound speed of region 5.
struct FollowedPeak
{
    std::vector<Index> shots;
    std::vector<PeakOfShot> peaks; ///< one per shot of `shots`
    SoundSpeedTest test;
    std::string
        candidate; ///< label of the nearest resonance of the tube in the first shot, or empty
};

struct ShockConditionsSet
{
    std::vector<ShockConditions> shots; ///< one per included shot, same order as the responses
    std::vector<FollowedPeak> followedPeaks; ///< SPC-005
    Findings findings;

    const ShockConditions *ofShot(Index shot) const;
};

} // namespace dyncal

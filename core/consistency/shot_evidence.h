// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/index.h"
#include "core/shock/shock_conditions.h"
#include "core/shock/side_arrival.h"
#include "core/shock/step_inputs.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// What a side sensor's record shows, in the order of StepMeasurement::arrivals()->sightings.
struct SideReading
{
    std::string channel;
    bool isDut = false;
    std::optional<SideArrival> found; ///< levels in the channel's unit
    std::optional<double> pascals; ///< per unit of the channel; empty: it reads no pressures
    double uGain_relative = kUnknown; ///< of that, as stated or assumed
    bool isDelayTyped = false;
};

/// The static or nominal sensitivity on the DUT's card, in the unit of the calibration's; 1 where
/// that is pressure over pressure.
struct SensorCard
{
    double sensitivity = 0.0;
    double u_relative = 0.0;
};

/// The driver pressure, recorded and as the shock implies it.
struct DriverEvidence
{
    double recorded_Pa = kUnknown;
    GasModel gas;
    double T4_K = kUnknown;
};

/// Everything that is known of one shot in more than one way.
struct ShotEvidence
{
    Index shot = 0;
    std::optional<StepMeasurement> measurement; ///< empty without a velocity
    Gas gas; ///< constants of the driven gas as used
    std::vector<SideReading> readings;
    std::optional<DriverEvidence> driver;
    bool stateFromDriver = false; ///< then p4 is no second way
    std::optional<double> typedStep_Pa;
    std::optional<double> step_Pa; ///< as used
    std::optional<double> sensitivity; ///< of this shot
    double uLevel_relative = kUnknown; ///< of the level that it is made of
    std::string sensitivityUnit;
    std::optional<SensorCard> card;
    std::string
        otherUnitOfCard; ///< what the card's sensitivity is in, if that contradicts the unit
};

// Where nothing is stated; docs/method/checks.md.
inline constexpr double kAssumedGain = 0.02; ///< of a side sensor
inline constexpr double kAssumedCard = 0.05;
inline constexpr double kStepRatioModel = 0.01; ///< linearity, levels that are not flat
inline constexpr double kVelocityRatioModel = 0.003; ///< reflected shock along the wall
inline constexpr double kDriverModel = kAssumedRelativeDriver;
// The part of these that is another one in every shot.
inline constexpr double kStepRatioOfShot = 0.003;
inline constexpr double kVelocityRatioOfShot = 0.001;
inline constexpr double kGainOfShot = 0.002;
inline constexpr double kDriverOfShot = 0.05;

} // namespace dyncal

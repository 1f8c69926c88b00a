// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/capture/capture_set.h"

#include <optional>
#include <string>

namespace dyncal {

/// The static or nominal sensitivity that a sensor's card states, per pascal.
struct CardSensitivity
{
    double value = 0.0; ///< not 0; the sign is the card's
    std::string unit; ///< "V/Pa"; "pC/Pa" where the unit above is none of siUnitOf()
    std::optional<double> u_relative; ///< standard uncertainty, where it is stated
};

/// "sensitivity", "sensitivity_unit" and "u_sensitivity" of a card: "mV/kPa" becomes V/Pa. Empty
/// where the number is missing or 0, or the unit is no ratio to a pressure.
std::optional<CardSensitivity> sensitivityOfCard(const Attributes &card);

/// u_sensitivity over sensitivity of a card whatever their unit; empty where either is missing.
std::optional<double> relativeUncertaintyOfCard(const Attributes &card);

/// The card of the channel's sensor; empty where there is none.
Attributes cardOf(const CaptureSet &set, const Channel &channel);

/// CAP-032: the sensitivity that the recipe states for the channel, in the channel's unit per
/// pascal, is farther from the card's than two standard uncertainties of the card (2 % where it
/// states none). Empty where they agree, or the card has none in that unit.
std::optional<Finding> typedAgainstCard(
    const Attributes &card, const Channel &channel, double typed);

/// CAP-031: the DUTs of the included shots are not one sensor, by the serial number (with maker and
/// model) of their cards, or by the sensor's id where there is none.
Findings checkOneSensor(const CaptureSet &set);

} // namespace dyncal

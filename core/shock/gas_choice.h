// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/propagation.h"
#include "core/capture/capture_set.h"
#include "core/shock/gas_model.h"
#include "core/shock/shock_settings.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Where a gas is known from; the first that says something wins.
enum class GasSource { Recipe, RecordedConstants, RecordedName, Assumed };

/// The relative humidity of a moist gas: as stated, or 0.5 with the rectangle from 0 to 1.
struct Humidity
{
    double value = 0.0;
    double u = 0.0; ///< standard uncertainty where none is stated in the budget
    Distribution distribution = Distribution::Normal;
};

/// One way to know a gas.
struct GasWay
{
    GasSource source = GasSource::Assumed;
    GasSettings settings; ///< substance never "auto"
    Humidity humidity; ///< counts for moist air only
};

/// The ways in which recipe and capture name the driven gas, in their order of rank: recipe (unless
/// "auto"), the capture's gamma1 and M1, the capture's driven_gas with its humidity; moist air
/// where none of these is there. Never empty.
std::vector<GasWay> waysToDrivenGas(
    const ShockSettings &settings, const CaptureSet &set, const Environment &around);

/// The driver gas likewise, from driver_gas, gamma4 and M4; dry air where nothing is known.
GasSettings chosenDriverGas(const ShockSettings &settings, const CaptureSet &set);

/// The substance that a capture's word names ("N2", "nitrogen", "air"); empty for an unknown one.
std::string recordedSubstance(const std::string &word);

/// Two ways whose speeds of sound at p1, T1 differ by more than 0.05 %.
struct GasContradiction
{
    GasWay used;
    GasWay other;
    double usedSpeed_m_s = 0.0;
    double otherSpeed_m_s = 0.0;
    GasModel otherModel;
    bool isHumidity = false; ///< both are air, so it is its humidity
    bool isTypedHumidity = false; ///< and the recipe's differs from the recorded one
};

/// The first recorded way that contradicts the one used; only what was typed or recorded counts.
std::optional<GasContradiction> gasContradiction(
    const std::vector<GasWay> &ways, const SectionState &state);

} // namespace dyncal

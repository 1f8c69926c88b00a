// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"
#include "core/shock/shock_conditions.h"

#include <vector>

namespace dyncal {

/// Flags the oscillating poles of a fitted model that lie within 3 % of where the gas of the tube
/// rings (kTubeModeFlag), and says so of those of class sensor (MOD-012): a caution where a peak of
/// the spectra moves with the sound speed of region 5 there, a note where a resonance of the tube
/// is only computed. Poles are shared by the shots, such modes are not: between the lowest and the
/// highest frequency of a mode every place is its own.
void judgeTubeModes(const std::vector<FollowedPeak> &peaks, const ShockConditionsSet &conditions,
    SensorModel &model);

} // namespace dyncal

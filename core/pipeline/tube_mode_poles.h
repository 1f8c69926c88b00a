// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/sensor_model.h"
#include "core/shock/shock_conditions.h"

#include <vector>

namespace dyncal {

/// Flags the oscillating poles of a fitted model within 3 % of a mode of the tube's gas
/// (kTubeModeFlag), and reports those of class sensor (MOD-012): a caution where a peak of the
/// spectra there moves with the sound speed of region 5, an info where a resonance of the tube is
/// only computed. The shots share poles but not such modes, so all frequencies between a mode's
/// lowest and highest count as the mode.
void judgeTubeModes(const std::vector<FollowedPeak> &peaks, const ShockConditionsSet &conditions,
    SensorModel &model);

} // namespace dyncal

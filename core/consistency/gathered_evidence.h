// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/consistency/shot_evidence.h"
#include "core/model_analysis/shot_sensitivity.h"
#include "core/shock/shock_settings.h"

namespace dyncal {

/// Puts together what is known of one shot. `sensitivity` may be null. The card's sensitivity
/// counts where its unit (sensitivity_unit, such as "mV/kPa") can be brought to that of the
/// calibration.
ShotEvidence gatherEvidence(const CaptureSet &set, const ShockSettings &settings,
    const ShockConditions &conditions, const ShotSensitivity *sensitivity);

} // namespace dyncal

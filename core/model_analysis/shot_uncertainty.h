// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/sensor_response.h"
#include "core/realization/model/sensor_model.h"
#include "core/shock/shock_conditions.h"

namespace dyncal {

/// Gives the sensitivity of one shot its standard uncertainty, that of the level with that of the
/// pressure step, which are independent, and its k for 95 % (Welch-Satterthwaite; few degrees of
/// freedom are those of the step). Nothing where the step is typed, or either u is not known.
void addUncertainty(const SeriesFit &fit, const ShockConditions &conditions, ShotSensitivity &shot);

} // namespace dyncal

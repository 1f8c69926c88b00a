// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/model_draft.h"

#include <vector>

namespace dyncal {

/// Finds the real poles that are slower than the sensor and no part of it (docs/method/onset.md),
/// and gives every series of the model the level of the step itself, with its uncertainty. A set of
/// poles is slow if each is at most a tenth as fast as every other that stands out, changes the
/// response over the model input by more than three times the uncertainty of that change, and is
/// not certainly more than 1.1 times the level, which the rest alone must reach. Needs the
/// refinement: without uncertainties nothing is found. `model` must have its poles and series; slow
/// poles change their class to Other.
void describeStepLevel(const ModelInput &input, const ModelDraft &draft,
    const std::vector<bool> &standsOut, SensorModel &model);

} // namespace dyncal

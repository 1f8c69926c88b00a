// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/model_draft.h"

namespace dyncal {

/// Fits the second-order sensor beside the model, started from its main resonance (or its slowest
/// real poles) and its shots' plateaus and onsets; fills in model.secondOrder. Only for treatments
/// in which the series are step responses with a plateau, and with settings.refine.
void fitSecondOrderBeside(const ModelInput &input, const ModelDraft &draft, SensorModel &model,
    const JobControl &control);

} // namespace dyncal

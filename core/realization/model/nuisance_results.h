// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/model_draft.h"

#include <vector>

namespace dyncal {

/// The modes taken out, as the draft has them, one entry per mode of the input. `fits` are those of
/// the draft's series.
std::vector<NuisanceResult> nuisanceResults(
    const ModelInput &input, const ModelDraft &draft, const std::vector<SeriesFit> &fits);

/// The input as it is without nuisance modes in the recipe: what the model is compared with.
ModelInput withModesLeftIn(const ModelInput &input);

/// What is compared of a model; `poles` are its own with their uncertainties.
NuisanceEffect::Side effectSide(
    const ModelInput &input, const SensorModel &model, const std::vector<Pole> &poles);

} // namespace dyncal

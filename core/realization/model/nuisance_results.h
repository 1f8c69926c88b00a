// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/model_draft.h"

#include <vector>

namespace dyncal {

/// The modes removed, from the draft, one entry per mode of the input. `fits` belong to the draft's
/// series.
std::vector<NuisanceResult> nuisanceResults(
    const ModelInput &input, const ModelDraft &draft, const std::vector<SeriesFit> &fits);

/// The input as it would be without nuisance modes in the recipe, for comparison.
ModelInput withModesLeftIn(const ModelInput &input);

/// The values of a model that are compared; `poles` are the model's, with uncertainties.
NuisanceEffect::Side effectSide(
    const ModelInput &input, const SensorModel &model, const std::vector<Pole> &poles);

} // namespace dyncal

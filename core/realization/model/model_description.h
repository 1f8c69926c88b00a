// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/model_draft.h"

#include <complex>
#include <optional>

namespace dyncal {

/// Poles, series and what is pooled over them, filled into the model; the pole of the step, where
/// there is one, comes last. Of the poles' uncertainties nothing is said. In thesis mode the model
/// must have its state space: the series are simulated with it.
void describeModel(const ModelInput &input, const ModelDraft &draft,
    std::optional<std::complex<double>> stepPole, SensorModel &model);

/// Uncertainties of the poles from the refinement's covariance, as if all shots shared them.
/// Nothing without a refinement.
void addUncertainties(const ModelDraft &draft, std::vector<Pole> &poles);

} // namespace dyncal

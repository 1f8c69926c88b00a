// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/realization/refinement/model_draft.h"

#include <complex>
#include <optional>

namespace dyncal {

/// Fills poles, series and pooled values into the model; the step's pole, if any, comes last.
/// Uncertainties of the poles stay unknown. In thesis mode the model must have its state space
/// already, because the series are simulated with it.
void describeModel(const ModelInput &input, const ModelDraft &draft,
    std::optional<std::complex<double>> stepPole, SensorModel &model);

/// Plateau, level, amplitudes and the sensor's own step of the model as means over its series, each
/// weighted by its signal to noise squared; they must be empty before. Part of describeModel().
void poolShapes(const ModelInput &input, SensorModel &model);

/// Uncertainties of the poles from the refinement's covariance, as if all shots shared them.
/// Nothing without a refinement.
void addUncertainties(const ModelDraft &draft, std::vector<Pole> &poles);

} // namespace dyncal

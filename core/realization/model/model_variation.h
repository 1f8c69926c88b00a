// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"

#include <vector>

namespace dyncal {

/// A refined model moved up and down along one direction of its parameters' covariance. Of the
/// models only poles, amplitudes, plateau, level and the sensor's own step are filled in.
struct ModelVariation
{
    SensorModel up;
    SensorModel down;
};

/// So far, in standard deviations, is each moved.
inline constexpr double kVariation = 0.1;

/// The covariance V of the refinement's parameters is L L^T, one column of L for each independent
/// direction (eigenvectors of the correlation matrix). The variance of any f of the model is, to
/// first order (GUM 5.2.2),
///     sum over the directions of ((f(up) - f(down)) / (2 kVariation))^2.
/// Onsets move with the parameters; which poles are a drift stays as decided. Nothing for models
/// that were not refined, that diverge, and for treatments without a step.
std::vector<ModelVariation> modelVariations(const ModelInput &input, const SensorModel &model);

} // namespace dyncal

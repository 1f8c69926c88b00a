// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/uncertain_value.h"
#include "core/realization/model/model_assessment.h"
#include "core/realization/model/model_variation.h"

#include <functional>
#include <vector>

namespace dyncal {

/// Standard uncertainty that the noise gives a value of the model: over the independent directions
/// of its parameters' covariance (ModelVariation). Unknown without directions.
double spreadOver(const std::vector<ModelVariation> &variations,
    const std::function<double(const SensorModel &)> &valueOf);

/// By how much the assessed u of frequency and damping are wider than what the noise gives (`u_Hz`,
/// `u_zeta`), as where the shots' scatter stands for it; at least 1, and 1 where nothing is known.
double widening(double assessed_Hz, double u_Hz, double assessedZeta, double u_zeta);

/// The line "noise" of a value of the model. Where the shots' scatter stands for the noise, their
/// number is what u rests on.
UncertaintyLine modelNoiseLine(
    double u, const SensorModel &model, const ModelAssessment &assessment);

} // namespace dyncal

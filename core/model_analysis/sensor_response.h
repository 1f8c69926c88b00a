// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/base/result.h"
#include "core/model_analysis/model_characteristics.h"
#include "core/model_analysis/model_curves.h"
#include "core/model_analysis/response_settings.h"
#include "core/realization/input/model_input.h"
#include "core/realization/model/sensor_model.h"
#include "core/shock/shock_conditions.h"
#include "core/signal/response_window.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Sensitivity of one shot: the level of its step, at the onset, over the pressure step.
struct ShotSensitivity
{
    Index shot = 0;
    std::optional<double> sensitivity; ///< empty = not determined (no pressure step)
    std::string unit; ///< "V/Pa"
    double u_sensitivity = kUnknown; ///< of level and step together
    double k_sensitivity = kUnknown; ///< for 95 %, by the effective degrees of freedom
};

/// What the response of one shot does behind its step, from the level at the onset to the settle
/// band: of a model with slow poles.
struct ShotDrift
{
    Index shot = 0;
    double tau_s = kUnknown; ///< of the slowest part; negative where it grows
    double relative = 0.0; ///< settled level over level at the onset - 1
    double u = kUnknown; ///< of `relative`
    double at_s = 0.0; ///< middle of the settle band, after the onset
};

struct ResponseResult
{
    Eigen::VectorXd frequency_Hz; ///< by the recipe; a grid lies inside the usable band
    Eigen::VectorXd magnitude; ///< non-parametric, docs/method/response.md; empty for impulse
    Eigen::VectorXd u_magnitude;
    Eigen::VectorXd phase_rad;
    Eigen::VectorXd u_phase_rad;
    Eigen::VectorXd modelMagnitude;
    Eigen::VectorXd modelPhase_rad;
    double fLow_Hz = 0.0; ///< 1 / shortest window
    double fHigh_Hz = 0.0; ///< where the noise exceeds 10 % of the magnitude, or 0.4 rate
    std::string unit; ///< "V/Pa" with a pressure step, "1" without
    StepCharacteristics characteristics;
    std::vector<ShotSensitivity> shots;
    std::vector<ShotDrift> drift; ///< empty where nothing drifts
    std::optional<double> sensitivity; ///< mean over the shots
    std::string sensitivityUnit;
    ResponseCurve modelCurve; ///< for plots: 600 points over the band and past it
    Findings findings;
};

Result<ResponseResult> computeResponse(const std::vector<WindowedResponse> &responses,
    const ModelInput &input, const SensorModel &model, const ShockConditionsSet &shock,
    const ResponseSettings &settings);

/// The part of computeResponse() that needs the model only and is quick: curve, unit and
/// sensitivities. The caller gives the band; nothing is taken from the records.
ResponseResult computeModelResponse(const std::vector<WindowedResponse> &responses,
    const ModelInput &input, const SensorModel &model, const ShockConditionsSet &shock,
    const ResponseSettings &settings, double from_Hz, double to_Hz);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/monte_carlo/source_draws.h"
#include "core/shock/shock_conditions.h"
#include "core/uncertainty/uncertainty_report.h"

#include <functional>
#include <optional>
#include <vector>

namespace dyncal {

/// What a calibration has found, and what is known of its inputs; all must outlive their use.
struct ChainSubject
{
    const ModelInput &input;
    const SensorModel &model;
    const ModelAssessment &assessment;
    const ResponseResult &response;
    const ShockConditionsSet &shock; ///< the steps used
    const UncertaintyReport &report;
    const std::vector<StatedUncertainty> &stated;
};

/// One shot's sensitivity as a function of its inputs: level (1 + e) over the pressure step.
struct ShotChain
{
    Index shot = 0;
    ShotLevel level = ShotLevel::None;
    double sensitivity = kUnknown;
    double step_Pa = kUnknown; ///< as used
    std::vector<DrawnInput> ofStep;
    std::function<Result<double>(const Eigen::VectorXd &)> stepAt_Pa; ///< of values of ofStep
    DrawnInput ofLevel; ///< relative, of its noise
};

/// A factor 1 + x of every sensitivity, or where it divides 1/(1 + x).
struct ChainFactor
{
    DrawnInput x;
    bool divides = false;
    bool ofLevelsOnly = false; ///< no row and no value of the model has it
};

/// Scatter of the shots about their mean, which takes the place of their own inputs.
struct ShotScatter
{
    std::vector<std::size_t> of; ///< shots of the mean, positions
    std::optional<DrawnInput> scatter; ///< empty: the shots agree
};

/// Every input that a calibration's values depend on, each with its distribution, as the budget
/// has it; none of the budget's sensitivities.
struct ChainInputs
{
    SourceDraws sources;
    std::vector<ShotChain> shots; ///< empty where a shot's step or level has no u
    std::vector<ShotScatter> means; ///< of all shots, then of each level
    std::vector<DrawnInput>
        levels; ///< of a response relative to the level at the onset; else empty
    std::vector<ChainFactor> factors;
    DrawnInput clock; ///< relative, of frequencies and times
    DrawnInput front; ///< its duration, s
    DrawnInput mounting; ///< one of the factors, which changes the model's shape, too
    DrawnInput drift; ///< error of a drift that was divided out, in its u
    Index weakMode = 0; ///< the source that decides whether a weak mode is the sensor's
};

ChainInputs chainInputs(const ChainSubject &subject);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/model/model_assessing.h"
#include "core/realization/model/model_fit.h"

#include <utility>

namespace dyncal::testing {

/// A model with its assessment, by the two calls that the pipeline's stages make.
struct RealizedModel
{
    SensorModel model;
    ModelAssessment assessment;

    const Pole *main() const { return mainPole(model, &assessment); }
};

inline Result<RealizedModel> realizeModel(const ModelInput &input,
    const HankelDecomposition &decomposition, Index order, const RealizationSettings &settings = {},
    const JobControl &control = {})
{
    Result<SensorModel> model = fitModel(input, decomposition, order, settings, {}, control);
    if (!model)
        return tl::unexpected(std::move(model.error()));
    Result<ModelAssessment> assessment = assessModel(input, *model, settings, control);
    if (!assessment)
        return tl::unexpected(std::move(assessment.error()));
    return RealizedModel{std::move(*model), std::move(*assessment)};
}

} // namespace dyncal::testing

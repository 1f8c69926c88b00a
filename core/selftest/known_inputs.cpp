// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/known_inputs.h"

#include "core/realization/model/model_fit.h"

namespace dyncal {

ModelInput inputOf(const Eigen::VectorXd &y, ResponseTreatment treatment)
{
    ModelSeries series;
    series.shot = 1;
    series.y = series.fullRate = y;
    series.filter = {1.0, Eigen::VectorXd::Ones(1), kModelRate_Hz};
    series.fullRate_Hz = kModelRate_Hz;
    ModelInput input;
    input.treatment = treatment;
    input.combine = CombineMethod::PcaAverage;
    input.sampleRate_Hz = kModelRate_Hz;
    input.samples = y.size();
    input.series = {series};
    return input;
}

std::optional<HankelDecomposition> decomposed(const ModelInput &input)
{
    auto hankel = decomposeHankel(input, {});
    return hankel ? std::optional(std::move(*hankel)) : std::nullopt;
}

std::optional<SensorModel> modelOf(const ModelInput &input)
{
    const auto hankel = decomposed(input);
    if (!hankel)
        return std::nullopt;
    auto model = fitModel(input, *hankel, 2, {}, {});
    return model ? std::optional(std::move(*model)) : std::nullopt;
}

} // namespace dyncal

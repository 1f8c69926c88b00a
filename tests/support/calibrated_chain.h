// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/monte_carlo/chain_inputs.h"
#include "core/pipeline/pipeline.h"
#include "core/realization/model/model_fit.h"
#include "core/shock/shock_uncertainty.h"
#include "tests/support/simulated_example.h"

#include <memory>
#include <vector>

namespace dyncal::testing {

/// The simulated example with its budget, and as the subject of a Monte Carlo.
struct CalibratedChain
{
    Recipe recipe;
    CalibrationResults results;
    std::vector<StatedUncertainty> stated;

    explicit CalibratedChain(const Recipe &used = {},
        const std::shared_ptr<const CaptureSet> &set = simulatedExample(2e7))
        : recipe(used)
        , stated(uncertaintyRequest(used.uncertainty).stated)
    {
        ResultCache cache;
        results = runPipeline(set, recipe, cache, StageId::Uncertainty).results;
    }

    ChainSubject subject() const
    {
        return {*results.input, *results.model, *results.assessment, *results.response,
            *results.shock, *results.uncertainty, stated};
    }

    Result<SensorModel> fitAgain(const ModelInput &input, const JobControl &control) const
    {
        return fitModel(input, results.decomposition->hankel, results.model->order,
            recipe.realization, *results.spectrum, control);
    }
};

} // namespace dyncal::testing

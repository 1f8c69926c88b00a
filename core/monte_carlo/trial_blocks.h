// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/monte_carlo/chain_inputs.h"
#include "core/uncertainty/characteristic_values.h"
#include "core/uncertainty/reported_value.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace dyncal {

/// A quantity that trials recompute: a mean, a shot's, or a value of the model.
struct TrialQuantity
{
    std::string of; ///< as in `budget` of results.json: "sensitivity", "f0_hz"
    ReportedValue reported; ///< has a u
    Index mean = -1; ///< position in ChainInputs::means
    Index shot = -1; ///< in ChainInputs::shots
    double CharacteristicValues::*ofModel = nullptr;
};

/// What trials make of the whole chain.
struct TrialPlan
{
    ChainSubject subject;
    ChainInputs inputs;
    std::vector<TrialQuantity> quantities;
    std::uint64_t seed = 1;
};

/// All quantities of the report that have a u and can be drawn: mean sensitivity, levels, shots,
/// the model's values. Those of the model only of a step (ModelDraws::canDraw()).
TrialPlan trialPlan(const ChainSubject &subject, std::uint64_t seed);

/// Results of the trials `begin` to `begin` + count - 1; trials are numbered from 0.
struct TrialBlock
{
    Index begin = 0;
    Eigen::MatrixXd values; ///< a row for each trial, a column for each quantity; NaN where it
                            ///< does not exist
    Eigen::VectorXd common; ///< factor of all rows of S(f)
    Eigen::VectorXd front_s; ///< duration of the front
    Eigen::VectorXd drift; ///< deviate of the drift that was divided out

    Index count() const { return values.rows(); }
};

/// A trial depends on the plan and its number alone: any split into blocks, on any number of
/// threads, has the same bytes. Fails when stopped, within some 250 trials.
Result<TrialBlock> runTrials(
    const TrialPlan &plan, Index begin, Index count, const JobControl &control = {});

/// The blocks as one. Fails (Usage) where they do not follow each other, or are of other plans.
Result<TrialBlock> mergedBlocks(const std::vector<TrialBlock> &blocks);

} // namespace dyncal

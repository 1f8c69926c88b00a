// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/monte_carlo/chain_inputs.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dyncal {

/// Fits a model to records, as the calibration's own was fitted: the same order, rules and start.
using FitAgain = std::function<Result<SensorModel>(const ModelInput &, const JobControl &)>;

/// One value of the model over full refits and over draws of the parameters.
struct RefittedValue
{
    std::string of; ///< "f0_hz", ...
    double u_refits = kUnknown; ///< standard deviation over the refits
    double u_draws = kUnknown; ///< over the draws, by the noise alone
    double shift = kUnknown; ///< mean of the refits less that of the draws
    bool agrees = false; ///< both within what so many refits leave open
};

/// Full refits as a check of the draws in the space of the parameters.
struct RefitCheck
{
    Index refits = 0;
    Index failed = 0; ///< of them, without a model of all values
    std::vector<RefittedValue> values;

    bool agrees() const; ///< none failed, and every value agrees
};

/// Records are made as the fitted model would give them, with noise of the autoregressive models
/// that the covariance rests on (Refinement), and fitted again; values of the refits are compared
/// with those of 1000 draws. Agreement: the variances' ratio times n - 1 lies within chi square of
/// n - 1, the shift within the normal distribution of u/sqrt(n), each at 0.1 % over the number of
/// values. One refit for 200 trials, at most 50, fewer (at least 10) where the records are long:
/// some 5 million samples in all. None for fewer than 2000 trials, nor where ModelDraws::canDraw()
/// is false. Fails when stopped.
Result<RefitCheck> fullRefits(const ChainSubject &subject, const ChainInputs &inputs,
    const FitAgain &fitAgain, Index trials, std::uint64_t seed, const JobControl &control = {});

} // namespace dyncal

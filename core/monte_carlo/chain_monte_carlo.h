// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/monte_carlo/full_refits.h"
#include "core/monte_carlo/row_draws.h"
#include "core/monte_carlo/trial_blocks.h"
#include "core/shock/uncertainty_settings.h"

#include <string>
#include <vector>

namespace dyncal {

/// How many values and rows (magnitude and phase each) both propagations have, and for how many
/// they agree.
struct ValidatedCount
{
    Index compared = 0;
    Index validated = 0;
};

/// Monte Carlo of the whole chain (JCGM 101, 102), a second propagation beside that of the budget:
/// from the same inputs, by the functions themselves. Only ever of the whole number of trials.
struct ChainMonteCarlo
{
    Index trials = 0; ///< 0: no value has a u, nothing was drawn
    Index seed = 1;
    double coverage = 0.95;
    bool isAdaptive = false;
    bool isStable = false; ///< adaptive: two digits of every u stood before the last trial
    std::vector<DrawnValue> values;
    std::vector<DrawnRow> rows; ///< of ResponseResult
    std::vector<DrawnRow> rowsAtMarks; ///< of ResponseResult::atMarks
    RefitCheck refits;
    Findings findings; ///< UNC-003, UNC-006

    ValidatedCount count() const;
    bool isValidated() const; ///< all values and rows are, and there are some
    const DrawnValue *find(const std::string &of) const; ///< null without it
};

/// Trials as the recipe asks for; adaptive: batches of 10000 until two digits of u of every value
/// are stable (JCGM 101, 7.9), at most 200000. `subject.report` is that of the budget. `fitAgain`
/// makes the refits that check the draws; null: there are none. Fails (Usage) on settings that make
/// no sense, and when stopped.
Result<ChainMonteCarlo> chainMonteCarlo(const ChainSubject &subject,
    const UncertaintySettings &settings, const FitAgain &fitAgain = {},
    const JobControl &control = {});

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model_analysis/response_result.h"
#include "core/monte_carlo/gum_validation.h"
#include "core/monte_carlo/trial_blocks.h"
#include "core/uncertainty/row_uncertainty.h"

#include <vector>

namespace dyncal {

/// One row of S(f) as trials have it: drawn as a complex number, told as magnitude and phase.
struct DrawnRow
{
    double frequency_Hz = kUnknown;
    bool withMagnitude = false; ///< its complete u is known
    bool withPhase = false;
    DrawnQuantity magnitude; ///< in the unit of the response
    DrawnQuantity phase; ///< rad, unwrapped as the row's
    GumValidation gumMagnitude;
    GumValidation gumPhase;
    double varRe = kUnknown; ///< of the complex value, with all that rows share
    double covReIm = kUnknown;
    double varIm = kUnknown;
    /// |S| is not large against its u (above 10 %): magnitude and phase are no longer normal, and
    /// the covariance of the complex value is what tells (JCGM 102).
    bool isBivariate = false;
};

/// How the intervals of rows are made: as drawnQuantity().
struct DrawnIntervals
{
    double coverage = 0.95;
    Index comparisons = 1;
};

/// `trials`: from 0 on, all of them; what rows share is in them. `response` and `rows` belong
/// together: those of the subject, or at its marked frequencies. In trial i row r is
///
///     S e^(j phi) C (1 + n + e + a) F R / ((1 + h)(1 + c)) e^(j w dt)
///
/// n: noise, complex, Student's with the row's degrees of freedom; e, a: the errors by the end of
/// the record and by sampling, within their bounds on both axes; F: the front; R: the reference
/// transducer's sensitivity; h: the drift; c: the chain's response; dt: the onset. A row without
/// u of its magnitude has its phase alone; one that is withheld has nothing. Fails when stopped.
Result<std::vector<DrawnRow>> drawnRows(const TrialPlan &plan, const TrialBlock &trials,
    const ResponseResult &response, const RowUncertainty &rows, const DrawnIntervals &intervals,
    const JobControl &control = {});

} // namespace dyncal

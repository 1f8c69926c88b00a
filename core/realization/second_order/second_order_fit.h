// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/refinement/refinement.h"
#include "core/realization/second_order/second_order_model.h"

#include <optional>
#include <vector>

namespace dyncal {

/// Where the search for the second-order model begins.
struct SecondOrderStart
{
    double f0_Hz = 0.0;
    double zeta = 0.0;
    std::vector<double> plateau; ///< per record
    std::vector<double> onset_s; ///< per record, relative to the detected start
};

/// Nonlinear least squares (Levenberg-Marquardt) of the step responses
///     y(t) = K (1 - e^(-zeta w0 t') (cos wd t' + zeta w0/wd sin wd t')),   t' = t - onset
/// (thesis eqs 3.11-3.17; for zeta > 1 its two real poles) to the records at their own rate, with
/// common w0 and zeta, K and onset of each its own; the covariance as in allowForColour(). The
/// records' nuisance terms start from those of the free model and are fitted too; those of the tube
/// are part of the pressure from the onset on, so the sensor responds to them too. FIT over the
/// model inputs; `describes` is true if it is at most two points below `fitToReach_percent`. Empty
/// where it does not converge.
std::optional<SecondOrderModel> fitSecondOrder(const ModelInput &input,
    const std::vector<RefinementRecord> &records, const SecondOrderStart &start,
    double fitToReach_percent, const JobControl &control = {});

/// MOD-011: a second-order sensor does not describe the data.
Findings judgeSecondOrder(const SecondOrderModel &fit, double modelFit_percent);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/realization/input/model_input.h"
#include "core/realization/refinement/noise_basis.h"
#include "core/realization/refinement/refinement.h"
#include "core/realization/second_order/second_order_model.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dyncal {

/// Damping ratio below which the response rings: its free poles are known well enough.
inline constexpr double kLeastDamping = 0.75;

/// A drift behind the step, slower than the sensor: amplitude e^(rate t) in every record.
struct DriftStart
{
    double rate_rad_s = 0.0; ///< shared by the records
    std::vector<double> amplitude; ///< per record
};

/// Where the search for the second-order model begins.
struct SecondOrderStart
{
    double f0_Hz = 0.0;
    double zeta = 0.0;
    std::vector<double> plateau; ///< per record
    std::vector<double> onset_s; ///< per record, relative to the detected start
    std::optional<DriftStart> drift = {}; ///< of every start or of none
};

/// The fitted sensor, and the same as poles with the amplitudes of every record.
struct SecondOrderFit
{
    SecondOrderModel sensor; ///< `describes` and `isModel` are left false
    Refinement refinement; ///< gains tied to c0; its covariance has the rank of `parameters`
    Index parameters = 0; ///< w0, zeta, and of each record K, onset and nuisance terms
    NoiseBasis noise;
    Eigen::Matrix2d shape; ///< covariance of ln w0 and ln zeta
};

/// Nonlinear least squares (Levenberg-Marquardt) of the step responses
///     y(t) = K (1 - e^(-zeta w0 t') (cos wd t' + zeta w0/wd sin wd t')),   t' = t - onset
/// (thesis eqs 3.11-3.17; for zeta > 1 its two real poles) to the records at their own rate, with
/// common w0 and zeta, K and onset of each its own; the covariance as in allowForColour(), for zeta
/// of at least kLeastDamping as wide as the likelihood's upper side, with what u of the front's
/// duration adds. With a drift the pressure behind the step changes as 1 + h e^(rate t'), at most a
/// tenth as fast as the sensor; it is the first pole of `refinement` and no part of `sensor`. The
/// records' nuisance terms start from those given and are fitted too; those of the tube are part of
/// the pressure from the onset on, so the sensor responds to them too. Of several starts the one
/// that ends lowest counts. FIT over the model inputs; `records` are refinementRecords(input).
/// Empty where none converges.
std::optional<SecondOrderFit> fitSecondOrder(const ModelInput &input,
    const std::vector<RefinementRecord> &records, const std::vector<SecondOrderStart> &starts,
    const JobControl &control = {});

/// MOD-011: a second-order sensor does not describe the data.
Findings judgeSecondOrder(const SecondOrderModel &fit, double modelFit_percent);

} // namespace dyncal

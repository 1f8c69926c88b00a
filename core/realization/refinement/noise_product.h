// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_gram.h"
#include "core/realization/input/whitening.h"
#include "core/realization/refinement/refinement.h"
#include "core/signal/window_bands.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace dyncal {

/// d model / d parameter of one record, parameters in the order of Refinement::covariance: poles,
/// amplitudes (2 Re, 2 Im of the upper half of a pair), constant, nuisance terms. Each is a column
/// t^order Re(factor e^(s t)).
struct Sensitivities
{
    std::vector<std::complex<double>> exponents; ///< s dt of every mode, 0 of the constant
    std::vector<ExponentialColumn> columns; ///< one per parameter
    double dt_s = 0.0;
};

Sensitivities sensitivitiesOf(
    const Refinement &refinement, std::size_t record, const RefinementRecord &data);

/// J^T S J over `used` (in order, apart; zero elsewhere), S the covariance of the noise, row i of
/// J^T times unit[i]. With u the output of the transposed filter 1/A run backwards over J^T, it is
/// the innovation variance times sum u u^T, including samples before the record, since the noise
/// was there before it. All modes decay or are constant, and the noise model is stable. So the
/// filter runs sample by sample only while the end of a range still has an effect; then u consists
/// of the same exponentials, and its sum has a closed form (docs/method/model.md).
Eigen::MatrixXd noiseProduct(const Sensitivities &sensitivities, const Eigen::VectorXd &unit,
    const std::vector<SampleRange> &used, const AutoregressiveModel &noise);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/input/whitening.h"
#include "core/realization/refinement/noise_basis.h"
#include "core/realization/refinement/refinement.h"

#include <vector>

namespace dyncal {

/// A model of the noise of every record, all of one order.
struct NoiseModels
{
    NoiseBasis basis;
    std::vector<AutoregressiveModel> ofRecord;
};

/// Models of the pre-trigger noise (`noise`, one per record, at the record's rate), or of the fit's
/// residual where that is larger at the 1 % level or no noise is known; p = 0 .. 20 by BIC over all
/// records. `parameters` is the number of fitted ones.
NoiseModels chooseNoiseModels(const std::vector<RefinementRecord> &records,
    const std::vector<NoiseCovariance> &noise, const Refinement &fit, Index parameters);

/// Sum over the records of J^T W S W J for poles, amplitudes, c0 and nuisance terms in the order of
/// Refinement::covariance, each counted in `unit`; S from the models.
Eigen::MatrixXd noiseFilling(const std::vector<RefinementRecord> &records,
    const std::vector<AutoregressiveModel> &models, const Refinement &fit,
    const Eigen::VectorXd &unit);

/// Corrects the covariance of a least-squares fit for coloured noise (docs/method/model.md):
///     (J^T W J)^-1 (J^T W S W J) (J^T W J)^-1
/// with S of chooseNoiseModels(). For p = 0 the refinement is left as it is.
NoiseBasis allowForColour(const std::vector<RefinementRecord> &records,
    const std::vector<NoiseCovariance> &noise, Refinement &refinement);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/pole_refinement.h"
#include "core/realization/whitening.h"

#include <vector>

namespace dyncal {

/// What the covariance of a refinement rests on.
struct NoiseBasis
{
    Index order = 0; ///< p of the AR(p) model of the noise; 0 = white
    bool fromResidual = false; ///< in some record the residual exceeds the noise before the start
    double dof = 0.0; ///< degrees of freedom of the noise's estimate, for Student's factor
};

/// Brings the covariance of a least-squares fit to the colour of the noise (docs/method/model.md):
///     (J^T W J)^-1 (J^T W S W J) (J^T W J)^-1
/// with S of an AR(p) model of the record's pre-trigger noise (`noise`, one per record, at the
/// record's rate), or of its residual where that is larger at the 1 % level or no noise is known.
/// p = 0 .. 20 by BIC over all records. For p = 0 the refinement is left as it is.
NoiseBasis allowForColour(const std::vector<RefinementRecord> &records,
    const std::vector<NoiseCovariance> &noise, Refinement &refinement);

} // namespace dyncal

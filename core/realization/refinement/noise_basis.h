// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <string>

namespace dyncal {

/// What the covariance of a refinement rests on.
struct NoiseBasis
{
    Index order = 0; ///< p of the AR(p) model of the noise; 0 = white
    bool fromResidual = false; ///< some residual exceeds the noise before the start
    double dof = 0.0; ///< degrees of freedom of the noise's estimate, for Student's factor
};

/// "white" or "AR(p)", with " of the residual" where the residual replaces the noise.
std::string noiseName(const NoiseBasis &basis);

} // namespace dyncal

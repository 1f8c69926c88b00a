// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/noise_basis.h"

namespace dyncal {

std::string noiseName(const NoiseBasis &basis)
{
    if (basis.order == 0)
        return "white";
    return "AR(" + std::to_string(basis.order) + ")"
        + (basis.fromResidual ? " of the residual" : "");
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/hankel/hankel_decomposition.h"
#include "core/realization/hankel/state_space_model.h"

#include <complex>
#include <vector>

namespace dyncal {

/// Largest order the decomposition can serve.
Index largestOrder(const HankelDecomposition &decomposition);

/// Poles of order n in the z plane, paired: eigenvalues of the least-squares shift-invariance
/// matrix of the leading n left vectors, A = (I + w w^T / (1 - w^T w)) G_n with G = U_up^T U_down
/// and w the last row of U_n (Sherman-Morrison, so one Gram matrix serves every order); with
/// step-as-impulse of the thesis's A_n = S^-1/2 U^T H1 V S^-1/2 (eq 3.22). 1 <= n <= largestOrder.
std::vector<std::complex<double>> realizedPoles(
    const HankelDecomposition &decomposition, Index order);

/// A_n, B_n, C_n of eq 3.22 with D = 0, exactly as the listing (appendix D). Thesis mode only.
StateSpaceModel thesisRealization(
    const HankelDecomposition &decomposition, Index order, double sampleInterval_s);

} // namespace dyncal

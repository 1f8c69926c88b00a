// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_sum.h"

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace dyncal {

/// As fitAmplitudes, for all columns of `records` (samples x records) at once: the basis is built
/// once, by products, and the normal equations are solved. For scans over many orders, which need
/// residuals and sizes only: the normal equations lose twice the digits in the amplitudes of nearly
/// equal poles, but not in the residuals. Poles must not grow beyond 10 over the record.
std::vector<AmplitudeFit> fitSharedPoles(const Eigen::MatrixXd &records,
    const std::vector<std::complex<double>> &poles, bool withConstant);

} // namespace dyncal

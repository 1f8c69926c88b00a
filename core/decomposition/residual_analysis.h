// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/decomposition/principal_components.h"

namespace dyncal {

/// Autocovariance, whiteness and spectrum of what one shot keeps after its reconstruction. The mean
/// counts for the rms, not for the autocovariance. At least 8 finite values, else DataBlocked.
Result<ResidualAnalysis> analyseResidual(const Eigen::Ref<const Eigen::VectorXd> &residual,
    double rate_Hz, const ComponentSettings &settings, const SpectrumSettings &spectrum);

/// PCA-002 (not white), PCA-003 (a resonance of the average is left), PCA-004 (one shot dominates).
Findings residualFindings(const ComponentResult &result, const SpectrumSettings &spectrum);

/// Ljung-Box p value of a normalised autocovariance of `samples` values over its first `lags`.
double ljungBox_p(const Eigen::VectorXd &autocorrelation, Index samples, Index lags);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"
#include "core/decomposition/component_settings.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/response_window.h"
#include "core/signal/signal_settings.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

/// The residual of one shot: what is left after subtracting its reconstruction.
struct ResidualAnalysis
{
    double rms = 0.0; ///< in the units of the responses
    Eigen::VectorXd autocovariance; ///< lags 0..L, normalised to 1 at lag 0
    double confidenceBound = 0.0; ///< +- bound of white noise at the chosen confidence
    double outsideFraction = 0.0; ///< share of lags 1..L beyond the bound
    double whiteness_p = 1.0; ///< Ljung-Box over min(L, 20) lags
    PowerSpectrum spectrum;
    std::vector<double> peaks_Hz; ///< prominent maxima of that spectrum, strongest first (<= 5)
};

/// A series in the form that the spectrum stage takes.
WindowedResponse asResponse(const Eigen::Ref<const Eigen::VectorXd> &values, double rate_Hz);

/// Autocovariance of a zero-mean series at lags 0..maxLag, biased estimate (divides by N), by FFT.
Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd> &values, Index maxLag);

/// Autocovariance, whiteness and spectrum of one shot's residual. Its mean counts for the rms, not
/// for the autocovariance. At least 8 finite values, else DataBlocked.
Result<ResidualAnalysis> analyseResidual(const Eigen::Ref<const Eigen::VectorXd> &residual,
    double rate_Hz, const ComponentSettings &settings, const SpectrumSettings &spectrum);

/// Ljung-Box p value of a normalised autocovariance of `samples` values over its first `lags`.
double ljungBox_p(const Eigen::VectorXd &autocorrelation, Index samples, Index lags);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/decomposition/component_settings.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/response_window.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dyncal {

/// Principal components across shots: X (samples x shots) = mean + U S V^T, via QR and a small SVD
/// (the Gram matrix would lose components below 1e-8 of the first).
struct PrincipalComponents
{
    Eigen::VectorXd singularValues; ///< one per shot, largest first
    Eigen::VectorXd explainedCumulative_percent; ///< 100 sum s_i^2 / sum s^2
    Eigen::MatrixXd components; ///< samples x shots: U
    Eigen::MatrixXd scores; ///< shots x shots: S V^T, column per shot
    Eigen::VectorXd mean; ///< empty unless centred
};

/// `shots`: samples x shots, at least one of each, finite. With fewer samples than shots there are
/// as many components as samples. Signs: docs/method/principal-components.md.
PrincipalComponents computePrincipalComponents(const Eigen::MatrixXd &shots, bool centre);

/// Reconstruction of every shot from the first `kept` components (1..their number): samples x
/// shots.
Eigen::MatrixXd reconstruct(const PrincipalComponents &components, Index kept);

/// What one shot keeps after its reconstruction is taken away.
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

struct ComponentResult
{
    std::vector<Index> shots; ///< numbers of the shots used, from 1
    double sampleRate_Hz = 0.0; ///< common rate: the lowest among the shots
    std::optional<PrincipalComponents> principal; ///< empty with one shot (CAP-017)
    Eigen::MatrixXd responses; ///< samples x shots at the common rate, from the start on
    Eigen::MatrixXd reconstructions;
    Eigen::VectorXd average; ///< of the reconstructions; of one shot: the shot itself
    std::vector<ResidualAnalysis> residuals; ///< per shot; empty with one shot
    Index kept = 1; ///< components in the reconstructions: as set, at most the shots
    Findings findings; ///< PCA-001..004, CAP-017, CAP-004 (info) when rates were unified
};

/// PCA, reconstructions, residuals and the average (thesis 3.7 step 4). Shots of a higher rate are
/// reduced to the lowest one (integer ratios; else linear phase interpolation is not offered and
/// the stage fails naming both rates); the common length is the shortest window. Usage error on
/// settings out of range.
Result<ComponentResult> analyseComponents(const std::vector<WindowedResponse> &responses,
    const ComponentSettings &settings, const SpectrumSettings &spectrum,
    const JobControl &control = {});

/// Autocovariance of a zero-mean series at lags 0..maxLag, biased estimate (divides by N), by FFT.
Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd> &values, Index maxLag);

} // namespace dyncal

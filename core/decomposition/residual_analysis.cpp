// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/decomposition/residual_analysis.h"

#include "core/base/distributions.h"
#include "core/signal/fft.h"
#include "core/signal/spectrum_analysis.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

namespace dyncal {
namespace {

constexpr Index kWhitenessLags = 20;
constexpr std::size_t kMostPeaks = 5;

} // namespace

WindowedResponse asResponse(const Eigen::Ref<const Eigen::VectorXd> &values, double rate_Hz)
{
    WindowedResponse response;
    response.sampleRate_Hz = rate_Hz;
    response.values = values;
    response.length = values.size();
    return response;
}

Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd> &values, Index maxLag)
{
    const Index n = values.size();
    Eigen::VectorXd result = Eigen::VectorXd::Zero(maxLag + 1);
    if (n == 0)
        return result;
    const Index lags = std::min(maxLag, n - 1);
    const RealFft fft(fastFftLength(n + lags)); // padding keeps the wrap-around beyond `lags`
    const Eigen::VectorXcd power = fft.forward(values).cwiseAbs2().cast<std::complex<double>>();
    result.head(lags + 1) = fft.inverse(power).head(lags + 1) / static_cast<double>(n);
    return result;
}

double ljungBox_p(const Eigen::VectorXd &autocorrelation, Index samples, Index lags)
{
    if (lags < 1)
        return 1.0;
    const auto n = static_cast<double>(samples);
    double sum = 0.0;
    for (Index k = 1; k <= lags; ++k)
        sum += autocorrelation[k] * autocorrelation[k] / (n - static_cast<double>(k));
    return chiSquareSurvival(n * (n + 2.0) * sum, static_cast<double>(lags));
}

Result<ResidualAnalysis> analyseResidual(const Eigen::Ref<const Eigen::VectorXd> &residual,
    double rate_Hz, const ComponentSettings &settings, const SpectrumSettings &spectrum)
{
    SpectrumSettings search = spectrum; // the operator's list is not for residuals
    search.resonances_Hz.clear();
    search.resonanceBand_Hz.reset();
    search.searchResonance = true;
    Result<SpectrumResult> spectra = analyseSpectra({asResponse(residual, rate_Hz)}, search);
    if (!spectra)
        return tl::unexpected(spectra.error());

    ResidualAnalysis result;
    const Index n = residual.size();
    result.rms = std::sqrt(residual.squaredNorm() / static_cast<double>(n));
    result.spectrum = std::move(spectra->perShot[0]);
    for (const Resonance &peak : spectra->resonances) {
        if (result.peaks_Hz.size() < kMostPeaks)
            result.peaks_Hz.push_back(peak.frequency_Hz);
    }
    const Index lags = std::min(settings.residualLags, n - 1);
    result.autocovariance = autocovariance((residual.array() - residual.mean()).matrix(), lags);
    if (result.autocovariance[0] > 0.0)
        result.autocovariance /= result.autocovariance[0];
    result.autocovariance[0] = 1.0;
    result.confidenceBound = normalQuantile(0.5 * (1.0 + settings.residualConfidence))
        / std::sqrt(static_cast<double>(n));
    const auto outside = (result.autocovariance.tail(lags).array().abs() > result.confidenceBound);
    result.outsideFraction = static_cast<double>(outside.count()) / static_cast<double>(lags);
    result.whiteness_p = ljungBox_p(result.autocovariance, n, std::min(lags, kWhitenessLags));
    return result;
}

} // namespace dyncal

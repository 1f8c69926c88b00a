// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/decomposition/residual_findings.h"

#include "core/base/number_text.h"
#include "core/decomposition/residual_analysis.h"
#include "core/signal/fft.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/spectrum_analysis.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

namespace dyncal {
namespace {

constexpr double kLargestOutside = 0.05; ///< share of lags
constexpr double kSameFrequency = 0.03;
constexpr double kTolerableShare = 0.1; ///< of the resonance's amplitude; more left is a caution
constexpr double kLargestDelay = 1.0; ///< samples; starts are rounded to whole samples
constexpr double kLargestShare = 0.9; ///< of the largest energy share that one shot can have

/// The peak of a residual that is a resonance of the average, if one is.
std::optional<double> resonanceLeft(
    const ResidualAnalysis &residual, const std::vector<Resonance> &resonances)
{
    for (const double peak_Hz : residual.peaks_Hz) {
        for (const Resonance &resonance : resonances) {
            if (std::abs(peak_Hz / resonance.frequency_Hz - 1.0) <= kSameFrequency)
                return peak_Hz;
        }
    }
    return std::nullopt;
}

/// Largest density within +-3 % of a frequency.
double densityNear(const PowerSpectrum &spectrum, double frequency_Hz)
{
    double top = 0.0;
    for (Index k = 0; k < spectrum.psd.size(); ++k) {
        if (std::abs(spectrum.frequency_Hz[k] / frequency_Hz - 1.0) <= kSameFrequency)
            top = std::max(top, spectrum.psd[k]);
    }
    return top;
}

/// Delay of one shot, and what it leaves of a resonance.
struct Alignment
{
    double delay_samples = 0.0; ///< of the shot after its reconstruction
    double share = 0.0; ///< amplitude of the average's resonance that is left without the delay
};

/// The shot against its reconstruction within +-3 % of a frequency, as spectra of the whole window:
/// the delay is the phase of their cross spectrum there.
Alignment align(const ComponentResult &result, Index column, double frequency_Hz)
{
    const Index n = result.responses.rows();
    const RealFft fft(n);
    const Eigen::VectorXcd shot = fft.forward(result.responses.col(column));
    const Eigen::VectorXcd model = fft.forward(result.reconstructions.col(column));
    const Eigen::VectorXcd average = fft.forward(result.average);
    const double perBin = 2.0 * M_PI / static_cast<double>(n); // radians a sample
    const double centre = frequency_Hz / result.sampleRate_Hz * static_cast<double>(n);
    const auto first = static_cast<Index>(std::ceil((1.0 - kSameFrequency) * centre));
    const Index end = std::min(
        static_cast<Index>(std::floor((1.0 + kSameFrequency) * centre)) + 1, shot.size());
    std::complex<double> cross = 0.0;
    for (Index k = first; k < end; ++k)
        cross += shot[k] * std::conj(model[k]);
    Alignment found;
    found.delay_samples = -std::arg(cross) / (perBin * centre);
    double left = 0.0, whole = 0.0;
    for (Index k = first; k < end; ++k) {
        const double phase = perBin * static_cast<double>(k) * found.delay_samples;
        left = std::max(left, std::norm(shot[k] - std::polar(1.0, -phase) * model[k]));
        whole = std::max(whole, std::norm(average[k]));
    }
    found.share = whole > 0.0 ? std::sqrt(left / whole) : 1.0;
    return found;
}

/// Whole per cent; below 1 % one significant digit.
std::string percentText(double percent)
{
    return percent < 1.0 ? numberText(percent, 1) : numberText(std::round(percent), 4);
}

/// Whether rounding the starts to whole samples explains the residual.
bool startsExplain(const Alignment &alignment)
{
    return std::abs(alignment.delay_samples) <= kLargestDelay && alignment.share <= kTolerableShare;
}

Finding startedBetweenSamples(Finding finding, const Alignment &alignment, double left_Hz)
{
    finding.severity = Severity::Info;
    finding.message = {
        DYNCAL_TEXT("core",
            "Shot %1: %2 % of the resonance at %3 is left in the residual, because its arrival differs from the others' by %4 of a sample; aligned, %5 % are left. The average of the shots loses some of its ringing by this, stacked shots do not."),
        {std::to_string(finding.shot), percentText(100.0 * *finding.value),
            numberWithUnit(left_Hz, "Hz", 4), numberText(alignment.delay_samples, 2),
            percentText(100.0 * alignment.share)}};
    return finding;
}

void addResonanceLeft(
    const ComponentResult &result, Index column, const SpectrumResult &average, Findings &findings)
{
    const Index shot = result.shots[static_cast<std::size_t>(column)];
    const ResidualAnalysis &residual = result.residuals[static_cast<std::size_t>(column)];
    const auto left_Hz = resonanceLeft(residual, average.resonances);
    if (!left_Hz)
        return;
    const double share = std::sqrt(
        densityNear(residual.spectrum, *left_Hz) / densityNear(average.perShot.front(), *left_Hz));
    Finding finding{.id = "PCA-003",
        .severity = Severity::Caution,
        .shot = shot,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1: %2 % of the resonance at %3 is left in the residual; its amplitude or its time varies between the shots."),
            {std::to_string(shot), percentText(100.0 * share), numberWithUnit(*left_Hz, "Hz", 4)}},
        .value = share,
        .limit = kTolerableShare};
    if (share <= kTolerableShare)
        finding.severity = Severity::Info;
    else if (const Alignment alignment = align(result, column, *left_Hz); startsExplain(alignment))
        finding = startedBetweenSamples(std::move(finding), alignment, *left_Hz);
    findings.push_back(std::move(finding));
}

void addWhiteness(Index shot, const ResidualAnalysis &residual, Findings &findings)
{
    if (residual.outsideFraction <= kLargestOutside)
        return;
    Finding finding{.id = "PCA-002",
        .severity = Severity::Caution,
        .shot = shot,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1: the residual is not white, %2 % of the lags lie outside the confidence band."),
            {std::to_string(shot), percentText(100.0 * residual.outsideFraction)}},
        .value = 100.0 * residual.outsideFraction,
        .limit = 100.0 * kLargestOutside};
    finding.severity = Severity::Info; // a limit of one component, no reason to stop
    findings.push_back(std::move(finding));
}

/// The mean of n shots follows an odd one by 1/n, so it holds at most (n - 1)/n of the residuals'
/// energy. Of two shots both hold half in any case.
void addDominance(const ComponentResult &result, Findings &findings)
{
    const auto shots = static_cast<double>(result.residuals.size());
    if (shots < 3.0)
        return;
    const double limit = kLargestShare * (shots - 1.0) / shots;
    Eigen::VectorXd energy(static_cast<Index>(result.residuals.size()));
    for (Index i = 0; i < energy.size(); ++i)
        energy[i] = std::pow(result.residuals[static_cast<std::size_t>(i)].rms, 2);
    Index worst = 0;
    const double share = energy.maxCoeff(&worst) / energy.sum();
    if (!(share > limit))
        return;
    const Index shot = result.shots[static_cast<std::size_t>(worst)];
    findings.push_back({.id = "PCA-004",
        .severity = Severity::Caution,
        .shot = shot,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1 holds %2 % of the energy of all residuals; look at it before using the average."),
            {std::to_string(shot), numberText(100.0 * share, 3)}},
        .value = 100.0 * share,
        .limit = 100.0 * limit});
}

} // namespace

Findings residualFindings(const ComponentResult &result, const SpectrumSettings &spectrum)
{
    Findings findings;
    const Result<SpectrumResult> average
        = analyseSpectra({asResponse(result.average, result.sampleRate_Hz)}, spectrum);
    for (std::size_t i = 0; i < result.residuals.size(); ++i) {
        addWhiteness(result.shots[i], result.residuals[i], findings);
        if (average)
            addResonanceLeft(result, static_cast<Index>(i), *average, findings);
    }
    addDominance(result, findings);
    return findings;
}

} // namespace dyncal

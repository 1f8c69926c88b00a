// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/spectrum_analysis.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dyncal {
namespace {

constexpr double kSameResonance = 0.05; ///< peaks of different shots this close are one resonance
constexpr std::size_t kMostPeaks = 20; ///< of one shot
constexpr double kNarrow = 4.0; ///< bins of half-power width below which a parabola is too coarse
constexpr double kLargestSpread = 0.02;

/// Number of independent periodograms that an average over half overlapping segments corresponds
/// to: with a rectangular taper only every other segment adds new samples.
double independentAverages(const SpectrumSegments &segments)
{
    return 0.5 * static_cast<double>(segments.count + 1);
}

/// What one shot shows: peaks of the search, or the maxima nearest to the operator's frequencies.
struct ShotPeaks
{
    std::vector<SpectralPeak> all;
    std::vector<SpectralPeak> found; ///< those that may be a resonance of the sensor
    std::vector<std::optional<SpectralPeak>> nearest;
};

ShotPeaks peaksOf(const PowerSpectrum &spectrum, const Eigen::Ref<const Eigen::VectorXd> &values,
    double rate_Hz, const SpectrumSettings &settings)
{
    const SpectrumSegments segments = segmentsOf(values.size(), settings);
    const ResonanceSearch search(spectrum, independentAverages(segments));
    ShotPeaks peaks;
    peaks.all = search.prominentPeaks(std::nullopt);
    for (const double frequency_Hz : settings.resonances_Hz)
        peaks.nearest.push_back(search.nearestPeak(frequency_Hz));
    if (settings.resonances_Hz.empty() && settings.searchResonance)
        peaks.found = settings.resonanceBand_Hz ? search.prominentPeaks(settings.resonanceBand_Hz)
                                                : peaks.all;
    peaks.found.resize(std::min(peaks.found.size(), kMostPeaks));
    if (segments.count == 1) {
        const Eigen::VectorXd analysed = asOneSegment(values, settings);
        const double bin_Hz = spectrum.frequency_Hz[1];
        const auto refine = [&](SpectralPeak &peak) {
            if (peak.frequency_Hz < kNarrow * bin_Hz * peak.q)
                peak.frequency_Hz
                    = refinedFrequency_Hz(analysed, rate_Hz, peak.frequency_Hz, bin_Hz);
        };
        std::for_each(peaks.found.begin(), peaks.found.end(), refine);
        for (auto &peak : peaks.nearest) {
            if (peak)
                refine(*peak);
        }
    }
    return peaks;
}

/// One resonance from what each shot shows of it; at least one entry is set.
Resonance combined(const std::vector<std::optional<SpectralPeak>> &perShot)
{
    Resonance resonance;
    double count = 0.0;
    for (const auto &peak : perShot) {
        resonance.perShot_Hz.push_back(std::nullopt);
        if (!peak)
            continue;
        resonance.perShot_Hz.back() = peak->frequency_Hz;
        resonance.frequency_Hz += peak->frequency_Hz;
        resonance.q += peak->q;
        resonance.prominence_dB = count == 0.0
            ? peak->prominence_dB
            : std::min(resonance.prominence_dB, peak->prominence_dB);
        count += 1.0;
    }
    resonance.frequency_Hz /= count;
    resonance.q /= count;
    return resonance;
}

/// The most prominent peak that is left over all shots; empty when none is.
std::optional<SpectralPeak> mostProminent(const std::vector<ShotPeaks> &shots)
{
    std::optional<SpectralPeak> best;
    for (const ShotPeaks &shot : shots) {
        for (const SpectralPeak &peak : shot.found) {
            if (!best || peak.prominence_dB > best->prominence_dB)
                best = peak;
        }
    }
    return best;
}

/// Takes from each shot the peak nearest to `frequency_Hz`, if it is the same resonance.
std::vector<std::optional<SpectralPeak>> takeSame(
    std::vector<ShotPeaks> &shots, double frequency_Hz)
{
    std::vector<std::optional<SpectralPeak>> same;
    for (ShotPeaks &shot : shots) {
        const auto apart = [&](const SpectralPeak &peak) {
            return std::abs(peak.frequency_Hz / frequency_Hz - 1.0);
        };
        const auto nearest = std::min_element(shot.found.begin(), shot.found.end(),
            [&](const SpectralPeak &a, const SpectralPeak &b) { return apart(a) < apart(b); });
        same.emplace_back();
        if (nearest == shot.found.end() || apart(*nearest) > kSameResonance)
            continue;
        same.back() = *nearest;
        shot.found.erase(nearest);
    }
    return same;
}

/// Resonances that at least half of the shots show.
std::vector<Resonance> sharedResonances(std::vector<ShotPeaks> shots)
{
    std::vector<Resonance> resonances;
    while (const auto best = mostProminent(shots)) {
        const auto same = takeSame(shots, best->frequency_Hz);
        const auto seen = std::count_if(
            same.begin(), same.end(), [](const auto &peak) { return peak.has_value(); });
        if (2 * seen >= static_cast<Index>(same.size()))
            resonances.push_back(combined(same));
    }
    return resonances;
}

/// One resonance per frequency of the operator; one that no shot shows stays as given.
std::vector<Resonance> operatorResonances(
    const std::vector<ShotPeaks> &shots, const std::vector<double> &frequencies_Hz)
{
    std::vector<Resonance> resonances;
    for (std::size_t i = 0; i < frequencies_Hz.size(); ++i) {
        std::vector<std::optional<SpectralPeak>> perShot;
        for (const ShotPeaks &shot : shots)
            perShot.push_back(shot.nearest[i]);
        const bool matched = std::any_of(
            perShot.begin(), perShot.end(), [](const auto &peak) { return peak.has_value(); });
        Resonance placed;
        placed.frequency_Hz = frequencies_Hz[i];
        placed.perShot_Hz.resize(shots.size());
        resonances.push_back(matched ? combined(perShot) : placed);
    }
    return resonances;
}

Finding noResonance(double nyquist_Hz)
{
    return {.id = "SPC-001",
        .severity = Severity::Info,
        .message = {DYNCAL_TEXT("core", "No resonance found below %1."),
            {numberWithUnit(nyquist_Hz, "Hz", 3)}}};
}

std::optional<Finding> spreadFinding(const Resonance &resonance)
{
    double lowest = resonance.frequency_Hz, highest = lowest;
    for (const auto &frequency_Hz : resonance.perShot_Hz) {
        lowest = std::min(lowest, frequency_Hz.value_or(lowest));
        highest = std::max(highest, frequency_Hz.value_or(highest));
    }
    const double spread = (highest - lowest) / resonance.frequency_Hz;
    if (spread <= kLargestSpread)
        return std::nullopt;
    return Finding{.id = "SPC-002",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core", "The resonance differs between shots: %1 to %2, a spread of %3 %."),
            {numberWithUnit(lowest, "Hz", 4), numberWithUnit(highest, "Hz", 4),
                numberText(100.0 * spread, 2)}},
        .value = 100.0 * spread,
        .limit = 100.0 * kLargestSpread};
}

void addFindings(const SpectrumSettings &settings, SpectrumResult &result)
{
    const bool searched = settings.searchResonance && settings.resonances_Hz.empty();
    if (searched && result.resonances.empty()) {
        double nyquist_Hz = 0.0;
        for (const PowerSpectrum &spectrum : result.perShot)
            nyquist_Hz = std::max(nyquist_Hz, spectrum.frequency_Hz.maxCoeff());
        result.findings.push_back(noResonance(nyquist_Hz));
    }
    for (const Resonance &resonance : result.resonances) {
        if (auto finding = spreadFinding(resonance))
            result.findings.push_back(std::move(*finding));
    }
}

} // namespace

Result<SpectrumResult> analyseSpectra(const std::vector<WindowedResponse> &responses,
    const SpectrumSettings &settings, const JobControl &control)
{
    SpectrumResult result;
    std::vector<ShotPeaks> peaks;
    for (const WindowedResponse &response : responses) {
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
        Result<PowerSpectrum> spectrum
            = computePowerSpectrum(response.window(), response.sampleRate_Hz, settings);
        if (!spectrum) {
            spectrum.error().shot = response.shot;
            return tl::unexpected(spectrum.error());
        }
        peaks.push_back(peaksOf(*spectrum, response.window(), response.sampleRate_Hz, settings));
        result.perShot.push_back(std::move(*spectrum));
        result.peaks.push_back(std::move(peaks.back().all));
        control.report(static_cast<double>(peaks.size()) / static_cast<double>(responses.size()));
    }
    result.resonances = settings.resonances_Hz.empty()
        ? sharedResonances(std::move(peaks))
        : operatorResonances(peaks, settings.resonances_Hz);
    std::stable_sort(result.resonances.begin(), result.resonances.end(),
        [](const Resonance &a, const Resonance &b) { return a.prominence_dB > b.prominence_dB; });
    addFindings(settings, result);
    return result;
}

} // namespace dyncal

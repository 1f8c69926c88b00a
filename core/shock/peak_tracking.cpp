// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/peak_tracking.h"

#include "core/base/number_text.h"
#include "core/shock/tube_resonances.h"
#include "core/signal/power_spectrum.h"
#include "core/signal/resonance_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace dyncal {
namespace {

constexpr double kPeakTolerance = 0.015; ///< beyond the span between sensor and gas mode
constexpr double kCandidateTolerance = 0.05;

struct ShotSpectrum
{
    Index shot;
    const PowerSpectrum *spectrum;
    const std::vector<SpectralPeak> *peaks;
    double a5_m_s;
    const ShockConditions *conditions;
};

/// Shots that have a spectrum and states.
std::vector<ShotSpectrum> usableShots(
    const SpectrumResult &spectrum, const WindowResult &window, const ShockConditionsSet &shock)
{
    std::vector<ShotSpectrum> list;
    const std::size_t count = std::min(spectrum.peaks.size(), window.responses.size());
    for (std::size_t i = 0; i < count; ++i) {
        const Index shot = window.responses[i].shot;
        const ShockConditions *conditions = shock.ofShot(shot);
        if (conditions && conditions->states && spectrum.perShot[i].frequency_Hz.size() > 8)
            list.push_back({shot, &spectrum.perShot[i], &spectrum.peaks[i],
                conditions->states->reflected.soundSpeed_m_s, conditions});
    }
    return list;
}

/// A peak lies anywhere within one bin (rectangular).
double frequencyUncertainty_Hz(const PowerSpectrum &spectrum)
{
    return (spectrum.frequency_Hz[1] - spectrum.frequency_Hz[0]) / std::sqrt(12.0);
}

/// The most prominent peak between the frequencies of a sensor and of a gas mode.
std::optional<double> peakBetween(
    const std::vector<SpectralPeak> &peaks, double atSensor_Hz, double atGas_Hz)
{
    const double low = std::min(atSensor_Hz, atGas_Hz) * (1.0 - kPeakTolerance);
    const double high = std::max(atSensor_Hz, atGas_Hz) * (1.0 + kPeakTolerance);
    for (const SpectralPeak &peak : peaks) {
        if (peak.frequency_Hz >= low && peak.frequency_Hz <= high)
            return peak.frequency_Hz;
    }
    return std::nullopt;
}

std::string nearestCandidate(const ShockConditions &conditions, double frequency_Hz)
{
    std::string label;
    double best = kCandidateTolerance;
    for (const TubeResonance &resonance : conditions.resonances) {
        const double distance = std::abs(resonance.frequency_Hz / frequency_Hz - 1.0);
        if (distance < best && resonance.followsGas) {
            best = distance;
            label = resonance.label();
        }
    }
    return label;
}

Finding movingPeak(const FollowedPeak &peak)
{
    std::string frequencies;
    for (const PeakOfShot &p : peak.peaks)
        frequencies += std::string(frequencies.empty() ? "" : "/")
            + numberWithUnit(p.frequency_Hz, "Hz", 3);
    std::vector<std::string> words{
        frequencies, numberText(peak.test.slope, 2), numberText(peak.test.u_slope, 2)};
    Message message;
    if (peak.candidate.empty()) {
        message = {
            DYNCAL_TEXT("core",
                "Peak %1 follows the sound speed of the gas (slope %2, u %3; of a sensor 0): a tube mode, to be left out of the model."),
            words};
    } else {
        words.push_back(peak.candidate);
        message = {
            DYNCAL_TEXT("core",
                "Peak %1 follows the sound speed of the gas (slope %2, u %3; of a sensor 0): a tube mode, to be left out of the model. The nearest computed is %4."),
            words};
    }
    return {.id = "SPC-005", .message = std::move(message), .value = peak.test.slope, .limit = 1.0};
}

} // namespace

std::vector<FollowedPeak> followPeaks(
    const SpectrumResult &spectrum, const WindowResult &window, const ShockConditionsSet &shock)
{
    const std::vector<ShotSpectrum> shots = usableShots(spectrum, window, shock);
    std::vector<FollowedPeak> followed;
    if (shots.size() < 2)
        return followed;
    for (const SpectralPeak &first : *shots.front().peaks) {
        FollowedPeak peak;
        for (std::size_t i = 0; i < shots.size(); ++i) {
            const double atGas_Hz = first.frequency_Hz * shots[i].a5_m_s / shots.front().a5_m_s;
            const auto found_Hz = peakBetween(*shots[i].peaks, first.frequency_Hz, atGas_Hz);
            if (!found_Hz)
                break;
            peak.shots.push_back(shots[i].shot);
            peak.peaks.push_back(
                {shots[i].a5_m_s, *found_Hz, frequencyUncertainty_Hz(*shots[i].spectrum)});
        }
        const auto test
            = peak.shots.size() == shots.size() ? testSoundSpeed(peak.peaks) : std::nullopt;
        if (!test)
            continue;
        peak.test = *test;
        peak.candidate = nearestCandidate(*shots.front().conditions, first.frequency_Hz);
        followed.push_back(std::move(peak));
    }
    return followed;
}

Findings judgePeaks(const std::vector<FollowedPeak> &peaks)
{
    Findings findings;
    for (const FollowedPeak &peak : peaks) {
        if (peak.test.followsGas)
            findings.push_back(movingPeak(peak));
    }
    return findings;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/nuisance/nuisance_modes.h"

#include "core/realization/exponentials/pole_mapping.h"
#include "core/signal/spectrum_analysis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kPeakTolerance = 0.1;
constexpr double kPoleTolerance = 0.1;

std::optional<double> soundSpeedOf(
    const std::vector<std::optional<double>> &soundSpeeds_m_s, Index shot)
{
    const auto at = static_cast<std::size_t>(shot - 1);
    return shot >= 1 && at < soundSpeeds_m_s.size() ? soundSpeeds_m_s[at] : std::nullopt;
}

std::optional<double> expectedFrequency_Hz(
    const NuisanceMode &mode, Index shot, const std::vector<std::optional<double>> &soundSpeeds_m_s)
{
    const auto at = static_cast<std::size_t>(shot - 1);
    if (mode.frequency_Hz.size() > 1)
        return at < mode.frequency_Hz.size() ? std::optional(mode.frequency_Hz[at]) : std::nullopt;
    if (mode.frequency_Hz.empty())
        return std::nullopt;
    Index from = mode.shot;
    for (std::size_t i = 0; from == 0 && i < soundSpeeds_m_s.size(); ++i) {
        if (soundSpeeds_m_s[i])
            from = static_cast<Index>(i) + 1;
    }
    const auto here = soundSpeedOf(soundSpeeds_m_s, shot);
    const auto there = soundSpeedOf(soundSpeeds_m_s, from);
    const double ratio = mode.isTube && here && there ? *here / *there : 1.0;
    return mode.frequency_Hz.front() * ratio;
}

bool isNuisancePeak(const Resonance &resonance, const std::vector<WindowedResponse> &responses,
    const std::vector<NuisanceMode> &modes,
    const std::vector<std::optional<double>> &soundSpeeds_m_s)
{
    for (const NuisanceMode &mode : modes) {
        std::size_t shown = 0;
        std::size_t meant = 0;
        for (std::size_t i = 0; i < resonance.perShot_Hz.size() && i < responses.size(); ++i) {
            const auto expected = expectedFrequency_Hz(mode, responses[i].shot, soundSpeeds_m_s);
            if (!resonance.perShot_Hz[i])
                continue;
            ++shown;
            meant += expected
                && std::abs(*resonance.perShot_Hz[i] / *expected - 1.0) < kPeakTolerance;
        }
        if (shown > 0 && 2 * meant >= shown)
            return true;
    }
    return false;
}

} // namespace

std::vector<std::optional<double>> expectedFrequencies_Hz(const std::vector<NuisanceMode> &modes,
    Index shot, const std::vector<std::optional<double>> &soundSpeeds_m_s)
{
    std::vector<std::optional<double>> list;
    for (const NuisanceMode &mode : modes)
        list.push_back(expectedFrequency_Hz(mode, shot, soundSpeeds_m_s));
    return list;
}

SpectrumResult withoutNuisancePeaks(const SpectrumResult &spectrum,
    const std::vector<WindowedResponse> &responses, const std::vector<NuisanceMode> &modes,
    const std::vector<std::optional<double>> &soundSpeeds_m_s)
{
    SpectrumResult rest = spectrum;
    std::erase_if(rest.resonances, [&](const Resonance &resonance) {
        return isNuisancePeak(resonance, responses, modes, soundSpeeds_m_s);
    });
    return rest;
}

bool hasNuisance(const ModelInput &input)
{
    return std::any_of(input.series.begin(), input.series.end(),
        [](const ModelSeries &series) { return !series.nuisance.empty(); });
}

ModelInput sensorOnly(const ModelInput &input)
{
    ModelInput rest = input;
    for (ModelSeries &series : rest.series) {
        if (series.correction.size() > 0)
            series.y += series.correction;
    }
    return rest;
}

std::vector<std::complex<double>> withoutNuisancePoles(
    const ModelInput &input, const std::vector<std::complex<double>> &poles)
{
    const double dt_s = sampleInterval_s(input);
    // A short input resolves two frequencies only if they differ by one over its length.
    const double resolution_Hz = 1.0 / (dt_s * static_cast<double>(input.samples));
    const auto isNuisance = [&](const std::complex<double> &z) {
        if (z.imag() == 0.0)
            return false;
        const double f_Hz = std::abs(continuousPole(z, dt_s)) / (2.0 * std::numbers::pi);
        return std::any_of(
            input.series.begin(), input.series.end(), [&](const ModelSeries &series) {
                return std::any_of(
                    series.nuisance.begin(), series.nuisance.end(), [&](const NuisanceTerm &term) {
                        const double mode_Hz = term.frequency_Hz();
                        return std::abs(f_Hz - mode_Hz)
                            < std::max(kPoleTolerance * mode_Hz, std::min(resolution_Hz, mode_Hz));
                    });
            });
    };
    std::vector<std::complex<double>> rest;
    std::copy_if(poles.begin(), poles.end(), std::back_inserter(rest),
        [&](const std::complex<double> &z) { return !isNuisance(z); });
    return rest;
}

Eigen::VectorXcd amplitudesOfStep(const Eigen::VectorXcd &poles_rad_s,
    const Eigen::VectorXcd &amplitudes, double constant, const std::vector<NuisanceTerm> &terms)
{
    constexpr int kRounds = 30; // each reduces the error by about the modes' relative size
    Eigen::VectorXcd found = amplitudes;
    for (int round = 0; round < kRounds; ++round) {
        Eigen::ArrayXcd input = Eigen::ArrayXcd::Ones(poles_rad_s.size());
        for (const NuisanceTerm &term : terms) {
            if (!term.startsWithStep)
                continue;
            const std::complex<double> s = term.pole_rad_s;
            const std::complex<double> gain
                = constant + (found.array() * s / (s - poles_rad_s.array())).sum();
            const std::complex<double> a = term.amplitude / gain;
            input += 0.5 * poles_rad_s.array()
                * (a / (poles_rad_s.array() - s)
                    + std::conj(a) / (poles_rad_s.array() - std::conj(s)));
        }
        found = (amplitudes.array() / input).matrix();
    }
    return found;
}

std::vector<NuisanceTerm> termsAt(const std::vector<NuisanceTerm> &terms, double onset_s)
{
    std::vector<NuisanceTerm> moved = terms;
    for (NuisanceTerm &term : moved)
        term.amplitude *= std::exp(term.pole_rad_s * onset_s);
    return moved;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/nuisance/nuisance_search.h"

#include "core/base/number_text.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/nuisance/nuisance_tail.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <utility>

namespace dyncal {
namespace {

constexpr double kFewestPeriods = 2.0; ///< below, a mode is not separable from the plateau
constexpr double kPeriodsFitted = 6.0;
constexpr double kLargestOfRate = 0.4; ///< of the record's rate

std::string nameOf(const NuisanceMode &mode, double frequency_Hz)
{
    const std::string frequency = numberWithUnit(frequency_Hz, "Hz", 4);
    return mode.label.empty() ? frequency : mode.label + " (" + frequency + ")";
}

const WindowedResponse *responseOf(const std::vector<WindowedResponse> &responses, Index shot)
{
    const auto found = std::find_if(responses.begin(), responses.end(),
        [&](const WindowedResponse &response) { return response.shot == shot; });
    return found == responses.end() ? nullptr : &*found;
}

/// Modes that the window can separate from the plateau; a finding for every other.
std::vector<NuisanceCandidate> candidatesOf(const ModelInput &input,
    const WindowedResponse &response, const std::vector<std::optional<double>> &expected_Hz,
    Findings &findings)
{
    const double window_s = static_cast<double>(response.length) / response.sampleRate_Hz;
    std::vector<NuisanceCandidate> list;
    for (std::size_t i = 0; i < expected_Hz.size(); ++i) {
        if (!expected_Hz[i])
            continue;
        const double f_Hz = *expected_Hz[i];
        const NuisanceMode &mode = input.nuisanceModes[i];
        if (f_Hz * window_s < kFewestPeriods) {
            findings.push_back({.id = "NUI-001",
                .severity = Severity::Caution,
                .shot = response.shot,
                .message
                = {DYNCAL_TEXT("core",
                       "Shot %1: the window of %2 holds %3 periods of the mode %4; below 2 it cannot be told from the plateau and stays in the response."),
                    {std::to_string(response.shot), numberWithUnit(window_s, "s", 3),
                        numberText(f_Hz * window_s, 2), nameOf(mode, f_Hz)}},
                .value = f_Hz * window_s,
                .limit = kFewestPeriods});
        } else if (f_Hz > kLargestOfRate * response.sampleRate_Hz) {
            findings.push_back({.id = "NUI-002",
                .severity = Severity::Caution,
                .shot = response.shot,
                .message
                = {DYNCAL_TEXT("core",
                       "Shot %1: the mode %2 lies above 0.4 of the sample rate of %3; it stays in the response."),
                    {std::to_string(response.shot), nameOf(mode, f_Hz),
                        numberWithUnit(response.sampleRate_Hz, "Hz", 4)}},
                .value = f_Hz,
                .limit = kLargestOfRate * response.sampleRate_Hz});
        } else {
            list.push_back({i, f_Hz});
        }
    }
    return list;
}

Finding notThere(const NuisanceMode &mode, Index shot, double frequency_Hz)
{
    return {.id = "NUI-003",
        .severity = Severity::Info,
        .shot = shot,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1: no oscillation near %2 stands out of the noise; nothing is taken out there."),
            {std::to_string(shot), nameOf(mode, frequency_Hz)}},
        .value = frequency_Hz};
}

/// First estimate from the part of the record where the sensor has settled.
void searchModes(ModelInput &input, ModelSeries &series, const WindowedResponse &response,
    const std::vector<NuisanceCandidate> &candidates)
{
    double slowest_Hz = candidates.front().frequency_Hz;
    double fastest_Hz = slowest_Hz;
    for (const NuisanceCandidate &candidate : candidates) {
        slowest_Hz = std::min(slowest_Hz, candidate.frequency_Hz);
        fastest_Hz = std::max(fastest_Hz, candidate.frequency_Hz);
    }
    const double input_s
        = series.first_s + static_cast<double>(input.samples) * sampleInterval_s(input);
    const Index wanted = static_cast<Index>(
        std::ceil(std::max(input_s, kPeriodsFitted / slowest_Hz) * series.fullRate_Hz));
    if (wanted > series.fullRate.size())
        series.fullRate = response.values.segment(response.lead, std::min(wanted, response.length));

    // After half of the model input, which is twelve ring times long, e^-6 of the ringing is left.
    const double length_s = static_cast<double>(series.fullRate.size()) / series.fullRate_Hz;
    const NuisanceTail tail = tailOf(series, std::min(0.5 * input_s, 0.5 * length_s), fastest_Hz);
    std::vector<NuisanceTerm> terms;
    for (const NuisanceCandidate &candidate : candidates) {
        const NuisanceMode &mode = input.nuisanceModes[candidate.mode];
        if (!addBestTerm(tail, candidate, mode.isTube, terms))
            input.findings.push_back(notThere(mode, series.shot, candidate.frequency_Hz));
    }
    polish(tail, isStepTreatment(input.treatment), terms);
    setNuisance(input, series, std::move(terms));
}

/// A mode given for some of the shots only.
void judgeShotsGiven(const NuisanceMode &mode, ModelInput &input)
{
    const auto given = std::ssize(mode.frequency_Hz);
    for (const ModelSeries &series : input.series) {
        if (given < 2 || series.shot <= given)
            continue;
        input.findings.push_back({.id = "NUI-005",
            .severity = Severity::Caution,
            .shot = series.shot,
            .message
            = {DYNCAL_TEXT("core",
                   "Shot %1: the mode %2 has a frequency for the shots 1 to %3 only; it stays in the response of this one."),
                {std::to_string(series.shot), nameOf(mode, mode.frequency_Hz.front()),
                    std::to_string(given)}},
            .value = static_cast<double>(given),
            .limit = static_cast<double>(series.shot)});
    }
}

/// A tube mode whose frequency cannot be carried from the shot where it was read to the others.
void judgeShotOfReading(const NuisanceMode &mode, ModelInput &input)
{
    const std::vector<std::optional<double>> &speeds = input.soundSpeeds_m_s;
    if (!mode.isTube || mode.frequency_Hz.size() != 1 || mode.shot < 1
        || std::ranges::none_of(speeds, [](const auto &speed) { return speed.has_value(); }))
        return;
    if (mode.shot <= std::ssize(speeds) && speeds[static_cast<std::size_t>(mode.shot - 1)])
        return;
    input.findings.push_back({.id = "NUI-005",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The mode %1 was read in shot %2, of which no sound speed is known: it is looked for at that frequency in every shot. Read it in another shot, or give one frequency per shot."),
            {nameOf(mode, mode.frequency_Hz.front()), std::to_string(mode.shot)}},
        .value = static_cast<double>(mode.shot)});
}

} // namespace

void setNuisance(const ModelInput &input, ModelSeries &series, std::vector<NuisanceTerm> terms)
{
    series.nuisance = std::move(terms);
    if (series.correction.size() == 0)
        series.correction = Eigen::VectorXd::Zero(series.y.size());
    for (const NuisanceTerm &term : series.nuisance) {
        const std::complex<double> s = term.pole_rad_s;
        const std::complex<double> first
            = term.amplitude * series.filter.delayedGain(s, series.first_s);
        for (Index k = 0; k < series.y.size(); ++k)
            series.correction[k]
                -= (first * std::exp(s * (static_cast<double>(k) * sampleInterval_s(input))))
                       .real();
    }
}

void searchNuisance(ModelInput &input, const std::vector<WindowedResponse> &responses)
{
    if (input.combine == CombineMethod::PcaAverage) {
        input.findings.push_back({.id = "NUI-004",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "The average of the shots has no tube modes of its own, as each shot has its own sound speed: nothing is taken out. Combine the shots as \"stacked\"."),
                {}}});
        return;
    }
    for (const NuisanceMode &mode : input.nuisanceModes) {
        judgeShotsGiven(mode, input);
        judgeShotOfReading(mode, input);
    }
    for (ModelSeries &series : input.series) {
        const WindowedResponse *response = responseOf(responses, series.shot);
        if (!response)
            continue;
        const std::vector<NuisanceCandidate> candidates = candidatesOf(input, *response,
            expectedFrequencies_Hz(input.nuisanceModes, series.shot, input.soundSpeeds_m_s),
            input.findings);
        if (!candidates.empty())
            searchModes(input, series, *response, candidates);
    }
}

} // namespace dyncal

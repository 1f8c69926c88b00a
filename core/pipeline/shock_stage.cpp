// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/shock_stage.h"

#include "core/base/number_text.h"
#include "core/project/nearest_word.h"
#include "core/shock/channel_order.h"
#include "core/shock/reading_check.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kPeakTolerance = 0.015; ///< beyond the span from the sensor's place to the gas's
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

/// A peak's place is known to a part of a bin.
double frequencyUncertainty_Hz(const PowerSpectrum &spectrum)
{
    return (spectrum.frequency_Hz[1] - spectrum.frequency_Hz[0]) / std::sqrt(12.0);
}

/// The most prominent peak between where sensor and gas would have it.
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
    Finding finding;
    finding.id = "SPC-005";
    std::vector<std::string> words{
        frequencies, numberText(peak.test.slope, 2), numberText(peak.test.u_slope, 2)};
    if (peak.candidate.empty()) {
        finding.message
            = {DYNCAL_TEXT("core",
                   "Peak %1 follows the sound speed of the gas (slope %2, u %3; of a sensor 0): a "
                   "tube mode, to be left out of the model."),
                words};
    } else {
        words.push_back(peak.candidate);
        finding.message
            = {DYNCAL_TEXT("core",
                   "Peak %1 follows the sound speed of the gas (slope %2, u %3; of a sensor 0): a "
                   "tube mode, to be left out of the model. The nearest computed is %4."),
                words};
    }
    finding.value = peak.test.slope;
    finding.limit = 1.0;
    return finding;
}

Distribution distributionCalled(const std::string &name)
{
    for (const Distribution distribution :
        {Distribution::Rectangular, Distribution::Triangular, Distribution::UShaped}) {
        if (name == distributionName(distribution))
            return distribution;
    }
    return Distribution::Normal;
}

UncertaintyRequest requestOf(const UncertaintySettings &settings)
{
    UncertaintyRequest request;
    request.evaluate = true;
    for (const BudgetEntry &entry : settings.budget)
        request.stated.push_back(
            {entry.quantity, entry.u, distributionCalled(entry.distribution), entry.dof});
    return request;
}

/// A name that is misspelt must not leave the usual uncertainty in its place without a word.
Findings unknownQuantities(const std::vector<BudgetEntry> &budget)
{
    Findings findings;
    for (const BudgetEntry &entry : budget) {
        if (std::ranges::find(statedQuantities(), entry.quantity) == statedQuantities().end())
            findings.push_back({"SHK-013", Severity::Caution, 0, {}, {},
                {DYNCAL_TEXT("core",
                     "The uncertainty of '%1' in uncertainty.budget is used for nothing; the "
                     "nearest quantity that counts is '%2'."),
                    {entry.quantity, nearestKey(entry.quantity, statedQuantities())}},
                {}, {}});
    }
    return findings;
}

/// When the DUTs felt the shock, as far as it can be known before the window is cut.
std::vector<DutArrival> startsOfDuts(
    const CaptureSet &set, const RecordStarts &starts, const std::vector<double> &typed_s)
{
    std::vector<DutArrival> arrivals;
    for (Index shot = 1; shot <= std::ssize(set.shots); ++shot) {
        const auto at = static_cast<std::size_t>(shot - 1);
        const Channel *dut = set.shots[at].channelWithRole(ChannelRole::Dut);
        const DetectedStart *start = starts.of(set, shot, dut);
        if (!set.shots[at].included || dut == nullptr)
            continue;
        if (!typed_s.empty())
            arrivals.push_back({shot, typed_s[std::min(at, typed_s.size() - 1)]});
        else if (start != nullptr)
            arrivals.push_back({shot, start->time_s});
    }
    return arrivals;
}

Finding monteCarloFailed(Index shot, const Error &error)
{
    return {"SHK-012", Severity::Caution, shot, {}, {},
        {DYNCAL_TEXT("core",
             "Shot %1: the uncertainty of the step could not be checked by Monte Carlo (%2); what "
             "the law of propagation gives may be wrong."),
            {std::to_string(shot), english(error.message)}},
        {}, {}};
}

} // namespace

Result<ExpectedShock> expectedShock(
    const CaptureSet &set, const RecordStarts &starts, const Recipe &recipe)
{
    ExpectedShock expected;
    if (!recipe.shock.enabled)
        return expected;
    const std::vector<DutArrival> arrivals = startsOfDuts(set, starts, recipe.window.start_s);
    auto conditions = estimateShockConditions(set, arrivals, recipe.shock, {}, {}, {&starts});
    if (conditions)
        expected.conditions = std::move(*conditions);
    if (recipe.shock.dutPosition == kEndWall)
        expected.findings = checkChannelOrder(set, arrivals, starts);
    return expected;
}

std::vector<DutArrival> dutArrivals(const WindowResult &window, const SensorModel &model)
{
    std::vector<DutArrival> arrivals;
    for (const WindowedResponse &response : window.responses) {
        DutArrival arrival{response.shot, response.start_s, 0.0, false};
        for (const SeriesFit &fit : model.series) {
            if (fit.shot != response.shot || !std::isfinite(fit.onset_s))
                continue;
            arrival.time_s = response.start_s + fit.onset_s;
            arrival.u_time_s = std::isfinite(fit.u_onset_s) ? fit.u_onset_s : 0.0;
            arrival.delayCorrected = true;
        }
        arrivals.push_back(arrival);
    }
    return arrivals;
}

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

Result<ShockConditionsSet> shockStage(const CaptureSet &set, const ShockConditionsSet &expected,
    const WindowResult &window, const SpectrumResult &spectrum, const SensorModel &model,
    const Recipe &recipe)
{
    if (!recipe.shock.enabled)
        return ShockConditionsSet{};
    auto shock = estimateShockConditions(set, dutArrivals(window, model), recipe.shock,
        requestOf(recipe.uncertainty), {}, {nullptr, &expected});
    if (!shock)
        return shock;
    const Findings misread = checkReadings(window.responses, *shock, recipe.checks);
    shock->findings.insert(shock->findings.end(), misread.begin(), misread.end());
    const Findings unknown = unknownQuantities(recipe.uncertainty.budget);
    shock->findings.insert(shock->findings.end(), unknown.begin(), unknown.end());
    shock->followedPeaks = followPeaks(spectrum, window, *shock);
    for (const FollowedPeak &peak : shock->followedPeaks) {
        if (peak.test.followsGas)
            shock->findings.push_back(movingPeak(peak));
    }
    return shock;
}

const ShotMonteCarlo *StepMonteCarloSet::ofShot(Index shot) const
{
    const auto found = std::find_if(
        shots.begin(), shots.end(), [&](const ShotMonteCarlo &s) { return s.shot == shot; });
    return found != shots.end() ? &*found : nullptr;
}

Result<StepMonteCarloSet> stepMonteCarlo(
    const ShockConditionsSet &shock, const UncertaintySettings &settings, const JobControl &control)
{
    const UncertaintyRequest request = requestOf(settings);
    StepMonteCarloSet set;
    for (const ShockConditions &shot : shock.shots) {
        if (!shot.measurement || !shot.uncertainty || !shot.uncertainty->u(StepResult::Step))
            continue;
        auto outcome = simulateStep(*shot.measurement, request, shot.uncertainty->budget,
            {settings.monteCarloTrials, static_cast<std::uint64_t>(settings.seed), shot.shot,
                settings.coverage},
            control);
        if (!outcome && outcome.error().kind != ErrorKind::DataBlocked)
            return tl::unexpected(outcome.error());
        set.shots.push_back({shot.shot, {}, {}});
        if (outcome) {
            set.shots.back().outcome = std::move(*outcome);
        } else {
            set.shots.back().missing = english(outcome.error().message);
            set.findings.push_back(monteCarloFailed(shot.shot, outcome.error()));
        }
    }
    return set;
}

} // namespace dyncal

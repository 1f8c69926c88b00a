// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/nuisance_modes.h"

#include "core/base/least_squares.h"
#include "core/base/number_text.h"
#include "core/realization/hankel_decomposition.h"
#include "core/realization/left_out.h"
#include "core/realization/model_draft.h"
#include "core/realization/realized_poles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kFewestPeriods = 2.0; ///< below, a mode and the plateau are one
constexpr double kPeriodsFitted = 6.0;
constexpr double kPerPeriod = 24.0; ///< samples of the search, at the fastest mode
constexpr double kLargestOfRate = 0.4; ///< of the record's rate
constexpr double kPresent = 20.0; ///< drop of the squares over their mean: far beyond any noise
constexpr Index kMostStates = 12;
constexpr int kRounds = 3;
constexpr double kSettled = 1e-4; ///< relative change of the modes' frequencies
constexpr std::array kDampings{0.0, 0.005, 0.015, 0.04, 0.1, 0.2};

Finding about(const char *id, Severity severity, Index shot, Message message,
    std::optional<double> value, std::optional<double> limit)
{
    return {id, severity, shot, {}, {}, std::move(message), value, limit};
}

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

/// A mode expected in one series, before it is found.
struct Candidate
{
    std::size_t mode;
    double frequency_Hz;
};

/// Modes that the window can tell from the plateau; a finding for every other.
std::vector<Candidate> candidatesOf(const ModelInput &input, const WindowedResponse &response,
    const std::vector<std::optional<double>> &expected_Hz, Findings &findings)
{
    const double window_s = static_cast<double>(response.length) / response.sampleRate_Hz;
    std::vector<Candidate> list;
    for (std::size_t i = 0; i < expected_Hz.size(); ++i) {
        if (!expected_Hz[i])
            continue;
        const double f_Hz = *expected_Hz[i];
        const NuisanceMode &mode = input.nuisanceModes[i];
        if (f_Hz * window_s < kFewestPeriods) {
            findings.push_back(about("NUI-001", Severity::Caution, response.shot,
                {DYNCAL_TEXT("core",
                     "Shot %1: the window of %2 holds %3 periods of the mode %4; below 2 it cannot "
                     "be told from the plateau and stays in the response."),
                    {std::to_string(response.shot), numberWithUnit(window_s, "s", 3),
                        numberText(f_Hz * window_s, 2), nameOf(mode, f_Hz)}},
                f_Hz * window_s, kFewestPeriods));
        } else if (f_Hz > kLargestOfRate * response.sampleRate_Hz) {
            findings.push_back(about("NUI-002", Severity::Caution, response.shot,
                {DYNCAL_TEXT("core",
                     "Shot %1: the mode %2 lies above 0.4 of the sample rate of %3; it stays in "
                     "the response."),
                    {std::to_string(response.shot), nameOf(mode, f_Hz),
                        numberWithUnit(response.sampleRate_Hz, "Hz", 4)}},
                f_Hz, kLargestOfRate * response.sampleRate_Hz));
        } else {
            list.push_back({i, f_Hz});
        }
    }
    return list;
}

/// The record behind a time, averaged in blocks: enough for the modes, without the sensor's.
struct Tail
{
    Eigen::VectorXd y;
    std::vector<SampleRange> used; ///< blocks without anything left out
    double begin_s = 0.0; ///< middle of the first block
    double step_s = 0.0;

    Index count() const
    {
        Index sum = 0;
        for (const SampleRange &range : used)
            sum += range.size();
        return sum;
    }
};

Tail tailOf(const ModelSeries &series, double begin_s, double fastest_Hz)
{
    const Index begin = static_cast<Index>(begin_s * series.fullRate_Hz);
    const Index block
        = std::max<Index>(1, static_cast<Index>(series.fullRate_Hz / (kPerPeriod * fastest_Hz)));
    const Index count = (series.fullRate.size() - begin) / block;
    Tail tail{Eigen::VectorXd(count), {}, 0.0, static_cast<double>(block) / series.fullRate_Hz};
    for (Index k = 0; k < count; ++k) {
        const SampleRange samples{begin + k * block, begin + (k + 1) * block};
        tail.y[k] = series.fullRate.segment(samples.begin, block).mean();
        const bool isWhole = std::none_of(series.leftOut.begin(), series.leftOut.end(),
            [&](const LeftOut &part) { return part.samples.overlaps(samples); });
        if (isWhole && !tail.used.empty() && tail.used.back().end == k)
            ++tail.used.back().end;
        else if (isWhole)
            tail.used.push_back({k, k + 1});
    }
    tail.begin_s
        = (static_cast<double>(begin) + 0.5 * static_cast<double>(block - 1)) / series.fullRate_Hz;
    return tail;
}

/// Constant and modes of these rates by least squares; returns the squares left.
double fitTail(const Tail &tail, std::vector<NuisanceTerm> &terms)
{
    const Index modes = std::ssize(terms);
    Eigen::MatrixXd basis(tail.count(), 1 + 2 * modes);
    Eigen::VectorXd y(tail.count());
    Index row = 0;
    for (const SampleRange &range : tail.used) {
        for (Index k = range.begin; k < range.end; ++k, ++row) {
            const double t_s = tail.begin_s + static_cast<double>(k) * tail.step_s;
            y[row] = tail.y[k];
            basis(row, 0) = 1.0;
            for (Index i = 0; i < modes; ++i) {
                const std::complex<double> power
                    = std::exp(terms[static_cast<std::size_t>(i)].rate_rad_s * t_s);
                basis(row, 1 + 2 * i) = power.real();
                basis(row, 2 + 2 * i) = -power.imag();
            }
        }
    }
    const Eigen::VectorXd x = leastSquares(basis, y);
    for (Index i = 0; i < modes; ++i)
        terms[static_cast<std::size_t>(i)].amplitude = {x[1 + 2 * i], x[2 + 2 * i]};
    return (y - basis * x).squaredNorm();
}

std::complex<double> rateFrom(double frequency_Hz, double zeta)
{
    return kTwoPi * frequency_Hz * std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta));
}

/// Adds the mode where it fits best near its expected frequency; false where nothing is there.
bool addBestTerm(const Tail &tail, const Candidate &candidate, bool startsWithStep,
    std::vector<NuisanceTerm> &terms)
{
    const double before = fitTail(tail, terms);
    const double periods
        = candidate.frequency_Hz * tail.step_s * static_cast<double>(tail.y.size());
    const double reach = std::clamp(0.5 / periods, 0.03, 0.15);
    const int steps = std::max(2, static_cast<int>(std::ceil(reach * periods * 8.0)));
    std::vector<NuisanceTerm> best;
    double least = before;
    for (int step = -steps; step <= steps; ++step) {
        const double f_Hz = candidate.frequency_Hz * (1.0 + reach * step / steps);
        for (const double zeta : kDampings) {
            std::vector<NuisanceTerm> tried = terms;
            tried.push_back({candidate.mode, startsWithStep, rateFrom(f_Hz, zeta), 0.0});
            const double left = fitTail(tail, tried);
            if (left < least) {
                least = left;
                best = std::move(tried);
            }
        }
    }
    const double freedom = static_cast<double>(tail.count() - 5 - 2 * std::ssize(terms));
    if (best.empty() || !(freedom > 0.0) || !((before - least) * freedom > kPresent * least))
        return false;
    terms = std::move(best);
    return true;
}

/// Rates as well, from where the search left them; amplitudes at time 0.
void polish(const Tail &tail, bool withConstant, std::vector<NuisanceTerm> &terms)
{
    const auto fit
        = refinePoles({{tail.y, 1.0 / tail.step_s, 1.0, terms, tail.used}}, {}, withConstant);
    if (!fit)
        return;
    terms = fit->nuisance.front();
    for (NuisanceTerm &term : terms)
        term.amplitude *= std::exp(-term.rate_rad_s * tail.begin_s);
}

Finding notThere(const NuisanceMode &mode, Index shot, double frequency_Hz)
{
    return about("NUI-003", Severity::Info, shot,
        {DYNCAL_TEXT("core",
             "Shot %1: no oscillation near %2 stands out of the noise; nothing is taken out "
             "there."),
            {std::to_string(shot), nameOf(mode, frequency_Hz)}},
        frequency_Hz, {});
}

/// Takes the terms out of the series at the model rate; `series.correction` holds what else is
/// corrected.
void setTerms(const ModelInput &input, ModelSeries &series, std::vector<NuisanceTerm> terms)
{
    series.nuisance = std::move(terms);
    if (series.correction.size() == 0)
        series.correction = Eigen::VectorXd::Zero(series.y.size());
    for (const NuisanceTerm &term : series.nuisance) {
        const std::complex<double> s = term.rate_rad_s;
        const std::complex<double> first
            = term.amplitude * series.filter.delayedGain(s, series.first_s);
        for (Index k = 0; k < series.y.size(); ++k)
            series.correction[k]
                -= (first * std::exp(s * (static_cast<double>(k) * sampleInterval_s(input))))
                       .real();
    }
}

/// First estimate from the part of the record where the sensor has settled.
void searchModes(ModelInput &input, ModelSeries &series, const WindowedResponse &response,
    const std::vector<Candidate> &candidates)
{
    double slowest_Hz = candidates.front().frequency_Hz;
    double fastest_Hz = slowest_Hz;
    for (const Candidate &candidate : candidates) {
        slowest_Hz = std::min(slowest_Hz, candidate.frequency_Hz);
        fastest_Hz = std::max(fastest_Hz, candidate.frequency_Hz);
    }
    const double input_s
        = series.first_s + static_cast<double>(input.samples) * sampleInterval_s(input);
    const Index wanted = static_cast<Index>(
        std::ceil(std::max(input_s, kPeriodsFitted / slowest_Hz) * series.fullRate_Hz));
    if (wanted > series.fullRate.size())
        series.fullRate = response.values.segment(response.lead, std::min(wanted, response.length));

    // Behind half of the model input, which is twelve ring times long, e^-6 of the ringing is left.
    const double length_s = static_cast<double>(series.fullRate.size()) / series.fullRate_Hz;
    const Tail tail = tailOf(series, std::min(0.5 * input_s, 0.5 * length_s), fastest_Hz);
    std::vector<NuisanceTerm> terms;
    for (const Candidate &candidate : candidates) {
        const NuisanceMode &mode = input.nuisanceModes[candidate.mode];
        if (!addBestTerm(tail, candidate, mode.isTube, terms))
            input.findings.push_back(notThere(mode, series.shot, candidate.frequency_Hz));
    }
    polish(tail, isStepTreatment(input.treatment), terms);
    setTerms(input, series, std::move(terms));
}

/// Poles of one order as rates, where all of them decay.
std::vector<std::complex<double>> sensorRates(
    const ModelInput &input, const HankelDecomposition &hankel, Index order)
{
    std::vector<std::complex<double>> rates;
    for (const std::complex<double> &z :
        withoutNuisancePoles(input, realizedPoles(hankel, order))) {
        if (!(std::abs(z) < 1.0) || (z.imag() == 0.0 && z.real() <= 0.0))
            return {};
        rates.push_back(rateOf(z, sampleInterval_s(input)));
    }
    return rates;
}

/// Sensor and modes together, with the suggested order of `rest`, the response without the modes.
/// What a first estimate of a mode has left of it may be taken for a state of the sensor; then the
/// next lower order that converges serves, as the modes are better known behind it.
std::optional<Refinement> jointFit(
    const ModelInput &input, const ModelInput &rest, const JobControl &control)
{
    const auto hankel = decomposeHankel(rest, {}, control);
    if (!hankel)
        return std::nullopt;
    Index order = std::min(kMostStates, suggestOrder(rest, *hankel).order);
    for (; order >= 1 && !control.stopRequested(); --order) {
        const auto rates = sensorRates(input, *hankel, order);
        if (rates.empty())
            continue;
        if (auto fit = refinePoles(
                refinementRecords(input), rates, isStepTreatment(input.treatment), control))
            return fit;
    }
    return std::nullopt;
}

/// The better of the fits that begin with the bridged response and with a run of it that needs no
/// bridge: a straight line across a ringing is a poor one.
std::optional<Refinement> bestFit(const ModelInput &input, const JobControl &control)
{
    const ModelInput rest = sensorOnly(input);
    std::optional<Refinement> best = jointFit(input, rest, control);
    if (input.leftOut.empty())
        return best;
    const ModelInput run = cleanRun(rest);
    if (run.series.empty())
        return best;
    std::optional<Refinement> other = jointFit(input, run, control);
    if (!best || (other && other->residualToNoise < best->residualToNoise))
        return other;
    return best;
}

/// The series as the joint fit has them; the largest relative change of a mode's frequency.
double takeFit(ModelInput &input, const Refinement &fit)
{
    double change = 0.0;
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        ModelSeries &series = input.series[r];
        const std::vector<NuisanceTerm> before = series.nuisance;
        series.nuisance = fit.nuisance[r];
        for (std::size_t i = 0; i < before.size(); ++i) {
            change = std::max(change,
                std::abs(series.nuisance[i].frequency_Hz() / before[i].frequency_Hz() - 1.0));
        }
        series.correction
            = series.leftOut.empty() ? Eigen::VectorXd() : bridge(series, fit.records[r]);
        if (!series.nuisance.empty())
            setTerms(input, series, series.nuisance);
    }
    return change;
}

/// A mode given for some of the shots only.
void judgeShotsGiven(const NuisanceMode &mode, ModelInput &input)
{
    const auto given = std::ssize(mode.frequency_Hz);
    for (const ModelSeries &series : input.series) {
        if (given < 2 || series.shot <= given)
            continue;
        input.findings.push_back(about("NUI-005", Severity::Caution, series.shot,
            {DYNCAL_TEXT("core",
                 "Shot %1: the mode %2 has a frequency for the shots 1 to %3 only; it stays in the "
                 "response of this one."),
                {std::to_string(series.shot), nameOf(mode, mode.frequency_Hz.front()),
                    std::to_string(given)}},
            static_cast<double>(given), static_cast<double>(series.shot)));
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
    input.findings.push_back(about("NUI-005", Severity::Caution, 0,
        {DYNCAL_TEXT("core",
             "The mode %1 was read in shot %2, of which no sound speed is known: it is looked for "
             "at that frequency in every shot. Read it in another shot, or give one frequency per "
             "shot."),
            {nameOf(mode, mode.frequency_Hz.front()), std::to_string(mode.shot)}},
        static_cast<double>(mode.shot), {}));
}

/// The modes of every series, as far as they can be found in its tail.
void searchAll(ModelInput &input, const std::vector<WindowedResponse> &responses)
{
    if (input.combine == CombineMethod::PcaAverage) {
        input.findings.push_back(about("NUI-004", Severity::Caution, 0,
            {DYNCAL_TEXT("core",
                 "The average of the shots has no tube modes of its own, as each shot has its own "
                 "sound speed: nothing is taken out. Combine the shots as \"stacked\"."),
                {}},
            {}, {}));
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
        const std::vector<Candidate> candidates = candidatesOf(input, *response,
            expectedFrequencies_Hz(input.nuisanceModes, series.shot, input.soundSpeeds_m_s),
            input.findings);
        if (!candidates.empty())
            searchModes(input, series, *response, candidates);
    }
}

} // namespace

void separateNuisance(ModelInput &input, const std::vector<WindowedResponse> &responses,
    const std::vector<NuisanceMode> &modes,
    const std::vector<std::optional<double>> &soundSpeeds_m_s, const JobControl &control)
{
    input.nuisanceModes = modes;
    input.soundSpeeds_m_s = soundSpeeds_m_s;
    if (!modes.empty())
        searchAll(input, responses);
    if (!hasNuisance(input) && input.leftOut.empty())
        return;
    for (int round = 0; round < kRounds; ++round) {
        const auto fit = bestFit(input, control);
        if (!fit)
            break;
        const double change = takeFit(input, *fit);
        // A bridge is only as good as the fit before: one round more than for modes alone.
        if (change < kSettled && (input.leftOut.empty() || round > 0))
            break;
    }
}

} // namespace dyncal

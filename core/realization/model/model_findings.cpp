// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_findings.h"

#include "core/base/number_text.h"
#include "core/realization/hankel/hankel_gap.h"
#include "core/realization/refinement/refinement_problem.h"
#include "core/realization/refinement/series_simulation.h"
#include "core/signal/spectrum_analysis.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kGoodShare = 0.8; ///< of the attainable FIT
constexpr double kOverFit_points = 2.0;
constexpr double kNoiseLimit_percent = 10.0; ///< below, FIT is meaningless
constexpr double kSameFrequency = 0.02;
constexpr double kCancelling = 1e-3;
constexpr std::size_t kMostNamed = 4; ///< poles in one sentence
constexpr double kMissingFast = 0.1; ///< of the plateau, at the onset
constexpr double kFarOff = 10.0; ///< plateaus at the onset; a larger number means nothing
constexpr double kStepPole = 1e-3; ///< from 1, in the z plane
constexpr double kLikeAStep = 0.1; ///< of the largest amplitude

Correction useOrder(Index order)
{
    return {.label = {DYNCAL_TEXT("core", "Use order %1"), {std::to_string(order)}},
        .key = "realization.order",
        .value = std::to_string(order)};
}

void judgeSplit(const SensorModel &model, const HankelDecomposition &decomposition, Findings &out)
{
    const Index n = model.order;
    const Eigen::VectorXd &sigma = decomposition.singularValues;
    if (model.secondOrder || !splitsPair(decomposition, n))
        return;
    out.push_back({.id = "ORD-001",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "Order %1 splits an oscillating pair (singular values %1 and %2 are %3 and %4). Order %2 keeps it."),
            {std::to_string(n), std::to_string(n + 1), numberText(sigma[n - 1], 4),
                numberText(sigma[n], 4)}},
        .value = sigma[n - 1] / sigma[n]});
    out.back().correction = useOrder(n + 1);
}

void judgeNoiseStates(
    const SensorModel &model, const HankelDecomposition &decomposition, Findings &out)
{
    const Index n = model.order;
    const Eigen::VectorXd &sigma = decomposition.singularValues;
    const double floor = decomposition.noiseFloor_p95;
    // The second-order sensor was not read off the singular values.
    if (model.secondOrder || n > sigma.size() || !(floor > 0.0) || sigma[n - 1] >= floor)
        return;
    const Index above = (sigma.array() > floor).count();
    out.push_back({.id = "ORD-003",
        .severity = Severity::Caution,
        .message = {above > 0
                ? DYNCAL_TEXT("core",
                    "Order %1 has states at the noise level: singular value %1 is %3, noise alone reaches %4. Order %2 is the highest above it.")
                : DYNCAL_TEXT("core",
                    "Order %1 has states at the noise level: singular value %1 is %3, noise alone reaches %4. No value is above it: the response holds nothing that could be identified."),
            {std::to_string(n), std::to_string(above), numberText(sigma[n - 1], 3),
                numberText(floor, 3)}},
        .value = static_cast<double>(n),
        .limit = static_cast<double>(above)});
    if (above > 0)
        out.back().correction = useOrder(above);
}

/// Frequencies of some poles, a pair once: "1.2 MHz, 3.4 MHz, ...".
std::string frequenciesOf(const std::vector<const Pole *> &poles)
{
    std::string list;
    for (std::size_t i = 0; i < std::min(poles.size(), kMostNamed); ++i)
        list += std::string(i > 0 ? ", " : "") + numberWithUnit(poles[i]->frequency_Hz, "Hz", 4);
    return poles.size() > kMostNamed ? list + ", \xE2\x80\xA6" : list;
}

/// Poles that fulfil the condition, each pair once.
template <typename Condition>
std::vector<const Pole *> polesWhere(const SensorModel &model, Condition condition)
{
    std::vector<const Pole *> found;
    for (const Pole &pole : model.poles) {
        if (pole.z.imag() >= 0.0 && condition(pole))
            found.push_back(&pole);
    }
    return found;
}

std::vector<const Pole *> polesOfClass(const SensorModel &model, PoleClass poleClass)
{
    return polesWhere(model, [&](const Pole &pole) { return pole.poleClass == poleClass; });
}

void judgeUnstable(const SensorModel &model, Findings &out)
{
    const std::vector<const Pole *> poles = polesOfClass(model, PoleClass::Unstable);
    if (poles.empty())
        return;
    double largest = 0.0;
    for (const Pole *pole : poles)
        largest = std::max(largest, std::abs(pole->z));
    out.push_back({.id = "MOD-001",
        .severity = Severity::Block,
        .message
        = {DYNCAL_TEXT("core",
               "The model of order %1 is unstable: poles that grow, at %2, the largest of magnitude %3 (at most 1). It is not reportable; choose another order."),
            {std::to_string(model.order), frequenciesOf(poles), numberText(largest, 7)}},
        .value = largest,
        .limit = 1.0});
}

void judgeNyquist(const SensorModel &model, const ModelInput &input, Findings &out)
{
    const std::vector<const Pole *> poles = polesOfClass(model, PoleClass::Nyquist);
    if (poles.empty())
        return;
    out.push_back({.id = "MOD-002",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "Poles at the Nyquist frequency, %1: %2. Dynamics there come from sampling, not from the sensor; a lower order or a higher model rate is without them."),
            {numberWithUnit(input.sampleRate_Hz / 2.0, "Hz", 4), frequenciesOf(poles)}},
        .value = poles.front()->z.real()});
}

void judgeStepPole(const SensorModel &model, const ModelInput &input, Findings &out)
{
    for (const Pole *pole : polesOfClass(model, PoleClass::Step))
        out.push_back({.id = "MOD-003",
            .severity = Severity::Info,
            .message = {DYNCAL_TEXT("core", "The pole at z = %1 is the step itself."),
                {numberText(pole->z.real(), 9)}}});
    if (input.treatment != ResponseTreatment::Impulse)
        return;
    const auto constants = polesWhere(model, [&](const Pole &pole) {
        return pole.z.imag() == 0.0 && std::abs(pole.z - 1.0) < kStepPole
            && pole.amplitude > kLikeAStep * model.amplitudes.cwiseAbs().maxCoeff();
    });
    if (constants.empty())
        return;
    out.push_back({.id = "MOD-013",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The response is treated as a free decay but stays at a level: a pole at z = %1. Treat it as a step, or the step becomes a part of the sensor."),
            {numberText(constants.front()->z.real(), 9)}},
        .value = constants.front()->z.real(),
        .limit = 1.0 - kStepPole});
    out.back().correction = Correction{.label = {DYNCAL_TEXT("core", "Treat as a step"), {}},
        .key = "input.treatment",
        .value = "\"step-deflated\""};
}

bool isCancelled(const Pole &pole, const std::vector<std::complex<double>> &zeros)
{
    return std::any_of(zeros.begin(), zeros.end(),
        [&](const auto &zero) { return std::abs(zero - pole.z) < kCancelling; });
}

void judgeCancelling(const SensorModel &model, Findings &out)
{
    const auto cancelled
        = polesWhere(model, [&](const Pole &pole) { return isCancelled(pole, model.zeros); });
    if (cancelled.empty())
        return;
    out.push_back({.id = "MOD-005",
        .severity = Severity::Info,
        .message
        = {DYNCAL_TEXT("core", "Poles nearly cancelled by zeros: %1 (%2). A lower order may do."),
            {std::to_string(cancelled.size()), frequenciesOf(cancelled)}},
        .value = static_cast<double>(cancelled.size())});
}

void judgeFit(const SensorModel &model, Findings &out)
{
    const double attainable = model.fitAttainable_percent;
    if (model.diverges || !(attainable > kNoiseLimit_percent))
        return;
    const std::vector<std::string> words{
        fitPercentText(model.fit_percent), fitPercentText(attainable)};
    if (model.fit_percent < kGoodShare * attainable) {
        out.push_back({.id = "MOD-004",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "FIT is %1 % where the noise allows %2 %: the model misses part of the response. Choose a higher order; the error shows what is missing."),
                words},
            .value = model.fit_percent,
            .limit = kGoodShare * attainable});
    } else if (model.fit_percent > attainable + kOverFit_points) {
        out.push_back({.id = "MOD-008",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "FIT %1 % is above the %2 % that the noise allows: order %3 also fits noise."),
                {words[0], words[1], std::to_string(model.order)}},
            .value = model.fit_percent,
            .limit = attainable});
    }
}

void judgeAgainstSpectrum(const SensorModel &model, const SpectrumResult &spectrum, Findings &out)
{
    if (spectrum.resonances.empty() || model.diverges)
        return;
    const double seen_Hz = spectrum.resonances.front().frequency_Hz;
    double nearest_Hz = 0.0;
    for (const Pole &pole : model.poles) {
        if (pole.poleClass != PoleClass::Sensor || pole.z.imag() <= 0.0)
            continue;
        // The spectrum of a ringing peaks at the damped frequency, not at |s| / 2 pi.
        const double ringing_Hz = pole.frequency_Hz
            * std::sqrt(std::max(0.0, 1.0 - pole.dampingRatio * pole.dampingRatio));
        if (std::abs(ringing_Hz - seen_Hz) < std::abs(nearest_Hz - seen_Hz))
            nearest_Hz = ringing_Hz;
    }
    if (std::abs(nearest_Hz - seen_Hz) > kSameFrequency * seen_Hz) {
        out.push_back({.id = "MOD-006",
            .severity = Severity::Caution,
            .message = {nearest_Hz > 0.0
                    ? DYNCAL_TEXT("core",
                        "The spectrum's resonance at %1 is not in the model, whose nearest lies at %2 (2 % apart at most). Choose another order or model rate.")
                    : DYNCAL_TEXT("core",
                        "The spectrum's resonance at %1 is not in the model, which has none. Choose a higher order."),
                {numberWithUnit(seen_Hz, "Hz", 4), numberWithUnit(nearest_Hz, "Hz", 4)}},
            .value = nearest_Hz,
            .limit = seen_Hz});
    }
}

/// Share of the plateau at which the model starts. Poles in the noise do not count: a fast one,
/// extrapolated to the onset, has an arbitrary value.
double shareAtOnset(const SensorModel &model)
{
    double value = model.plateauGain;
    for (Index i = 0; i < model.amplitudes.size(); ++i) {
        const auto &flags = model.poles[static_cast<std::size_t>(i)].flags;
        if (std::ranges::find(flags, kBelowNoiseFlag) == flags.end())
            value += model.amplitudes[i].real();
    }
    return std::abs(value / model.level());
}

/// A sensor cannot jump: a model that starts far from 0 lacks its fastest part.
void judgeOnset(const SensorModel &model, const ModelInput &input, Findings &out)
{
    if (!isStepTreatment(input.treatment) || model.diverges || !(std::abs(model.level()) > 0.0))
        return;
    const double atOnset = shareAtOnset(model);
    if (atOnset > kMissingFast) {
        out.push_back({.id = "MOD-009",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "The model starts at %1 % of the step instead of 0: a fast part of the response is missing; raise the model rate or the order."),
                {atOnset > kFarOff ? "> " + numberText(100.0 * kFarOff, 3)
                                   : numberText(100.0 * atOnset, 3)}},
            .value = atOnset,
            .limit = kMissingFast});
    }
}

std::string timeConstant(const Pole &pole)
{
    return numberWithUnit(1.0 / std::abs(pole.s_rad_s), "s", 2);
}

/// What a gain that depends on the level makes of ringing is a decay of its own, twice as fast as
/// the ringing's (its square), and looks like heat.
void judgeRectified(const SensorModel &model, const Pole &drift, Findings &out)
{
    constexpr double kLikeTwice = 0.25;
    constexpr double kLeastShare = 0.001;
    const double rate = drift.s_rad_s.real();
    const auto isSquare = [&](const Pole &pole) {
        return pole.poleClass == PoleClass::Sensor && pole.s_rad_s.imag() != 0.0
            && std::abs(rate / (2.0 * pole.s_rad_s.real()) - 1.0) < kLikeTwice;
    };
    if (std::abs(model.drift) < kLeastShare || std::ranges::none_of(model.poles, isSquare))
        return;
    out.push_back({.id = "MOD-018",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The drift of %1 % behind the step dies out twice as fast as the sensor rings (time constant %2): a sensor or an amplifier whose gain depends on the level makes that of its own ringing, and then the sensitivity, S(f) and overshoot are wrong by up to as much. Compare shots of different levels, or with the static sensitivity."),
            {numberText(100.0 * model.drift, 2), timeConstant(drift)}},
        .value = model.drift,
        .limit = kLeastShare,
        .causes = {FindingCause::Drift}});
}

/// What is slower than the sensor: told apart from its step, or too fast for that.
void judgeDrift(const SensorModel &model, Findings &out)
{
    if (!model.slowPoles.empty()) {
        const Pole &pole = model.poles[static_cast<std::size_t>(model.slowPoles.front())];
        out.push_back({.id = "MOD-014",
            .message
            = {DYNCAL_TEXT("core",
                   "Behind the step the response drifts by %1 % until the end of the model input, with a time constant of about %2: slower than the sensor, so no part of its step (heat of the gas, an AC coupling). The sensitivity is that of the level at the onset, before the drift."),
                {numberText(100.0 * model.drift, 2), timeConstant(pole)}},
            .value = model.drift,
            .causes = {FindingCause::Drift}});
        judgeRectified(model, pole, out);
    }
    if (model.doubtfulPole) {
        const Pole &pole = model.poles[static_cast<std::size_t>(*model.doubtfulPole)];
        out.push_back({.id = "MOD-015",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "A part of the response with a time constant of %1 may be the sensor's own or a drift (heat of the gas, an AC coupling): it is less than ten times slower than the rest. It counts as the sensor's own; as a drift it would change the sensitivity by %2 %. Compare with a shot of another step, or with the static sensitivity."),
                {timeConstant(pole), numberText(100.0 * model.doubtfulShare, 2)}},
            .value = model.doubtfulShare,
            .causes = {FindingCause::Drift}});
    }
}

/// The slowest real pole that has not died out by the end of the model input; null if none has.
const Pole *unsettledPole(const SensorModel &model, const ModelInput &input)
{
    const double length_s = static_cast<double>(input.samples) * sampleInterval_s(input);
    const Pole *slowest = nullptr;
    for (const Pole &pole : model.poles) {
        const bool counts
            = pole.poleClass == PoleClass::Sensor || pole.poleClass == PoleClass::Unstable;
        if (counts && pole.s_rad_s.imag() == 0.0 && isRelaxing(pole.s_rad_s.real() * length_s)
            && (!slowest || pole.frequency_Hz < slowest->frequency_Hz))
            slowest = &pole;
    }
    return slowest;
}

/// Without the refinement nobody knows whether a slow part is a drift.
void judgeUnrefinedDrift(const SensorModel &model, const ModelInput &input, Findings &out)
{
    if (model.refined || !isStepTreatment(input.treatment) || isThesisMode(input))
        return;
    const Pole *pole = unsettledPole(model, input);
    if (!pole)
        return;
    out.push_back({.id = "MOD-016",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "A part of the response with a time constant of about %1 has not ended within the model input, and the model could not be refined, so that it is unknown whether it is a drift (heat of the gas, an AC coupling). The sensitivity is that of the level to which the model tends, an extrapolation. Choose another order, or let the model be refined."),
            {timeConstant(*pole)}},
        .value = -1.0 / pole->s_rad_s.real(),
        .causes = {FindingCause::Drift, FindingCause::Order}});
}

} // namespace

void flagPoles(const std::vector<std::complex<double>> &zeros, std::vector<Pole> &poles)
{
    for (Pole &pole : poles) {
        if (pole.poleClass == PoleClass::Step || pole.poleClass == PoleClass::Nyquist
            || pole.poleClass == PoleClass::Unstable)
            pole.flags.push_back(poleClassName(pole.poleClass));
        const bool isDrift = std::ranges::find(pole.flags, kDriftFlag) != pole.flags.end();
        if (!isDrift && isCancelled(pole, zeros))
            pole.flags.push_back("near-cancelled");
        if (pole.poleClass != PoleClass::Step && pole.z.imag() == 0.0
            && pole.frequency_Hz <= pole.u_frequency_Hz)
            pole.flags.push_back("integrator");
    }
}

Findings judgeModel(const SensorModel &model, const ModelInput &input,
    const HankelDecomposition &decomposition, const SpectrumResult &spectrum)
{
    Findings findings;
    judgeSplit(model, decomposition, findings);
    judgeNoiseStates(model, decomposition, findings);
    judgeUnstable(model, findings);
    judgeNyquist(model, input, findings);
    judgeStepPole(model, input, findings);
    judgeCancelling(model, findings);
    judgeFit(model, findings);
    judgeAgainstSpectrum(model, spectrum, findings);
    judgeOnset(model, input, findings);
    judgeDrift(model, findings);
    judgeUnrefinedDrift(model, input, findings);
    return findings;
}

} // namespace dyncal

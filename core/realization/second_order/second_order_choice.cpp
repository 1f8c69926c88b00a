// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order/second_order_choice.h"

#include "core/base/number_text.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/input/whitening.h"
#include "core/realization/nuisance/nuisance_modes.h"
#include "core/realization/refinement/aperiodic_start.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/fit_residual.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dyncal {
namespace {

/// What one record shows at a glance.
struct Glance
{
    double plateau = 0.0;
    double delay_s = 0.0; ///< area between plateau and response, over the plateau: 2 zeta/w0
    bool overshoots = false; ///< more than a damping ratio of 0.75 does
};

Glance glanceAt(const RefinementRecord &record)
{
    constexpr double kOvershoot = 0.05; // 2.8 % at 0.75, 0.15 % at 0.9
    constexpr double kNoise = 6.0; // standard deviations
    constexpr double kThere = 0.98; // of the plateau: behind it the area is noise and drift
    const Eigen::VectorXd &y = record.y;
    Glance glance{y.tail(std::max<Index>(1, y.size() / 10)).mean(), 0.0, false};
    const double sign = glance.plateau < 0.0 ? -1.0 : 1.0;
    const double height = std::abs(glance.plateau);
    glance.overshoots
        = (sign * y).maxCoeff() > (1.0 + kOvershoot) * height + kNoise / record.weight;
    for (Index k = 0; k < y.size() && sign * y[k] < kThere * height; ++k)
        glance.delay_s += (1.0 - y[k] / glance.plateau) / record.rate_Hz;
    return glance;
}

/// Pairs and real poles of the delay that the records show; empty where one of them overshoots.
std::vector<SecondOrderStart> startsFor(const std::vector<RefinementRecord> &records)
{
    std::vector<double> plateaus;
    double delay_s = 0.0;
    for (const RefinementRecord &record : records) {
        const Glance glance = glanceAt(record);
        if (glance.overshoots || !(glance.delay_s > 0.0))
            return {};
        plateaus.push_back(glance.plateau);
        delay_s += glance.delay_s / static_cast<double>(records.size());
    }
    std::vector<SecondOrderStart> starts;
    for (const double zeta : {0.9, 1.2, 2.5})
        starts.push_back({2.0 * zeta / delay_s / (2.0 * std::numbers::pi), zeta, plateaus,
            std::vector<double>(records.size(), 0.0)});
    return starts;
}

/// Without a drift and with that of the draft, which its own plateau and poles come with.
std::vector<std::vector<SecondOrderStart>> startsToTry(
    const std::vector<RefinementRecord> &records, const ModelDraft &draft)
{
    std::vector<std::vector<SecondOrderStart>> all{startsFor(records)};
    const auto drift = driftOf(draft);
    if (!drift || all.front().empty())
        return all;
    std::vector<SecondOrderStart> drifting = all.front();
    for (SecondOrderStart &start : drifting) {
        start.drift = drift;
        for (std::size_t r = 0; r < start.plateau.size(); ++r)
            start.plateau[r] = draft.series[r].constant;
    }
    all.push_back(std::move(drifting));
    return all;
}

/// Smallest mean square of a residual that says anything: rounding errors that noise does not
/// randomise have no spectrum of their own, so their largest square counts.
double informationFloor(const ModelSeries &series)
{
    constexpr double kArithmetic = 1e-11; // of the largest value
    const double least = kArithmetic * series.fullRate.cwiseAbs().maxCoeff();
    const double rounding
        = roundingCounts(series) ? 3.0 * std::pow(series.fullRateNoiseSd, 2) : 0.0;
    return std::max(least * least, rounding);
}

/// Responses of all records, and what they cost.
struct Description
{
    const std::vector<ExponentialSum> &series;
    const std::vector<std::vector<NuisanceTerm>> &nuisance;
    Index parameters = 0;
};

Index termsOf(const std::vector<std::vector<NuisanceTerm>> &nuisance)
{
    Index terms = 0;
    for (const auto &list : nuisance)
        terms += std::ssize(list);
    return terms;
}

Description descriptionOf(const ModelDraft &draft)
{
    const Index poles = std::ssize(draft.poles_rad_s);
    const Index own = std::ssize(draft.series) * (poles + 1);
    return {draft.series, draft.nuisance, poles + own + 4 * termsOf(draft.nuisance)};
}

/// BIC on the records, whitened by the models of the noise before the start.
double whitenedBic(const ModelInput &input, const std::vector<RefinementRecord> &records,
    const std::vector<AutoregressiveModel> &noise, const Description &description)
{
    double bic = 0.0;
    double samples = 0.0;
    for (std::size_t r = 0; r < records.size(); ++r) {
        const Eigen::VectorXd residual
            = whitened(fitResidual(records[r], description.series[r], description.nuisance[r]),
                noise[r].coefficients);
        const auto count = static_cast<double>(residual.size());
        const double meanSquare = residual.squaredNorm() / count;
        bic += count * std::log(std::max(meanSquare, informationFloor(input.series[r])));
        samples += count;
    }
    return bic + static_cast<double>(description.parameters) * std::log(samples);
}

/// Whether the fit says anything of these records at all.
bool isEligible(const SecondOrderFit &fit, const ModelDraft &draft)
{
    constexpr double kDescribes = 1.2; // residual over noise, where nothing else was refined
    return fit.sensor.zeta >= kLeastDamping
        && (draft.refinement || fit.sensor.residualToNoise <= kDescribes);
}

} // namespace

std::vector<SecondOrderRival> secondOrderRivals(
    const ModelInput &input, const ModelDraft &draft, const JobControl &control)
{
    if (!isStepTreatment(input.treatment) || isThesisMode(input))
        return {};
    const std::vector<RefinementRecord> records = refinementRecords(input, draft);
    std::vector<SecondOrderFit> fits;
    for (const std::vector<SecondOrderStart> &starts : startsToTry(records, draft))
        if (auto fit = fitSecondOrder(input, records, starts, control);
            fit && isEligible(*fit, draft))
            fits.push_back(std::move(*fit));
    if (fits.empty())
        return {};
    const std::vector<AutoregressiveModel> noise
        = chooseAutoregressiveModels(noiseBeforeStart(input), kLargestNoiseModel);
    const double ofDraft = whitenedBic(input, records, noise, descriptionOf(draft));
    std::vector<SecondOrderRival> rivals;
    for (SecondOrderFit &fit : fits) {
        const double bic = whitenedBic(input, records, noise,
            {fit.refinement.records, fit.refinement.nuisance, fit.parameters});
        const bool canStand = areWithin(records, fit.refinement.poles_rad_s);
        const bool addsPole = fit.refinement.poles_rad_s.size() > draft.poles_rad_s.size();
        rivals.push_back({std::move(fit), canStand ? ofDraft - bic : -HUGE_VAL, addsPole});
    }
    return rivals;
}

const SecondOrderRival *leader(const std::vector<SecondOrderRival> &rivals, Index mostPoles)
{
    constexpr double kVeryStrong = 10.0; // evidence: Kass & Raftery, J. Am. Stat. Assoc. 90 (1995)
    const SecondOrderRival *best = nullptr;
    for (const SecondOrderRival &rival : rivals) {
        const double needed = rival.addsPole ? kVeryStrong : 0.0;
        if (rival.poles() <= mostPoles && rival.lead > std::max(needed, best ? best->lead : 0.0))
            best = &rival;
    }
    return best;
}

void allowForSecondPole(const std::vector<SecondOrderRival> &rivals, ModelDraft &draft)
{
    const Index drifts = driftOf(draft) ? 1 : 0;
    const Index poles = std::ssize(draft.poles_rad_s);
    if (!draft.refinement || poles != drifts + 1)
        return;
    for (const SecondOrderRival &rival : rivals) {
        const auto &s = rival.fit.refinement.poles_rad_s;
        const std::complex<double> slow = s[static_cast<std::size_t>(drifts)];
        if (rival.poles() != poles + 1 || slow.imag() != 0.0)
            continue;
        const double difference = slow.real() - draft.poles_rad_s.back().real();
        draft.refinement->covariance(drifts, drifts) += difference * difference;
        for (const SecondOrderShot &shot : rival.fit.sensor.shots)
            draft.onsetsOfSecondPole_s.push_back(shot.onset_s);
    }
}

std::optional<DriftStart> driftOf(const ModelDraft &draft)
{
    constexpr double kSlower = 0.1;
    const auto &poles = draft.poles_rad_s;
    const auto slowest = std::ranges::min_element(
        poles, {}, [](const std::complex<double> &s) { return std::abs(s); });
    if (poles.size() < 2 || slowest->imag() != 0.0)
        return std::nullopt;
    for (auto pole = poles.begin(); pole != poles.end(); ++pole)
        if (pole != slowest && std::abs(*slowest) > kSlower * std::abs(*pole))
            return std::nullopt;
    DriftStart drift{slowest->real(), {}};
    for (const ExponentialSum &series : draft.series)
        drift.amplitude.push_back(series.amplitudes[slowest - poles.begin()].real());
    return drift;
}

void takeSecondOrder(const SecondOrderFit &fit, ModelDraft &draft)
{
    draft.refinement = fit.refinement;
    draft.noise = fit.noise;
    draft.poles_rad_s = fit.refinement.poles_rad_s;
    draft.series = fit.refinement.records;
    draft.nuisance = fit.refinement.nuisance;
    draft.onsets.clear();
    for (const SecondOrderShot &shot : fit.sensor.shots)
        draft.onsets.push_back({shot.onset_s, shot.u_onset_s});
}

void considerSecondOrder(const ModelInput &input, const HankelDecomposition &decomposition,
    OrderSuggestion &suggestion, const JobControl &control)
{
    constexpr Index kWithDrift = 3;
    if (isThesisMode(input) || largestOrder(decomposition) < std::max(kWithDrift, suggestion.order))
        return;
    ModelDraft draft = linearDraft(
        input, withoutNuisancePoles(input, realizedPoles(decomposition, suggestion.order)));
    if (!isStepTreatment(input.treatment) || startsFor(refinementRecords(input)).empty())
        return;
    refineDraft(input, draft, control);
    const auto rivals = secondOrderRivals(input, draft, control);
    const SecondOrderRival *best = leader(rivals, kWithDrift);
    if (!best || best->poles() == suggestion.order)
        return;
    suggestion.reason = {
        DYNCAL_TEXT("core",
            "A second-order sensor (damping ratio %1) describes the records better than order %2, by their BIC: of a response damped that much the realised poles tell little."),
        {numberText(best->fit.sensor.zeta, 3), std::to_string(suggestion.order)}};
    suggestion.order = best->poles();
}

} // namespace dyncal

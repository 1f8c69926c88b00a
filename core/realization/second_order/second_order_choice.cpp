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

constexpr double kLeastDamping = 0.75; ///< below it the free poles are known well enough

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

/// Whether the fit may stand for these records at all.
bool isEligible(const SecondOrderFit &fit, const ModelDraft &draft,
    const std::vector<RefinementRecord> &records)
{
    constexpr double kDescribes = 1.2; // residual over noise, where nothing else was refined
    return fit.sensor.zeta >= kLeastDamping && areWithin(records, fit.refinement.poles_rad_s)
        && (draft.refinement || fit.sensor.residualToNoise <= kDescribes);
}

} // namespace

std::optional<SecondOrderFit> betterSecondOrder(
    const ModelInput &input, const ModelDraft &draft, const JobControl &control)
{
    if (!isStepTreatment(input.treatment) || isThesisMode(input))
        return std::nullopt;
    const std::vector<RefinementRecord> records = refinementRecords(input, draft);
    auto fit = fitSecondOrder(input, records, startsFor(records), control);
    if (!fit || !isEligible(*fit, draft, records))
        return std::nullopt;
    const std::vector<AutoregressiveModel> noise
        = chooseAutoregressiveModels(noiseBeforeStart(input), kLargestNoiseModel);
    const double lead = whitenedBic(input, records, noise, descriptionOf(draft))
        - whitenedBic(input, records, noise,
            {fit->refinement.records, fit->refinement.nuisance, fit->parameters});
    return lead > 0.0 ? std::move(fit) : std::nullopt;
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
    constexpr Index kOrder = 2;
    if (suggestion.order == kOrder || isThesisMode(input)
        || largestOrder(decomposition) < std::max(kOrder, suggestion.order))
        return;
    ModelDraft draft = linearDraft(
        input, withoutNuisancePoles(input, realizedPoles(decomposition, suggestion.order)));
    if (!isStepTreatment(input.treatment) || startsFor(refinementRecords(input)).empty())
        return;
    refineDraft(input, draft, control);
    const auto better = betterSecondOrder(input, draft, control);
    if (!better)
        return;
    suggestion.reason = {
        DYNCAL_TEXT("core",
            "A second-order sensor (damping ratio %1) describes the records better than order %2, by their BIC: of a response damped that much the realised poles tell little."),
        {numberText(better->sensor.zeta, 3), std::to_string(suggestion.order)}};
    suggestion.order = kOrder;
}

} // namespace dyncal

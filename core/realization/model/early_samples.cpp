// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/early_samples.h"

#include "core/base/distributions.h"
#include "core/base/number_text.h"
#include "core/realization/refinement/coloured_covariance.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/fit_residual.h"
#include "core/realization/refinement/pole_refinement.h"
#include "core/realization/refinement/pole_uncertainty.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kProbability = 1e-4;

/// Periods of the main resonance that the shorter fit leaves out. A front is short, and a hammer's
/// contact lasts; of a decay the longest is taken that leaves enough of it.
double skippedPeriods(const Pole &main, bool isDecay)
{
    constexpr double kOfStep = 0.35;
    constexpr double kOfDecay = 2.0;
    constexpr double kTimeConstants = 0.5;
    const double timeConstant = 1.0 / (2.0 * std::numbers::pi * main.dampingRatio); // in periods
    return isDecay ? std::clamp(kTimeConstants * timeConstant, kOfStep, kOfDecay) : kOfStep;
}

std::optional<Refinement> fitBehind(
    const ModelInput &input, const SensorModel &model, double skipped_s, const JobControl &control)
{
    std::vector<RefinementRecord> records = refinementRecords(input, model.draft);
    for (RefinementRecord &record : records) {
        record.used = usedBehind(record, skipped_s);
        if (record.used.empty())
            return std::nullopt;
    }
    auto fit
        = refinePoles(records, model.draft.poles_rad_s, isStepTreatment(input.treatment), control);
    if (fit)
        allowForColour(records, noiseBeforeStart(input), *fit);
    return fit;
}

Eigen::Vector2d parts(std::complex<double> s)
{
    return {s.real(), s.imag()};
}

/// Chi square of the difference; 0 where its variance cannot be told from 0.
double differenceSquared(const Refinement &all, const Refinement &behind, Index at, bool isWhite)
{
    const auto place = static_cast<std::size_t>(at);
    const Eigen::Vector2d d = parts(behind.poles_rad_s[place]) - parts(all.poles_rad_s[place]);
    Eigen::Matrix2d variance = behind.covariance.block<2, 2>(at, at);
    if (isWhite)
        variance -= all.covariance.block<2, 2>(at, at);
    const Eigen::LLT<Eigen::Matrix2d> solver(variance);
    return solver.info() == Eigen::Success ? d.dot(solver.solve(d)) : 0.0;
}

bool canCompare(const ModelInput &input, const SensorModel &model)
{
    return model.draft.refinement && !model.secondOrder && !(input.front.duration_s > 0.0);
}

bool matters(const PoleFigures &now, const Pole &before)
{
    return std::abs(now.frequency_Hz - before.frequency_Hz) > before.u_frequency_Hz
        || std::abs(now.dampingRatio - before.dampingRatio) > before.u_dampingRatio;
}

Finding earlyFinding(
    const PoleFigures &now, const Pole &before, double skipped_s, double statistic, bool isDecay)
{
    const auto percent
        = [](double value, double of) { return numberText(100.0 * (value / of - 1.0), 2); };
    const char *text = isDecay
        ? DYNCAL_TEXT("core",
            "Without the first %1 of the records the main resonance has %2 % of frequency and %3 % of damping more, beyond what noise allows: the excitation lasts into them, as a hammer's contact does (leave that stretch out), or a faster part is missing in the model.")
        : DYNCAL_TEXT("core",
            "Without the first %1 of the records the main resonance has %2 % of frequency and %3 % of damping more, beyond what noise allows: the pressure does not rise at once (state the duration of the front), or a faster part is missing in the model.");
    return {.id = isDecay ? "MOD-020" : "MOD-017",
        .severity = Severity::Caution,
        .message = {text,
            {numberWithUnit(skipped_s, "s", 3), percent(now.frequency_Hz, before.frequency_Hz),
                percent(now.dampingRatio, before.dampingRatio)}},
        .value = statistic,
        .causes = {FindingCause::Front, FindingCause::Order}};
}

} // namespace

std::vector<SampleRange> usedBehind(const RefinementRecord &record, double skipped_s)
{
    const auto first = static_cast<Index>(std::ceil(skipped_s * record.rate_Hz));
    std::vector<SampleRange> used;
    for (const SampleRange &range : usedRanges(record))
        if (range.end > first)
            used.push_back({std::max(range.begin, first), range.end});
    return used;
}

Findings judgeEarlySamples(const ModelInput &input, const SensorModel &model,
    const std::vector<Pole> &poles, const JobControl &control)
{
    const Pole *main = mainPole(poles, model.series);
    if (!main || !canCompare(input, model))
        return {};
    const bool isDecay = !isStepTreatment(input.treatment);
    const double skipped_s = skippedPeriods(*main, isDecay) / main->frequency_Hz;
    const auto behind = fitBehind(input, model, skipped_s, control);
    if (!behind)
        return {};
    const auto at = static_cast<Index>(main - poles.data());
    const PoleFigures now = poleFigures(*behind, at);
    const double statistic
        = differenceSquared(*model.draft.refinement, *behind, at, model.draft.noise.order == 0);
    if (!matters(now, *main) || !(chiSquareSurvival(statistic, 2.0) < kProbability))
        return {};
    return {earlyFinding(now, *main, skipped_s, statistic, isDecay)};
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/unstated_front.h"

#include "core/base/distributions.h"
#include "core/base/number_text.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/fit_residual.h"
#include "core/realization/second_order/front_fit.h"
#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace dyncal {
namespace {

constexpr double kSamplesOfFilter = 3.0; ///< a recorder's own may spread a step over as many

/// The beginning of the records, and what the model leaves of it.
struct Beginning
{
    std::vector<EarlyRecord> records;
    double ofModel = 0.0; ///< sum of whitenedSquares()
    Index points = 0;
    double longest_s = 0.0; ///< between two points
    double blocks_s = 0.0; ///< a front that the means over blocks look like, root mean square
};

double length_s(const Pole &pole)
{
    constexpr double kMostPeriods = 5.0;
    constexpr double kTimeConstants = 10.0;
    return std::min(
        kMostPeriods / pole.frequency_Hz, kTimeConstants / std::abs(pole.s_rad_s.real()));
}

/// So many samples to a point that a period has some 200: more say nothing of a front that matters.
Index blockSize(double rate_Hz, const Pole &main)
{
    constexpr double kPoints = 200.0; // of a period
    return std::max<Index>(1, static_cast<Index>(rate_Hz / main.frequency_Hz / kPoints));
}

/// Noise of single samples is whitened; that of means is taken for white, and what it is more than
/// that shows in the cost.
EarlyRecord earlyRecord(const RefinementRecord &from, const AutoregressiveModel &noise, Index size)
{
    EarlyRecord record;
    record.rate_Hz = from.rate_Hz / static_cast<double>(size);
    record.first_s
        = (static_cast<double>(from.used.front().begin) + 0.5 * static_cast<double>(size - 1))
        / from.rate_Hz;
    record.weight = from.weight * std::sqrt(static_cast<double>(size));
    if (size == 1 && noise.order() > 0 && noise.innovationVariance > 0.0) {
        record.whitening = noise.coefficients;
        record.weight = 1.0 / std::sqrt(noise.innovationVariance);
    }
    return record;
}

std::optional<Beginning> beginningOf(
    const ModelInput &input, const SensorModel &model, const Pole &main)
{
    constexpr Index kFewest = 12;
    const auto noise = chooseAutoregressiveModels(noiseBeforeStart(input), kLargestNoiseModel);
    auto records = refinementRecords(input, model.draft);
    Beginning beginning;
    for (std::size_t r = 0; r < records.size(); ++r) {
        RefinementRecord &early = records[r];
        const Index size = blockSize(early.rate_Hz, main);
        const SampleRange first = usedRanges(early).front();
        const auto length = static_cast<Index>(std::ceil(length_s(main) * early.rate_Hz));
        early.used = {{first.begin, std::min<Index>(first.end, first.begin + length)}};
        if (early.used.front().size() / size < kFewest)
            return std::nullopt;
        EarlyRecord record = earlyRecord(early, noise[r], size);
        const auto &modes = model.draft.nuisance[r]; // the tube's, no part of sensor or front
        record.y = meansOf(fitResidual(early, {}, modes), size);
        beginning.ofModel += whitenedSquares(
            record, meansOf(fitResidual(early, model.draft.series[r], modes), size));
        beginning.points += record.y.size() - record.whitening.size();
        beginning.longest_s = std::max(beginning.longest_s, 1.0 / record.rate_Hz);
        beginning.blocks_s += (std::pow(static_cast<double>(size), 2) - 1.0)
            / (std::pow(early.rate_Hz, 2) * static_cast<double>(records.size()));
        beginning.records.push_back(std::move(record));
    }
    beginning.blocks_s = std::sqrt(beginning.blocks_s);
    return beginning;
}

SecondOrderStart startOf(const SensorModel &model, const Pole &main)
{
    SecondOrderStart start{main.frequency_Hz, main.dampingRatio, {}, {}};
    for (const SeriesFit &series : model.series) {
        start.plateau.push_back(series.level());
        start.onset_s.push_back(series.onset_s);
    }
    return start;
}

/// Poles, and of each record its amplitudes and level.
Index parametersOf(const SensorModel &model)
{
    const Index records = std::ssize(model.series);
    if (model.secondOrder)
        return 2 + 2 * records;
    const Index poles = std::ssize(model.draft.poles_rad_s);
    return poles + records * (poles + 1);
}

double bic(double cost, Index parameters, const Beginning &of)
{
    const auto n = static_cast<double>(of.points);
    return n * std::log(cost / n) + static_cast<double>(parameters) * std::log(n);
}

Finding frontFinding(const FrontFit &fit, double statistic)
{
    return {.id = "MOD-019",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "The records begin as those of a second-order sensor (%1, damping %2) behind a pressure that rises over %3 (u = %4), and no front is stated: state its duration, or look for a faster part of sensor and amplifier."),
            {numberWithUnit(fit.f0_Hz, "Hz", 4), numberText(fit.zeta, 3),
                numberWithUnit(fit.duration_s, "s", 2), numberWithUnit(fit.u_duration_s, "s", 1)}},
        .value = statistic,
        .causes = {FindingCause::Front, FindingCause::Order}};
}

bool canHaveUnstatedFront(const ModelInput &input)
{
    return isStepTreatment(input.treatment) && !isThesisMode(input) && !isFrontStated(input.front);
}

} // namespace

Findings judgeUnstatedFront(const ModelInput &input, const SensorModel &model,
    const std::vector<Pole> &poles, const JobControl &control)
{
    const Pole *main = mainPole(poles, model.series);
    if (!main || !canHaveUnstatedFront(input))
        return {};
    const auto beginning = beginningOf(input, model, *main);
    if (!beginning)
        return {};
    constexpr double kProbability = 1e-4;
    const double allowed_s = std::max(kUnstatedFront_s, kSamplesOfFilter * beginning->longest_s);
    const SecondOrderStart start = startOf(model, *main);
    auto fit = fitFront(beginning->records, start, 2.0 * allowed_s, true, control);
    if (!fit || fit->duration_s <= allowed_s
        || bic(fit->cost, fit->parameters, *beginning)
            > bic(beginning->ofModel, parametersOf(model), *beginning))
        return {};
    const auto limit = fitFront(beginning->records,
        {fit->f0_Hz, fit->zeta, start.plateau, start.onset_s}, allowed_s, false, control);
    if (!limit)
        return {};
    const auto freedom = static_cast<double>(beginning->points - fit->parameters);
    const double statistic = (limit->cost - fit->cost) / std::max(1.0, fit->cost / freedom);
    if (!(chiSquareSurvival(statistic, 1.0) < kProbability))
        return {};
    fit->duration_s = std::sqrt(fit->duration_s * fit->duration_s
        - beginning->blocks_s * beginning->blocks_s); // longer than three points
    return {frontFinding(*fit, statistic)};
}

} // namespace dyncal

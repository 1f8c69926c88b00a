// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/full_refits.h"

#include "core/base/distributions.h"
#include "core/base/input_draws.h"
#include "core/base/parallel.h"
#include "core/base/portable_random.h"
#include "core/monte_carlo/model_draws.h"
#include "core/realization/refinement/coloured_covariance.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/fit_residual.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dyncal {
namespace {

constexpr Index kMostRefits = 50;
constexpr Index kLeastRefits = 10;
constexpr Index kTrialsOfOne = 200;
constexpr Index kMostSamples = 5'000'000;
constexpr Index kDraws = 1000;

Index samplesOf(const ModelInput &input)
{
    Index samples = 0;
    for (const ModelSeries &series : input.series)
        samples += series.fullRate.size();
    return std::max<Index>(1, samples);
}

/// Below kLeastRefits: none.
Index numberOfRefits(const ModelInput &input, Index trials)
{
    const Index bySamples = std::max(kLeastRefits, kMostSamples / samplesOf(input));
    return std::min({kMostRefits, bySamples, trials / kTrialsOfOne});
}

/// Adds noise of the model, which was there long before the record.
void addNoise(const AutoregressiveModel &model, RandomStream &stream, Eigen::VectorXd &y)
{
    constexpr Index kBefore = 2000;
    const double deviation = std::sqrt(model.innovationVariance);
    const Index order = model.order();
    Eigen::VectorXd last = Eigen::VectorXd::Zero(std::max<Index>(1, order)); // newest first
    for (Index k = order > 0 ? -kBefore : 0; k < y.size(); ++k) {
        const double x
            = deviation * stream.nextNormal() - (order > 0 ? model.coefficients.dot(last) : 0.0);
        for (Index i = last.size() - 1; i > 0; --i)
            last[i] = last[i - 1];
        last[0] = x;
        if (k >= 0)
            y[k] += x;
    }
}

/// Makes records like those that were fitted.
class RecordMaker
{
public:
    explicit RecordMaker(const ChainSubject &subject)
        : m_input(subject.input)
        , m_models(noiseModels(subject))
    {
        const Refinement &fit = *subject.model.draft.refinement;
        const auto records = refinementRecords(subject.input, subject.model.draft);
        for (std::size_t r = 0; r < records.size(); ++r)
            m_fitted.push_back(modelled(records[r], fit, r));
    }

    ModelInput make(std::uint64_t seed, Index refit) const
    {
        ModelInput input = m_input;
        for (std::size_t r = 0; r < input.series.size(); ++r) {
            static const Index kStream = streamOf("noise of a refit");
            RandomStream stream(seed, refit, kStream + static_cast<Index>(r));
            input.series[r].fullRate = m_fitted[r];
            addNoise(m_models[r], stream, input.series[r].fullRate);
        }
        return input;
    }

private:
    static std::vector<AutoregressiveModel> noiseModels(const ChainSubject &subject)
    {
        const Refinement &fit = *subject.model.draft.refinement;
        return chooseNoiseModels(refinementRecords(subject.input, subject.model.draft),
            noiseBeforeStart(subject.input), fit, fit.covariance.rows())
            .ofRecord;
    }

    /// The record less its residual, over all of its samples.
    static Eigen::VectorXd modelled(RefinementRecord record, const Refinement &fit, std::size_t r)
    {
        record.used.clear();
        return record.y - fitResidual(record, fit.records[r], fit.nuisance[r]);
    }

    const ModelInput &m_input;
    std::vector<AutoregressiveModel> m_models;
    std::vector<Eigen::VectorXd> m_fitted;
};

/// f0 and damping of a refit have no assessment.
CharacteristicValues valuesOfRefit(const SensorModel &model, ResponseTreatment treatment)
{
    ModelAssessment bare;
    bare.poles = model.poles;
    return characteristicValues(model, mainPair(model, bare), treatment);
}

using ManyValues = std::vector<std::optional<CharacteristicValues>>;

ManyValues refitted(const ChainSubject &subject, const FitAgain &fitAgain, Index count,
    std::uint64_t seed, const JobControl &control)
{
    const RecordMaker records(subject);
    ManyValues values(static_cast<std::size_t>(count));
    forEachPart(std::ssize(values), true, [&](Index i) {
        if (control.stopRequested())
            return;
        const auto model = fitAgain(records.make(seed, i), {control.stop, {}});
        if (model && !model->diverges)
            values[static_cast<std::size_t>(i)] = valuesOfRefit(*model, subject.input.treatment);
    });
    return values;
}

ManyValues drawnByNoise(const ModelDraws &draws, std::uint64_t seed, const JobControl &control)
{
    constexpr Index kPart = 50;
    ManyValues values(static_cast<std::size_t>(kDraws));
    forEachPart(kDraws / kPart, true, [&](Index part) {
        for (Index i = part * kPart; i < (part + 1) * kPart && !control.stopRequested(); ++i)
            values[static_cast<std::size_t>(i)] = draws.valuesByNoise(seed, i);
    });
    return values;
}

struct MeanAndSpread
{
    double mean = kUnknown;
    double u = kUnknown;
};

/// Of those that exist; NaN where one of them has no such value.
MeanAndSpread spreadOf(const ManyValues &all, double CharacteristicValues::*member)
{
    std::vector<double> values;
    for (const auto &one : all)
        if (one)
            values.push_back((*one).*member);
    if (values.size() < 2)
        return {};
    const Eigen::Map<const Eigen::VectorXd> y(values.data(), std::ssize(values));
    return {y.mean(),
        std::sqrt((y.array() - y.mean()).square().sum() / static_cast<double>(y.size() - 1))};
}

bool isWithin(const RefittedValue &value, Index refits, double chance)
{
    if (value.u_refits == 0.0 && value.u_draws == 0.0 && value.shift == 0.0)
        return true; // as the overshoot of a sensor that has none
    const auto freedom = static_cast<double>(refits - 1);
    const double squares = freedom * std::pow(value.u_refits / value.u_draws, 2);
    const double above = chiSquareSurvival(squares, freedom);
    const double z = value.shift / value.u_draws * std::sqrt(static_cast<double>(refits));
    return above > 0.5 * chance && above < 1.0 - 0.5 * chance
        && std::abs(z) < normalQuantile(1.0 - 0.5 * chance);
}

RefitCheck compared(const ChainSubject &subject, const ManyValues &refits, const ManyValues &draws)
{
    constexpr double kChance = 1e-3;
    RefitCheck check{std::ssize(refits),
        std::ssize(refits)
            - std::ranges::count_if(refits, [](const auto &one) { return one.has_value(); }),
        {}};
    const double chance = kChance / static_cast<double>(kCharacteristics.size());
    for (const Characteristic &one : kCharacteristics) {
        if (!subject.report.find(one.of))
            continue;
        const MeanAndSpread ofRefits = spreadOf(refits, one.value);
        const MeanAndSpread ofDraws = spreadOf(draws, one.value);
        RefittedValue value{one.of, ofRefits.u, ofDraws.u, ofRefits.mean - ofDraws.mean, false};
        value.agrees = isWithin(value, check.refits - check.failed, chance);
        check.values.push_back(std::move(value));
    }
    return check;
}

} // namespace

bool RefitCheck::agrees() const
{
    return refits > 0 && failed == 0
        && std::ranges::all_of(values, [](const RefittedValue &one) { return one.agrees; });
}

Result<RefitCheck> fullRefits(const ChainSubject &subject, const ChainInputs &inputs,
    const FitAgain &fitAgain, Index trials, std::uint64_t seed, const JobControl &control)
{
    const Index count = numberOfRefits(subject.input, trials);
    if (!ModelDraws::canDraw(subject) || !fitAgain || count < kLeastRefits)
        return RefitCheck();
    const ManyValues refits = refitted(subject, fitAgain, count, seed, control);
    const ManyValues draws = drawnByNoise(ModelDraws(subject, inputs), seed, control);
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});
    return compared(subject, refits, draws);
}

} // namespace dyncal

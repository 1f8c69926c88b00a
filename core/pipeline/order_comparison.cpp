// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/order_comparison.h"

#include "core/base/constants.h"
#include "core/base/distributions.h"
#include "core/decomposition/residual_analysis.h"
#include "core/pipeline/model_stages.h"
#include "core/realization/hankel/hankel_gap.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/input/whitening.h"
#include "core/realization/model/model_assessing.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr std::size_t kMostOrders = 50;
constexpr Index kReferenceOrder = 100; ///< the thesis's high order
constexpr Index kWhitenessLags = 20;

/// Autocorrelation at lags 1 .. of a record, with its variance under white noise (Ljung and Box).
struct Correlogram
{
    Eigen::ArrayXd values;
    Eigen::ArrayXd variances;
};

std::optional<Correlogram> correlogramOf(const Eigen::VectorXd &record)
{
    const auto n = static_cast<double>(record.size());
    if (record.size() <= 4 * kWhitenessLags)
        return std::nullopt;
    const Eigen::VectorXd covariance
        = autocovariance((record.array() - record.mean()).matrix(), kWhitenessLags);
    if (!(covariance[0] > 0.0))
        return std::nullopt;
    const Eigen::ArrayXd lags
        = Eigen::ArrayXd::LinSpaced(kWhitenessLags, 1.0, static_cast<double>(kWhitenessLags));
    return Correlogram{
        covariance.tail(kWhitenessLags).array() / covariance[0], (n - lags) / (n * (n + 2.0))};
}

/// Whether what is left of the series has the colour of their pre-trigger noise: both are made
/// white by the noise's model, and their autocorrelations compared (docs/method/order.md).
double whitenessOf(const ModelInput &input, const SensorModel &model)
{
    std::vector<NoiseCovariance> noise;
    for (const ModelSeries &series : input.series)
        noise.push_back(noiseCovariance(series.noise, kLargestNoiseModel));
    const auto noiseModels = chooseAutoregressiveModels(noise, kLargestNoiseModel);
    double statistic = 0.0;
    Index lags = 0;
    for (std::size_t r = 0; r < model.series.size() && !model.diverges; ++r) {
        const Eigen::VectorXd &a = noiseModels[r].coefficients;
        const auto left = correlogramOf(whitened(model.series[r].error, a));
        if (!left)
            continue;
        const Eigen::VectorXd &before = input.series[r].noise;
        const auto quiet = before.size() > a.size() ? correlogramOf(whitened(before, a))
                                                    : std::optional<Correlogram>();
        const Eigen::ArrayXd difference
            = quiet ? Eigen::ArrayXd(left->values - quiet->values) : left->values;
        const Eigen::ArrayXd variance
            = quiet ? Eigen::ArrayXd(left->variances + quiet->variances) : left->variances;
        statistic += (difference.square() / variance).sum();
        lags += kWhitenessLags;
    }
    return lags > 0 ? chiSquareSurvival(statistic, static_cast<double>(lags)) : kUnknown;
}

template <typename T>
Result<std::shared_ptr<const T>> shared(Result<T> result)
{
    if (!result)
        return tl::unexpected(std::move(result.error()));
    return std::make_shared<const T>(std::move(*result));
}

/// The model a run has made already, or a new one.
Result<std::shared_ptr<const SensorModel>> modelOf(
    const CalibrationResults &results, const Recipe &recipe, Index order, const JobControl &control)
{
    if (results.model && results.model->order == order)
        return results.model;
    return shared(modelStage(results, recipe, order, control));
}

Result<std::shared_ptr<const ModelAssessment>> assessmentOf(const CalibrationResults &results,
    const Recipe &recipe, const std::shared_ptr<const SensorModel> &model,
    const JobControl &control)
{
    if (model == results.model && results.assessment)
        return results.assessment;
    return shared(assessModel(*results.input, *model, recipe.realization, control));
}

Result<std::shared_ptr<const ResponseResult>> responseOf(const CalibrationResults &results,
    const Recipe &recipe, const std::shared_ptr<const SensorModel> &model)
{
    if (model == results.model && results.response)
        return results.response;
    const Result<ShockConditionsSet> shock = shockOfModel(results, recipe, *model);
    if (!shock)
        return tl::unexpected(shock.error());
    return shared(responseStage(results, recipe, *model, *shock));
}

ComparedOrder compareOne(
    const CalibrationResults &results, const Recipe &recipe, Index order, const JobControl &control)
{
    ComparedOrder compared;
    compared.order = order;
    compared.note = noteOnOrder(recipe, order);
    const Eigen::VectorXd &bic = results.decomposition->suggestion.bic;
    if (order >= 1 && order <= bic.size())
        compared.bic = bic[order - 1];
    auto model = modelOf(results, recipe, order, control);
    if (!model) {
        compared.error = std::move(model.error());
        return compared;
    }
    auto assessment = assessmentOf(results, recipe, *model, control);
    if (!assessment) {
        compared.error = std::move(assessment.error());
        return compared;
    }
    compared.model = std::move(*model);
    compared.assessment = std::move(*assessment);
    compared.whiteness_p = whitenessOf(*results.input, *compared.model);
    auto response = responseOf(results, recipe, compared.model);
    if (response)
        compared.response = std::move(*response);
    else
        compared.error = std::move(response.error());
    return compared;
}

} // namespace

std::string noteOnOrder(const Recipe &recipe, Index order)
{
    const std::vector<OrderNote> &notes = recipe.realization.candidateNotes;
    const auto note = std::ranges::find(notes, order, &OrderNote::order);
    return note == notes.end() ? std::string() : note->note;
}

Result<std::vector<ComparedOrder>> compareOrders(const CalibrationResults &results,
    const Recipe &recipe, const std::vector<Index> &orders, const JobControl &control)
{
    if (!results.decomposition) {
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core", "There is no decomposition yet that orders could be taken from."),
                {}});
    }
    if (orders.size() > kMostOrders) {
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core", "%1 orders were asked for; compare at most %2 at once."),
                {std::to_string(orders.size()), std::to_string(kMostOrders)}});
    }
    std::vector<ComparedOrder> list;
    for (std::size_t i = 0; i < orders.size(); ++i) {
        list.push_back(compareOne(results, recipe, orders[i], control));
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {});
        control.report(static_cast<double>(i + 1) / static_cast<double>(orders.size()));
    }
    return list;
}

std::vector<Index> defaultCandidates(const CalibrationResults &results, const Recipe &recipe)
{
    std::vector<Index> orders = recipe.realization.candidates;
    if (results.decomposition) {
        const Index suggested = results.decomposition->suggestion.order;
        const HankelDecomposition &hankel = results.decomposition->hankel;
        orders.push_back(suggested);
        if (splitsPair(hankel, suggested))
            orders.push_back(suggested + 1);
        orders.push_back(std::min(kReferenceOrder, largestOrder(hankel)));
    }
    std::sort(orders.begin(), orders.end());
    orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
    return orders;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/order_comparison.h"

#include "core/pipeline/model_stages.h"
#include "core/realization/hankel/hankel_gap.h"
#include "core/realization/hankel/realized_poles.h"
#include "core/realization/model/model_assessing.h"
#include "core/realization/model/residual_whiteness.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr std::size_t kMostOrders = 50;
constexpr Index kReferenceOrder = 100; ///< the thesis's high order

template <typename T>
Result<std::shared_ptr<const T>> shared(Result<T> result)
{
    if (!result)
        return tl::unexpected(std::move(result.error()));
    return std::make_shared<const T>(std::move(*result));
}

/// The model of an earlier run, or a new one.
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
    compared.whiteness_p = residualWhiteness_p(*results.input, *compared.model);
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

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/order_candidates.h"

#include "core/pipeline/stage_keys.h"
#include "core/realization/hankel/realized_poles.h"

namespace dyncal {

OrderCandidates::OrderCandidates()
    : m_jobs(this)
{
}

void OrderCandidates::follow(CandidateBasis basis)
{
    m_basis = std::move(basis);
    update();
}

const ComparedOrder *OrderCandidates::find(Index order) const
{
    const auto known = m_models.find(order);
    return known == m_models.end() ? nullptr : &known->second;
}

void OrderCandidates::setDrawn(Index order, bool drawn)
{
    if (drawn)
        m_hidden.erase(order);
    else
        m_hidden.insert(order);
    emit changed();
}

bool OrderCandidates::waitsForWholeSet(Index order) const
{
    const auto &decomposition = m_basis.results.decomposition;
    return m_basis.isFirstTriplets && decomposition && order > largestOrder(decomposition->hankel);
}

std::vector<Index> OrderCandidates::missing() const
{
    std::vector<Index> orders;
    for (const Index order : m_basis.recipe.realization.candidates)
        if (!find(order) && !waitsForWholeSet(order))
            orders.push_back(order);
    return orders;
}

void OrderCandidates::update()
{
    if (m_basis.recipe.realization.candidates.empty() || !m_basis.results.decomposition)
        return;
    Recipe recipe = m_basis.recipe;
    recipe.realization.order = 1; // the models do not depend on the order chosen
    const auto keys = stageKeys(*m_basis.captures, recipe);
    const auto keyOf = [](const auto &all, StageId stage) -> const std::string & {
        return all[static_cast<std::size_t>(stage)];
    };
    const auto isOld
        = [&](StageId stage) { return keyOf(keys, stage) != keyOf(m_basis.results.keys, stage); };
    if (isOld(StageId::ModelInput) || isOld(StageId::Decomposition))
        return; // one of them is still being computed
    const std::string &basis = keyOf(keys, StageId::Response);
    const bool isOther = basis != m_basisOfModels;
    if (isOther) {
        m_jobs.cancel();
        m_models.clear();
        m_basisOfModels = basis;
        emit changed();
    }
    const std::vector<Index> orders = missing();
    if (orders.empty() || m_jobs.isRunning())
        return;
    CalibrationResults results = m_basis.results;
    results.model = nullptr; // of the order chosen, and perhaps of an older recipe
    results.shock = nullptr;
    results.response = nullptr;
    results.assessment = nullptr;
    m_jobs.start<std::vector<ComparedOrder>>(
        [results, recipe, orders](
            const JobControl &control) { return compareOrders(results, recipe, orders, control); },
        [this, basis](
            Result<std::vector<ComparedOrder>> compared) { take(basis, std::move(compared)); });
}

void OrderCandidates::take(
    const std::string &basisOfModels, Result<std::vector<ComparedOrder>> compared)
{
    if (basisOfModels != m_basisOfModels)
        return;
    m_error = compared ? std::nullopt : std::optional(compared.error());
    if (compared)
        for (ComparedOrder &order : *compared)
            m_models[order.order] = std::move(order);
    emit changed();
    if (compared && !missing().empty()) // pinned meanwhile
        update();
}

} // namespace dyncal

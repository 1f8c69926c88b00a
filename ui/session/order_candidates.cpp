// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/order_candidates.h"

#include "core/pipeline/stage_keys.h"
#include "core/realization/realized_poles.h"
#include "ui/session/session.h"

namespace dyncal {

OrderCandidates::OrderCandidates(Session &session)
    : m_session(session)
    , m_jobs(this)
{
    connect(&session, &Session::resultsChanged, this, &OrderCandidates::update);
    connect(&session, &Session::recipeChanged, this, &OrderCandidates::update);
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
    const auto &decomposition = m_session.results().decomposition;
    return m_session.showsFirstTriplets() && decomposition
        && order > largestOrder(decomposition->hankel);
}

std::vector<Index> OrderCandidates::missing() const
{
    std::vector<Index> orders;
    for (const Index order : m_session.recipe().realization.candidates)
        if (!find(order) && !waitsForWholeSet(order))
            orders.push_back(order);
    return orders;
}

void OrderCandidates::update()
{
    if (m_session.recipe().realization.candidates.empty() || !m_session.results().decomposition)
        return;
    Recipe recipe = m_session.recipeOnShow();
    recipe.realization.order = 1; // the models do not depend on the order chosen
    const auto keys = stageKeys(*m_session.state().captures, recipe);
    const auto keyOf = [](const auto &all, StageId stage) -> const std::string & {
        return all[static_cast<std::size_t>(stage)];
    };
    if (keyOf(keys, StageId::Decomposition)
        != keyOf(m_session.results().keys, StageId::Decomposition))
        return; // still to come
    const std::string &basis = keyOf(keys, StageId::Response);
    const bool isOther = basis != m_basis;
    if (isOther) {
        m_jobs.cancel();
        m_models.clear();
        m_basis = basis;
        emit changed();
    }
    const std::vector<Index> orders = missing();
    if (orders.empty() || m_jobs.isRunning())
        return;
    CalibrationResults results = m_session.results();
    results.model = nullptr; // of the order chosen, and perhaps of an older recipe
    results.shock = nullptr;
    results.response = nullptr;
    m_jobs.start<std::vector<ComparedOrder>>(
        [results, recipe, orders](
            const JobControl &control) { return compareOrders(results, recipe, orders, control); },
        [this, basis](
            Result<std::vector<ComparedOrder>> compared) { take(basis, std::move(compared)); });
}

void OrderCandidates::take(const std::string &basis, Result<std::vector<ComparedOrder>> compared)
{
    if (basis != m_basis)
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

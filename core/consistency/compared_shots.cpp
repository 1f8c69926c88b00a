// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/compared_shots.h"

#include "core/base/distributions.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// Relative: what no budget holds, so that no difference counts as exact.
constexpr double kLeftOut = 5e-4;

/// Of value_a and value_b of these ways.
Result<GumBudget> budgetOf(const ShotWays &shot, const std::vector<Index> &ways)
{
    return propagateGum(shot.inputs(), [&](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
        const auto all = shot.values(shot.at(x));
        if (!all)
            return all;
        Eigen::VectorXd some(2 * std::ssize(ways));
        for (Index i = 0; i < std::ssize(ways); ++i)
            some.segment<2>(2 * i) = all->segment<2>(2 * ways[static_cast<std::size_t>(i)]);
        return some;
    });
}

} // namespace

ComparedShots::ComparedShots(const std::vector<std::unique_ptr<ShotWays>> &shots)
{
    for (const auto &shot : shots)
        addShot(*shot);
    finish();
}

void ComparedShots::addShot(const ShotWays &shot)
{
    const auto value = shot.values(shot.nominal());
    std::vector<Index> known;
    for (Index way = 0; value && way < value->size() / 2; ++way)
        if (std::isfinite((*value)[2 * way]) && std::isfinite((*value)[2 * way + 1]))
            known.push_back(way);
    auto budget = value ? budgetOf(shot, known) : Result<GumBudget>(tl::unexpected(value.error()));
    if (value && !budget) { // a way that ends within its uncertainty has no budget; the others have
        std::erase_if(known, [&](Index way) { return !budgetOf(shot, {way}); });
        budget = budgetOf(shot, known);
    }
    if (budget && !known.empty())
        m_ways.push_back(&shot);
    const Message none{DYNCAL_TEXT("core", "One of the two ways gives no value here."), {}};
    for (std::size_t way = 0; way < shot.made().size(); ++way) {
        const auto found = std::ranges::find(known, static_cast<Index>(way));
        if (budget && found != known.end()) {
            addWay(shot, way, *value, *budget, found - known.begin());
            continue;
        }
        m_comparisons.push_back(shot.made()[way]);
        m_comparisons.back().missing = budget ? none : budget.error().message;
    }
    m_comparisons.insert(m_comparisons.end(), shot.missing().begin(), shot.missing().end());
}

void ComparedShots::addWay(const ShotWays &shot, std::size_t way, const Eigen::VectorXd &value,
    const GumBudget &budget, Index at)
{
    WayComparison comparison = shot.made()[way];
    comparison.value_a = value[static_cast<Index>(2 * way)];
    comparison.value_b = value[static_cast<Index>(2 * way + 1)];
    const double ratio = comparison.value_a / comparison.value_b;
    double variance = 0.0;
    for (const BudgetLine &line : budget.lines) {
        const double of_a = line.contribution[2 * at];
        const double of_b = line.contribution[2 * at + 1];
        variance += (of_a - of_b) * (of_a - of_b);
        const std::string name = line.input.common
            ? line.input.quantity
            : line.input.quantity + "#" + std::to_string(comparison.shot);
        if (ratio > 0.0)
            m_contributions[name].emplace_back(
                std::ssize(m_rows), of_a / comparison.value_a - of_b / comparison.value_b);
    }
    comparison.u = std::sqrt(variance);
    m_comparisons.push_back(std::move(comparison));
    if (!(ratio > 0.0))
        return;
    m_list.push_back(std::log(ratio));
    m_rows.push_back({m_ways.size() - 1, way});
}

void ComparedShots::finish()
{
    const Index count = std::ssize(m_rows);
    m_differences = Eigen::Map<const Eigen::VectorXd>(m_list.data(), count);
    m_covariance = Eigen::MatrixXd::Identity(count, count) * (kLeftOut * kLeftOut);
    for (const auto &[name, moved] : m_contributions)
        for (const auto &[row, by] : moved)
            for (const auto &[other, byOther] : moved)
                m_covariance(row, other) += by * byOther;
}

Eigen::VectorXd ComparedShots::differencesAt(const std::vector<CheckPoint> &points) const
{
    Eigen::VectorXd differences(std::ssize(m_rows));
    std::vector<Eigen::VectorXd> values;
    for (std::size_t i = 0; i < m_ways.size(); ++i) {
        auto there = m_ways[i]->values(points[i]);
        if (!there)
            return {};
        values.push_back(std::move(*there));
    }
    for (Index row = 0; row < differences.size(); ++row) {
        const auto [shot, way] = m_rows[static_cast<std::size_t>(row)];
        const auto at = static_cast<Index>(2 * way);
        const double ratio = values[shot][at] / values[shot][at + 1];
        if (!(ratio > 0.0 && std::isfinite(ratio)))
            return {};
        differences[row] = std::log(ratio);
    }
    return differences;
}

double ComparedShots::chiSquare() const
{
    return m_rows.empty() ? 0.0 : m_differences.dot(m_covariance.ldlt().solve(m_differences));
}

double ComparedShots::chance() const
{
    return m_rows.empty() ? 1.0
                          : chiSquareSurvival(chiSquare(), static_cast<double>(m_rows.size()));
}

} // namespace dyncal

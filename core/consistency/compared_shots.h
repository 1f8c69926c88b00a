// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/propagation.h"
#include "core/consistency/shot_ways.h"

#include <Eigen/Core>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// The ways of all shots with their budgets: the relative differences ln(a/b) of all comparisons
/// and their covariance, errors that shots and ways share kept together.
class ComparedShots
{
public:
    /// `shots` stay alive as long as this. A shot whose values cannot be computed is left out.
    explicit ComparedShots(const std::vector<std::unique_ptr<ShotWays>> &shots);

    struct Row
    {
        std::size_t shot = 0; ///< of ways()
        std::size_t way = 0; ///< of ShotWays::made()
    };

    const std::vector<const ShotWays *> &ways() const { return m_ways; }
    const std::vector<Row> &rows() const { return m_rows; }
    const Eigen::VectorXd &differences() const { return m_differences; } ///< ln(a/b)
    const Eigen::MatrixXd &covariance() const { return m_covariance; }
    double chiSquare() const; ///< of all differences together
    double chance() const; ///< of as much, where nothing is wrong
    /// With numbers and u; those whose ways have no value become missing.
    const std::vector<WayComparison> &comparisons() const { return m_comparisons; }

    /// ln(a/b) of all rows at other points, one per shot; empty where one cannot be computed.
    Eigen::VectorXd differencesAt(const std::vector<CheckPoint> &points) const;

private:
    void addShot(const ShotWays &shot);
    void addWay(const ShotWays &shot, std::size_t way, const Eigen::VectorXd &value,
        const GumBudget &budget, Index at);
    void finish();

    std::vector<const ShotWays *> m_ways;
    std::vector<Row> m_rows;
    Eigen::VectorXd m_differences;
    Eigen::MatrixXd m_covariance;
    std::vector<WayComparison> m_comparisons;
    std::vector<double> m_list;
    /// Of every input (of a shot, unless it is common): which rows it moves, and how far.
    std::map<std::string, std::vector<std::pair<Index, double>>> m_contributions;
};

} // namespace dyncal

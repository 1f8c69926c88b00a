// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/second_order/second_order_problem.h"

#include <Eigen/Core>

#include <optional>

namespace dyncal {

inline constexpr Index kLogZeta = 1; ///< place of ln zeta in the problem's theta

/// Moves theta to the lowest cost near it, a drift staying slower than the sensor and each mode the
/// same; the parameter `fixed` stays where it is. The equations there; empty where none is found.
std::optional<RegressionEquations> minimise(const SecondOrderProblem &problem,
    Eigen::VectorXd &theta, const JobControl &control, std::optional<Index> fixed = {});

/// Where the cost is lowest.
struct SecondOrderMinimum
{
    Eigen::VectorXd theta;
    RegressionEquations equations;
};

/// How far ln zeta lies above its value in the minimum where the lowest cost, all else free, is
/// larger by `increase`: the upper end of an interval by the likelihood (D. M. Bates, D. G. Watts,
/// Nonlinear Regression Analysis, 1988, 6.1). Looked for from `start` on, up to ten times the
/// damping ratio; `start` itself where that finds no end.
double riseOfLogZeta(const SecondOrderProblem &problem, const SecondOrderMinimum &minimum,
    double increase, double start, const JobControl &control);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/realization/exponentials/exponential_regression.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace dyncal {

/// What the two fits of exponentials stop at.
struct DescentLimits
{
    int iterations = 60;
    double damping = 1e-4; ///< to begin with
};

/// The descent goes on until nothing more is gained.
struct NeverOver
{
    bool operator()(const Eigen::VectorXd &, const RegressionEquations &) const { return false; }
};

/// D. W. Marquardt, J. SIAM 11 (1963) 431: `theta` moves from where it is to the least cost that
/// `equationsAt` (parameters -> RegressionEquations) has; only where `isAllowed`. Ends with a
/// relative decrease below 1e-12, where no step helps, where `isOver` (asked once an iteration), or
/// after all iterations: whether theta is where it should be then, `distanceToGo` tells. Equations
/// at the last theta; empty when stopped, or where the start has no finite cost.
template <typename EquationsAt, typename IsAllowed, typename IsOver = NeverOver>
std::optional<RegressionEquations> descend(Eigen::VectorXd &theta, const DescentLimits &limits,
    const EquationsAt &equationsAt, const IsAllowed &isAllowed, const JobControl &control,
    IsOver isOver = {})
{
    constexpr double kConverged = 1e-12;
    constexpr double kLargestDamping = 1e8;
    RegressionEquations equations = equationsAt(theta);
    double damping = limits.damping;
    for (int iteration = 0; iteration < limits.iterations; ++iteration) {
        if (control.stopRequested() || !std::isfinite(equations.cost))
            return std::nullopt;
        if (isOver(theta, equations))
            break;
        Eigen::MatrixXd damped = equations.matrix;
        damped.diagonal() *= 1.0 + damping;
        const Eigen::VectorXd next = theta + damped.ldlt().solve(equations.gradient);
        RegressionEquations tried = isAllowed(next) ? equationsAt(next) : equations;
        if (!(tried.cost < equations.cost)) {
            damping *= 10.0;
            if (damping > kLargestDamping)
                break;
            continue;
        }
        const double decrease = (equations.cost - tried.cost) / equations.cost;
        theta = next;
        equations = std::move(tried);
        damping = std::max(1e-12, damping / 10.0);
        if (decrease < kConverged)
            break;
    }
    return equations;
}

/// Whether a fit that moved a frequency from `before` to `now` still speaks of the same
/// oscillation.
inline bool isSameOscillation(double before, double now)
{
    constexpr double kFactor = 1.5;
    return now < kFactor * before && now > before / kFactor;
}

/// How far the next full step would lead, in standard uncertainties of unit weights: at least as
/// far as in any one parameter.
inline double distanceToGo(const RegressionEquations &equations)
{
    return std::sqrt(equations.gradient.dot(equations.matrix.ldlt().solve(equations.gradient)));
}

} // namespace dyncal

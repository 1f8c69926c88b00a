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

/// Limits of the two fits of exponentials.
struct DescentLimits
{
    int iterations = 60;
    double damping = 1e-4; ///< to begin with
};

/// Default of `isOver`: never ends the descent early.
struct NeverOver
{
    bool operator()(const Eigen::VectorXd &, const RegressionEquations &) const { return false; }
};

/// Default of `adjust`: takes a step as it is.
struct AsItIs
{
    void operator()(Eigen::VectorXd &) const { }
};

/// D. W. Marquardt, J. SIAM 11 (1963) 431: moves `theta` to the minimum of the cost of
/// `equationsAt` (parameters -> RegressionEquations), through points that `isAllowed`. Ends at a
/// relative decrease below 1e-12, when no step helps, when `isOver` (asked once an iteration), or
/// after all iterations; `adjust` may move a step before it is tried. `distanceToGo` tells how near
/// the minimum is. Returns the equations at the last theta; empty when stopped or if the cost is
/// not finite.
template <typename EquationsAt, typename IsAllowed, typename IsOver = NeverOver,
    typename Adjust = AsItIs>
std::optional<RegressionEquations> descend(Eigen::VectorXd &theta, const DescentLimits &limits,
    const EquationsAt &equationsAt, const IsAllowed &isAllowed, const JobControl &control,
    IsOver isOver = {}, const Adjust &adjust = {})
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
        Eigen::VectorXd next = theta + damped.ldlt().solve(equations.gradient);
        adjust(next);
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

/// Whether a fit that moved a frequency from `before` to `now` still describes the same
/// oscillation.
inline bool isSameOscillation(double before, double now)
{
    constexpr double kFactor = 1.5;
    return now < kFactor * before && now > before / kFactor;
}

/// Length of the next full step in standard uncertainties (for unit weights); no single parameter
/// moves further.
inline double distanceToGo(const RegressionEquations &equations)
{
    return std::sqrt(equations.gradient.dot(equations.matrix.ldlt().solve(equations.gradient)));
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/second_order/second_order_minimum.h"

#include "core/realization/refinement/levenberg_marquardt.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kSlowest = 1e-4; ///< limits of zeta for a second-order sensor
constexpr double kFastest = 1e3;

/// A drift is at most a tenth as fast as the sensor, and does not grow beyond a third while it is
/// recorded.
bool isSlow(const SecondOrderProblem &problem, const Eigen::VectorXd &theta)
{
    constexpr double kSlowerThanSensor = 0.1;
    constexpr double kMostGrowth = 0.3;
    double longest = 0.0;
    for (const RefinementRecord &record : problem.records())
        longest = std::max(
            longest, static_cast<double>(record.y.size()) / record.rate_Hz / problem.unit_s());
    const double zeta = std::exp(theta[kLogZeta]);
    const double sensor
        = std::exp(theta[0]) / (zeta > 1.0 ? zeta + std::sqrt(zeta * zeta - 1.0) : 1.0);
    return theta[2] >= -kSlowerThanSensor * sensor && theta[2] * longest <= kMostGrowth;
}

bool isSensible(const SecondOrderProblem &problem, const Eigen::VectorXd &theta)
{
    const double zeta = std::exp(theta[kLogZeta]);
    if (!theta.allFinite() || !(zeta > kSlowest) || !(zeta < kFastest))
        return false;
    if (problem.withDrift() && !isSlow(problem, theta))
        return false;
    for (std::size_t r = 0; r < problem.records().size(); ++r) {
        Index at = problem.plateauAt(r) + (problem.withDrift() ? 3 : 2);
        for (const NuisanceTerm &term : problem.records()[r].nuisance) {
            const double before = term.pole_rad_s.imag() * problem.unit_s();
            if (!isSameOscillation(before, theta[at + 1]))
                return false;
            at += 4;
        }
    }
    return true;
}

/// A parameter without a slope, which no step moves.
void hold(Index parameter, RegressionEquations &equations)
{
    equations.matrix.row(parameter).setZero();
    equations.matrix.col(parameter).setZero();
    equations.matrix(parameter, parameter) = 1.0;
    equations.gradient[parameter] = 0.0;
}

} // namespace

std::optional<RegressionEquations> minimise(const SecondOrderProblem &problem,
    Eigen::VectorXd &theta, const JobControl &control, std::optional<Index> fixed)
{
    const auto equationsAt = [&](const Eigen::VectorXd &at) {
        RegressionEquations equations = problem.normalEquations(at);
        if (fixed)
            hold(*fixed, equations);
        return equations;
    };
    const auto equations = descend(
        theta, {100, 1e-3}, equationsAt,
        [&](const Eigen::VectorXd &at) { return isSensible(problem, at); }, control);
    return isSensible(problem, theta) ? equations : std::nullopt;
}

double riseOfLogZeta(const SecondOrderProblem &problem, const SecondOrderMinimum &minimum,
    double increase, double start, const JobControl &control)
{
    constexpr int kLooks = 16;
    constexpr double kNear = 0.01; // of the interval
    constexpr double kBoldest = 1.5; // a longer way no minimum can be followed on
    constexpr double kFirst = 0.25;
    // At first the others follow as the law of propagation has it.
    const Eigen::VectorXd &theta = minimum.theta;
    Eigen::VectorXd along
        = minimum.equations.matrix.ldlt().solve(Eigen::VectorXd::Unit(theta.size(), kLogZeta));
    along /= along[kLogZeta];
    double rise = std::min(start, kFirst);
    Eigen::VectorXd at = theta + rise * along;
    for (int look = 0; look < kLooks; ++look) {
        const auto there = minimise(problem, at, control, kLogZeta);
        if (!there)
            return start;
        // The root of the increase grows nearly in proportion to the distance.
        const double higher = std::max(0.0, there->cost - minimum.equations.cost);
        const double share = std::sqrt(higher / increase);
        const bool isFarEnough = rise >= std::numbers::ln10 && share < 1.0;
        if (std::abs(share - 1.0) < kNear || isFarEnough)
            return rise;
        rise = std::min(rise / std::clamp(share, 1.0 / kBoldest, kBoldest), std::numbers::ln10);
        at[kLogZeta] = theta[kLogZeta] + rise;
    }
    return start;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/correlation.h"
#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/base/result.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace dyncal {

enum class Distribution { Normal, Rectangular, Triangular, UShaped };

const char *distributionName(Distribution distribution); ///< "normal", ...

/// One quantity that a result depends on, known as value and standard uncertainty.
struct UncertainInput
{
    std::string quantity; ///< unique among the inputs: it also names the random stream
    double value = 0.0;
    double u = 0.0; ///< standard uncertainty, >= 0
    Distribution distribution = Distribution::Normal;
    double dof = std::numeric_limits<double>::infinity(); ///< degrees of freedom of u
    bool common = false; ///< the same error in every shot
    Correlations correlated = {}; ///< with others of the inputs
};

/// y = f(x): several results at once of all inputs, in their order. Must not depend on anything
/// else.
using Measurement = std::function<Result<Eigen::VectorXd>(const Eigen::VectorXd &)>;

/// What one input does to the results.
struct BudgetLine
{
    UncertainInput input;
    Eigen::VectorXd sensitivity; ///< dy/dx, one per result
    Eigen::VectorXd contribution; ///< dy/dx u(x), signed
};

/// Law of propagation (GUM, JCGM 100, 5.1.2; 5.2.2 where inputs are correlated).
struct GumBudget
{
    Eigen::VectorXd value; ///< of the results
    Eigen::VectorXd u; ///< combined standard uncertainties
    Eigen::VectorXd dof; ///< effective, as combinedParts()
    std::vector<BudgetLine> lines; ///< in the order of the inputs

    /// Of the variance; of correlated inputs it may be negative.
    double sharePercent(std::size_t line, Index result) const;
};

/// Sensitivities by central differences over a tenth of each u; an input with u = 0 contributes
/// nothing. Fails (Usage) on an input with an impossible value, u or dof (NaN, infinite, u below 0,
/// dof not above 0) and on two inputs of one name; (DataBlocked) where a result is not finite; and
/// where f fails.
Result<GumBudget> propagateGum(
    const std::vector<UncertainInput> &inputs, const Measurement &measurement);

/// k with P(|T| <= k) = coverage for Student's t.
double coverageFactor(double dof, double coverage);

struct MonteCarloSettings
{
    Index trials = 10000; ///< 0 = adaptive: batches of 10000 until stable to a digit, at most 1e6
    std::uint64_t seed = 1;
    Index shot = 0; ///< its own streams for inputs that are not common
    double coverage = 0.95;
};

/// Propagation of distributions (JCGM 101).
struct MonteCarloResult
{
    Index trials = 0;
    Eigen::VectorXd mean;
    Eigen::VectorXd u; ///< standard deviation
    Eigen::VectorXd low; ///< ends of the probabilistically symmetric interval
    Eigen::VectorXd high;
};

/// Each input has a random stream of its own, named by the quantity (and by the shot, unless it is
/// common), so that its draws do not depend on the other inputs or on threads;
/// those of correlated inputs are joined (CorrelatedDraws). An input with finite
/// dof is drawn from the scaled t distribution. Fails where f fails in any trial or gives a result
/// that is not finite, saying in how many, and (Usage) on fewer than 100 trials, on a coverage
/// outside 0..1 and on inputs as propagateGum().
Result<MonteCarloResult> propagateMonteCarlo(const std::vector<UncertainInput> &inputs,
    const Measurement &measurement, const MonteCarloSettings &settings,
    const JobControl &control = {});

/// JCGM 101, clause 8: the ends of both intervals agree within half of the last of `digits`
/// significant digits of u.
bool isValidated(const GumBudget &gum, const MonteCarloResult &monteCarlo, Index result,
    double coverage, int digits = 1);

} // namespace dyncal

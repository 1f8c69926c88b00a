// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/propagation.h"
#include "core/base/result.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dyncal {

/// Makes draws of independent probabilities into draws of correlated inputs, each with its own
/// distribution (a Gaussian copula: NORTA, M. C. Cario, B. L. Nelson 1997). The coefficients are
/// those of the normal deviates behind the draws; of rectangles they come out as 6/pi asin(r/2), at
/// most 2 % of r less.
class CorrelatedDraws
{
public:
    explicit CorrelatedDraws(const std::vector<UncertainInput> &inputs);

    /// `p`: a probability for each input; those of inputs without a correlation stay as they are.
    void apply(Eigen::VectorXd &p) const;

private:
    std::vector<Index> m_at; ///< the inputs that are correlated with others
    Eigen::MatrixXd m_root; ///< symmetric root of their correlation matrix
};

/// Number of the random stream of a quantity: FNV-1a of its name, so that its draws depend on
/// nothing else.
Index streamOf(const std::string &name);

/// The deviate of unit scale (unit variance, except for t) of the input's distribution that has the
/// probability p, 0 < p < 1, below it. Of a normal input with finite dof Student's t (JCGM 101,
/// 6.4.9).
double unitDraw(const UncertainInput &input, double p);

/// value + u unitDraw(p); the value itself where u is 0.
double drawnValue(const UncertainInput &input, double p);

/// Fails (Usage) on an input with an impossible value, u or dof and on two of one name.
Result<void> checkInputs(const std::vector<UncertainInput> &inputs);

/// Most trials of one propagation, fixed or adaptive.
inline constexpr Index kMostTrials = 1000000;

/// Fails (Usage) on fewer than 100 trials (0: adaptive), on more than kMostTrials and on a coverage
/// outside 0..1.
Result<void> checkMonteCarlo(const MonteCarloSettings &settings);

/// Half of the last of `digits` significant digits of u > 0 (JCGM 101, 7.9.2).
double numericalTolerance(double u, int digits);

} // namespace dyncal

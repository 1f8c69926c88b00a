// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <limits>
#include <string>
#include <vector>

namespace dyncal {

/// That the errors of a quantity go along with those of another: correlation coefficient r(x, y).
struct Correlation
{
    std::string quantity; ///< the other one
    double coefficient = 0.0; ///< -1 to 1
    bool operator==(const Correlation &) const = default;
};
using Correlations = std::vector<Correlation>;

/// A standard uncertainty with its effective degrees of freedom.
struct CombinedUncertainty
{
    double u = 0.0;
    double dof = std::numeric_limits<double>::infinity();
};

/// What one source contributes to one result, c = dy/dx u(x), signed.
struct VariancePart
{
    std::string quantity;
    double contribution = 0.0;
    double dof = std::numeric_limits<double>::infinity(); ///< else the source is known exactly
    Index shot = 0; ///< of one shot alone: not correlated with another's; 0 = of all
    Correlations correlated = {}; ///< stated at both parts, or at one
};

/// Share of each part in the variance, c_i^2 + sum over the others of r_ij c_i c_j; their sum is
/// u^2 (GUM, JCGM 100, 5.2.2). A share may be negative.
std::vector<double> varianceShares(const std::vector<VariancePart> &parts);

/// u and, of independent parts, Welch-Satterthwaite (G.4.1). That holds for independent parts only:
/// the correlated ones count as one, with the fewest degrees of freedom among them, as they would
/// have if the same observations had shown all of them.
CombinedUncertainty combinedParts(const std::vector<VariancePart> &parts);

} // namespace dyncal

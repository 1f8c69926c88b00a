// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/propagation.h"

#include <limits>
#include <string>
#include <vector>

namespace dyncal {

/// What more shots do to what a source contributes to a mean over shots.
enum class OverShots {
    Shared, ///< the same error in every shot: nothing
    Own, ///< every shot makes it anew: the mean has less of it
    Scatter, ///< the same, and u is the scatter of the shots: its dof are their number less some
};

/// What one source of uncertainty does to one reported value.
struct UncertaintyLine
{
    std::string quantity; ///< the source: "t1_k", "noise", "gain_relative"
    Index shot = 0; ///< of one shot alone; 0 = of all
    double value = kUnknown; ///< of the source
    double u = 0.0; ///< standard uncertainty of the source
    Distribution distribution = Distribution::Normal;
    double dof = std::numeric_limits<double>::infinity(); ///< of u
    double sensitivity = 1.0; ///< d value / d source
    double contribution = 0.0; ///< sensitivity u, signed, in the unit of the reported value
    OverShots overShots = OverShots::Shared;
    Correlations correlated = {}; ///< with other lines of the same value
};

/// Root of the sum of squares of the contributions, and Welch-Satterthwaite (GUM 5.1.2, G.4.1);
/// where lines are correlated as combinedParts(). Lines without finite, positive degrees of freedom
/// count as known exactly.
CombinedUncertainty combined(const std::vector<UncertaintyLine> &lines);

/// The lines as parts of a variance.
std::vector<VariancePart> partsOf(const std::vector<UncertaintyLine> &lines);

/// Whether one of the lines is correlated with others.
bool areCorrelated(const std::vector<UncertaintyLine> &lines);

/// A line whose contribution is its own u.
UncertaintyLine directLine(std::string quantity, double u,
    double dof = std::numeric_limits<double>::infinity(),
    Distribution distribution = Distribution::Normal);

/// The same line with what more shots do to it.
UncertaintyLine with(OverShots overShots, UncertaintyLine line);

/// The same for a value that is `factor` times as large.
std::vector<UncertaintyLine> scaled(std::vector<UncertaintyLine> lines, double factor);

} // namespace dyncal

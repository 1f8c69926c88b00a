// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/input/model_input.h"
#include "core/realization/input/nuisance_term.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace dyncal {

/// 100 (1 - sqrt(errorSquares / spreadSquares)): eq 4.1 in percent, from sums of squares.
double fitPercent(double errorSquares, double spreadSquares);

/// FIT with one decimal, as it is shown everywhere.
std::string fitPercentText(double percent);

/// Sum of squares about the mean.
double spreadSquares(const Eigen::VectorXd &y);

/// The sum with the nuisance terms at the samples of series.y, through the filter as the
/// measurement.
Eigen::VectorXd simulate(const ModelSeries &series, const ExponentialSum &sum,
    const std::vector<NuisanceTerm> &terms, double dt_s);

} // namespace dyncal

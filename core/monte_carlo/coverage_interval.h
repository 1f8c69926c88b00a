// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/index.h"

#include <Eigen/Core>

#include <limits>

namespace dyncal {

/// What the trials of one quantity say (JCGM 101, 7.6, 7.7), all in its unit.
struct DrawnQuantity
{
    Index trials = 0;
    Index undefined = 0; ///< trials in which it does not exist; with one of them all below is NaN
    double mean = kUnknown;
    double u = kUnknown; ///< standard deviation
    double low = kUnknown; ///< ends of the probabilistically symmetric interval
    double high = kUnknown;
    double shortestLow = kUnknown; ///< ends of the shortest one
    double shortestHigh = kUnknown;
    /// Expanded uncertainty: the least half width about the reported value that holds the share
    /// `coverage` of the trials; what "value +- U" needs, however skew the distribution is.
    double expanded = kUnknown;
    double leastExpanded = kUnknown; ///< between these two it lies, by the number of trials, with
    double mostExpanded = kUnknown; ///< a chance of 95 % (order statistics), or more: see below
    /// The fewest degrees of freedom among what was drawn: leaveOutMoments().
    double leastDof = std::numeric_limits<double>::infinity();
};

/// `values`: one of each trial, NaN where it does not exist; at least 2. `reported`: the value that
/// is stated. `coverage`: 0 to 1. Quantiles are interpolated between order statistics, the k-th at
/// (k - 1/2)/n. `comparisons`: how many quantities are looked at together; with a chance of 95 %
/// the U of all of them lie between their two limits (Bonferroni).
DrawnQuantity drawnQuantity(
    const Eigen::VectorXd &values, double reported, double coverage, Index comparisons = 1);

/// Student's distribution has a variance above two degrees of freedom and a mean above one (JCGM
/// 101, 6.4.9.4): what of them does not exist becomes unknown, whatever the trials' happen to be.
/// The interval stands.
void leaveOutMoments(double leastDof, DrawnQuantity &drawn);

} // namespace dyncal

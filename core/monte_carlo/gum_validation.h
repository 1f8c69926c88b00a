// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/monte_carlo/coverage_interval.h"
#include "core/uncertainty/reported_value.h"

#include <string>
#include <vector>

namespace dyncal {

/// The law of propagation held against the trials (JCGM 101, clause 8).
struct GumValidation
{
    double u = kUnknown; ///< of the budget, without a CMC
    double k = kUnknown; ///< Student's factor of the coverage at its degrees of freedom
    double low = kUnknown; ///< value - k u
    double high = kUnknown;
    double tolerance = kUnknown; ///< half of the last significant digit of u
    double d_low = kUnknown; ///< distance of the lower ends; 8.2
    double d_high = kUnknown;
    std::string largest; ///< the input that is more than half of the variance; empty: none is
    bool validated = false; ///< neither distance is above it, and no 5 % are between the U

    double expanded() const { return k * u; }
};

/// `value`, `dof`: of the reported value; `u` its combined standard uncertainty; one significant
/// digit. That is up to half of u, so that sizeOfGum() must be 0 too. Where trials have no result
/// it is not validated.
GumValidation validateGum(
    double value, double u, double dof, double coverage, const DrawnQuantity &drawn);

/// The same of a reported value, whose CMC (a decision, not a source) is left out.
GumValidation validateGum(
    const ReportedValue &reported, double coverage, const DrawnQuantity &drawn);

/// One reported value by both propagations.
struct DrawnValue
{
    std::string of; ///< as in `budget` of results.json
    std::string unit;
    double value = kUnknown; ///< as reported
    DrawnQuantity drawn;
    GumValidation gum;
};

/// The fewest degrees of freedom among the inputs that make its u: what its draws have.
double leastDofOf(const std::vector<UncertaintyLine> &lines);

/// From what difference of U on the two are told to differ (UNC-003).
inline constexpr double kExpandedDiffers = 0.05;

/// -1: the law of propagation gives a U that is too small, by more than kExpandedDiffers whatever
/// the number of trials leaves open; +1: too large; 0 neither.
int sizeOfGum(const GumValidation &gum, const DrawnQuantity &drawn);

} // namespace dyncal

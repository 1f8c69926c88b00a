// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <cmath>
#include <optional>
#include <span>
#include <string_view>

namespace dyncal {

/// A column of times taken as an axis t0 + k dt.
struct TimeAxis
{
    double first = 0.0; ///< in the unit of the column, like all here
    double step = 0.0; ///< (last - first) / (n - 1); the median step of an irregular axis
    double resolution = 0.0; ///< of the text: one unit of the last digit printed
    std::optional<Index> irregular; ///< row of the first step that is not `step`
    /// Of an axis whose steps are all equal enough but add up to something else than a straight
    /// line: by how many steps the row `irregular`, the worst, is off that line; else 0.
    double drift_steps = 0.0;
};

/// So far from the straight line, in steps, may a time be, beyond its printed digits: the nearest
/// sample is still the right one.
constexpr double kMostDrift_steps = 0.5;

/// Looks at times (at least two, in the unit in which they were printed). A step is irregular if it
/// differs from the mean step by more than 1 %; what the rounding of the printed digits explains is
/// forgiven as long as it is at most half a step, so that a missing sample would still show. Steps
/// that differ by less may add up: an axis that is further than kMostDrift_steps from a straight
/// line somewhere is irregular too, because the rate then is another here and there.
TimeAxis timeAxisOf(std::span<const double> times);

/// The same where the text is known to be printed to `resolution`.
TimeAxis timeAxisOf(std::span<const double> times, double resolution);

/// Two statements of a rate (or of an interval) that differ by more are a contradiction: CAP-003.
constexpr double kRateTolerance = 0.001;

/// Whether `a` is `b` within that tolerance; b is not 0.
inline bool ratesAgree(double a, double b)
{
    return std::abs(a / b - 1.0) <= kRateTolerance;
}

/// How a column rises from row to row.
enum class ColumnRise {
    None, ///< it falls somewhere, or there are too few rows to tell
    Counter, ///< by one from a whole number on
    Uniform, ///< by equal steps
    Gaps, ///< by equal steps but for a few
    Uneven, ///< somehow
};

/// Rows that are not finite are skipped, but make a gap.
ColumnRise riseOf(std::span<const double> values);

/// Whether this uniform axis only counts rows: whole numbers that rise by one.
bool isCounter(const TimeAxis &axis);

/// One unit of the last digit of a printed number: "0.0120" 1e-4, "1.5E-5" 1e-6.
double printedResolution(std::string_view cell, char decimal);

} // namespace dyncal

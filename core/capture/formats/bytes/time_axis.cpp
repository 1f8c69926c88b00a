// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/bytes/time_axis.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace dyncal {
namespace {

constexpr double kStepTolerance = 0.01; ///< of CAP-016
constexpr std::size_t kRowsToTellTime = 8; ///< so many rising rows are no accident
constexpr std::size_t kEndRows = 32; ///< some of them end in a digit other than zero

/// Power of ten of the last digit of a number.
int lastDigitExponent(std::string_view text, char decimal)
{
    const std::size_t mantissaEnd = std::min(text.find_first_of("eE"), text.size());
    const std::size_t point = text.find(decimal);
    int exponent = 0;
    if (mantissaEnd < text.size()) {
        text.remove_prefix(mantissaEnd + 1);
        if (text.starts_with('+'))
            text.remove_prefix(1);
        std::from_chars(text.data(), text.data() + text.size(), exponent);
    }
    const std::size_t decimals = point < mantissaEnd ? mantissaEnd - point - 1 : 0;
    return exponent - static_cast<int>(decimals);
}

/// The finest digit among these rows, as far as the values tell.
double finestDigit(std::span<const double> times)
{
    int finest = 0;
    for (const double time : times) {
        if (std::isfinite(time) && time != 0.0)
            finest = std::min(finest, lastDigitExponent(numberText(time), '.'));
    }
    return std::pow(10.0, finest);
}

/// First row that is further from its predecessor than step +- tolerance.
std::optional<Index> firstIrregular(std::span<const double> times, double step, double tolerance)
{
    for (std::size_t k = 1; k < times.size(); ++k) {
        if (!(std::abs(times[k] - times[k - 1] - step) <= tolerance))
            return static_cast<Index>(k);
    }
    return std::nullopt;
}

/// Marks the row that is furthest from the straight line between the first time and the last.
void findDrift(TimeAxis &axis, std::span<const double> times)
{
    double worst = 0.0;
    Index row = 0;
    for (std::size_t k = 1; k < times.size(); ++k) {
        const double line = axis.first + static_cast<double>(k) * axis.step;
        const double off = times[k] - line;
        if (std::abs(off) <= std::abs(worst))
            continue;
        worst = off;
        row = static_cast<Index>(k);
    }
    if (std::abs(worst) <= kMostDrift_steps * axis.step + axis.resolution)
        return;
    axis.irregular = row;
    axis.drift_steps = worst / axis.step;
}

double medianStep(std::span<const double> times)
{
    std::vector<double> steps;
    for (std::size_t k = 1; k < times.size(); ++k) {
        const double step = times[k] - times[k - 1];
        if (std::isfinite(step))
            steps.push_back(step);
    }
    if (steps.empty())
        return 0.0;
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// Uses the median step, because a gap changes the mean step.
void locateIrregularity(TimeAxis &axis, std::span<const double> times, double allowance)
{
    axis.step = medianStep(times);
    const double tolerance = kStepTolerance * std::abs(axis.step) + allowance;
    axis.irregular = firstIrregular(times, axis.step, tolerance).value_or(*axis.irregular);
}

} // namespace

TimeAxis timeAxisOf(std::span<const double> times)
{
    const std::size_t end = std::min(kEndRows, times.size());
    return timeAxisOf(times, std::max(finestDigit(times.first(end)), finestDigit(times.last(end))));
}

TimeAxis timeAxisOf(std::span<const double> times, double resolution)
{
    TimeAxis axis;
    axis.resolution = resolution;
    axis.first = times.front();
    axis.step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    const bool increases = axis.step > 0.0 && std::isfinite(axis.step);
    const double strict = kStepTolerance * axis.step;
    const double allowance = axis.resolution <= 0.5 * axis.step ? axis.resolution : 0.0;
    axis.irregular = increases ? firstIrregular(times, axis.step, strict) : 1;
    if (axis.irregular && increases && allowance > 0.0)
        axis.irregular = firstIrregular(times, axis.step, strict + allowance);
    if (axis.irregular)
        locateIrregularity(axis, times, allowance);
    else
        findDrift(axis, times);
    return axis;
}

ColumnRise riseOf(std::span<const double> values)
{
    double last = -std::numeric_limits<double>::infinity();
    std::size_t rises = 0;
    for (const double value : values) {
        if (value < last)
            return ColumnRise::None;
        rises += value > last ? 1 : 0;
        last = std::isfinite(value) ? value : last;
    }
    if (rises < kRowsToTellTime)
        return ColumnRise::None;
    const TimeAxis axis = timeAxisOf(values);
    if (!axis.irregular)
        return isCounter(axis) ? ColumnRise::Counter : ColumnRise::Uniform;
    std::size_t even = 0;
    for (std::size_t k = 1; k < values.size(); ++k) {
        const double difference = std::abs(values[k] - values[k - 1] - axis.step);
        even += difference <= kStepTolerance * axis.step + axis.resolution ? 1 : 0;
    }
    return 2 * even > values.size() ? ColumnRise::Gaps : ColumnRise::Uneven;
}

bool isCounter(const TimeAxis &axis)
{
    return axis.step == 1.0 && axis.first == std::floor(axis.first);
}

double printedResolution(std::string_view cell, char decimal)
{
    return std::pow(10.0, lastDigitExponent(cell, decimal));
}

} // namespace dyncal

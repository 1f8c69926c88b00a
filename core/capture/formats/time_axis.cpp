// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/time_axis.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace dyncal {
namespace {

constexpr double kStepTolerance = 0.01; ///< of CAP-016
constexpr std::size_t kEndRows = 32; ///< enough that some time ends in a digit other than zero

/// Power of ten of the last digit in the shortest text of a value.
int lastDigitExponent(double value)
{
    const std::string text = numberText(value);
    const std::size_t mantissaEnd = std::min(text.find('e'), text.size());
    const int exponent = mantissaEnd < text.size()
        ? static_cast<int>(*parseNumber(text.substr(mantissaEnd + 1)))
        : 0;
    const std::size_t point = text.find('.');
    const std::size_t decimals = point < mantissaEnd ? mantissaEnd - point - 1 : 0;
    return exponent - static_cast<int>(decimals);
}

/// The finest digit printed among these rows. Full double precision needs no allowance.
double printedResolution(std::span<const double> times)
{
    int finest = 0;
    for (const double time : times) {
        if (std::isfinite(time) && time != 0.0)
            finest = std::min(finest, lastDigitExponent(time));
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

/// The mean step is no help in saying where a gap is: the gap is in it.
void locateIrregularity(TimeAxis &axis, std::span<const double> times, double allowance)
{
    axis.step = medianStep(times);
    const double tolerance = kStepTolerance * std::abs(axis.step) + allowance;
    axis.irregular = firstIrregular(times, axis.step, tolerance).value_or(*axis.irregular);
}

} // namespace

TimeAxis timeAxisOf(std::span<const double> times)
{
    TimeAxis axis;
    axis.first = times.front();
    axis.step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    const std::size_t end = std::min(kEndRows, times.size());
    axis.resolution
        = std::max(printedResolution(times.first(end)), printedResolution(times.last(end)));
    const bool increases = axis.step > 0.0 && std::isfinite(axis.step);
    const double strict = kStepTolerance * axis.step;
    const double allowance = axis.resolution <= 0.5 * axis.step ? axis.resolution : 0.0;
    axis.irregular = increases ? firstIrregular(times, axis.step, strict) : 1;
    if (axis.irregular && increases && allowance > 0.0)
        axis.irregular = firstIrregular(times, axis.step, strict + allowance);
    if (axis.irregular)
        locateIrregularity(axis, times, allowance);
    return axis;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/history_curves.h"

#include "ui/plot/curves/curve_building.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {

namespace {

constexpr double kEndMargin = 0.08; // of the range, at each end
constexpr double kLeastSpan_years = 0.1;

BarPoints pointsOf(const std::vector<DatedValue> &values, bool beyond)
{
    BarPoints points;
    for (const DatedValue &one : values)
        if (one.isBeyond == beyond)
            points.push_back({one.year, one.value, one.U});
    return points;
}

void addLimits(const ControlLimits &limits, PlotContent &content)
{
    content.levels = {{limits.mean, Plots::tr("mean"), CurveRole::Mean},
        {limits.warningLow(), Plots::tr("warning limit"), CurveRole::Reference},
        {limits.warningHigh(), Plots::tr("warning limit"), CurveRole::Reference},
        {limits.actionLow(), Plots::tr("action limit"), CurveRole::Error},
        {limits.actionHigh(), Plots::tr("action limit"), CurveRole::Error}};
}

/// From the least to the most, with room at both ends: a single value has nothing to be scaled by.
Interval widened(double least, double most, double leastSpan)
{
    const double span = std::max(most - least, leastSpan);
    const double middle = 0.5 * (least + most), half = (0.5 + kEndMargin) * span;
    return {middle - half, middle + half};
}

void setView(const std::vector<DatedValue> &values, PlotContent &content)
{
    constexpr double kLeastSpanOfValue = 1e-6;
    double firstYear = values.front().year, lastYear = firstYear;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const DatedValue &one : values) {
        const double U = std::isfinite(one.U) ? one.U : 0.0;
        firstYear = std::min(firstYear, one.year);
        lastYear = std::max(lastYear, one.year);
        least = std::min(least, one.value - U);
        most = std::max(most, one.value + U);
    }
    for (const PlotLevel &level : content.levels) {
        least = std::min(least, level.y);
        most = std::max(most, level.y);
    }
    const Interval x = widened(firstYear, lastYear, kLeastSpan_years);
    const Interval y
        = widened(least, most, kLeastSpanOfValue * std::max(std::abs(least), std::abs(most)));
    content.xMin = x.begin;
    content.xMax = x.end;
    content.yMin = y.begin;
    content.yMax = y.end;
}

} // namespace

PlotContent historyCurves(const QString &quantity, const QString &unit,
    const std::vector<DatedValue> &values, const std::optional<ControlLimits> &limits)
{
    PlotContent content;
    content.title = quantity;
    content.xAxis = {Plots::tr("Year"), QString()};
    content.yAxis = {quantity, unit};
    if (limits)
        addLimits(*limits, content);
    const BarPoints beyond = pointsOf(values, true);
    addWithBars(Plots::tr("Calibrations"), CurveRole::ShotLow, pointsOf(values, false), content);
    addWithBars(Plots::tr("Conspicuous"), CurveRole::UnstablePole, beyond, content);
    if (!values.empty())
        setView(values, content);
    content.summary
        = Plots::tr("%1 of a sensor over time, with U; %2 of %3 calibrations are conspicuous.")
              .arg(quantity)
              .arg(beyond.size())
              .arg(values.size());
    return content;
}

} // namespace dyncal

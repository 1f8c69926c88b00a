// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/known_curves.h"

#include "ui/plot/curves/curve_building.h"
#include "ui/plot/values/axis_prefix.h"
#include "ui/text/shown_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

BarPoints pointsOfRows(const ResponseResult &response, const RowUncertainty &rows)
{
    BarPoints points;
    for (Index row = 0; rows.isComplete() && row < response.magnitude.size(); ++row)
        if (std::isfinite(response.magnitude[row]))
            points.push_back({response.frequency_Hz[row], response.magnitude[row],
                magnitudeOfRow(response, rows, row).expanded().value_or(kUnknown)});
    return points;
}

double lowestShown_Hz(const ResponseResult &response, const std::vector<KnownValue> &known)
{
    double lowest_Hz = response.fLow_Hz;
    for (const KnownValue &one : known)
        if (one.stated.frequency_Hz > 0.0)
            lowest_Hz = std::min(lowest_Hz, one.stated.frequency_Hz);
    return lowest_Hz;
}

BarPoints pointsOfKnown(const std::vector<KnownValue> &known, double static_Hz)
{
    BarPoints points;
    for (const KnownValue &one : known)
        if (one.isCompared())
            points.push_back({one.stated.frequency_Hz > 0.0 ? one.stated.frequency_Hz : static_Hz,
                one.other.value, one.other.expanded().value_or(kUnknown)});
    return points;
}

BarPoints asPercentFrom(double sensitivity, BarPoints points)
{
    const double toPercent = 100.0 / sensitivity;
    for (BarPoint &point : points)
        point = {point.x, toPercent * (point.y - sensitivity), toPercent * point.U};
    return points;
}

PlotContent withPoints(const BarPoints &rows, const BarPoints &known)
{
    PlotContent content;
    content.xAxis = frequencyAxisMeaning();
    addWithBars(Plots::tr("This calibration"), CurveRole::ShotLow, rows, content);
    addWithBars(Plots::tr("Other calibrations"), CurveRole::ShotHigh, known, content);
    return content;
}

void markStatic(const std::vector<KnownValue> &known, double static_Hz, PlotContent &content)
{
    const bool isThere = std::ranges::any_of(known,
        [](const KnownValue &one) { return one.isCompared() && !(one.stated.frequency_Hz > 0.0); });
    if (isThere)
        content.marks.push_back({static_Hz, Plots::tr("static"), CurveRole::Reference});
}

QString knownSummary(const std::vector<KnownValue> &known)
{
    const auto joined = std::ranges::count_if(known, &KnownValue::isJoined);
    return Plots::tr("S(f) beside %1 values of other calibrations; %2 agree within U.")
        .arg(known.size())
        .arg(joined);
}

} // namespace

PlotContent knownMagnitudeCurves(const ResponseResult &response, const UncertaintyReport &report)
{
    const double static_Hz = 0.5 * lowestShown_Hz(response, report.known);
    PlotContent content
        = withPoints(pointsOfRows(response, report.rows), pointsOfKnown(report.known, static_Hz));
    content.title = Plots::tr("Magnitude and values of other calibrations");
    content.yAxis = {Plots::tr("Magnitude"), shownText(response.unit), true};
    content.curves.insert(content.curves.begin(),
        {Plots::tr("Model"), CurveRole::Model, CurveStyle::Line,
            toVector(response.modelCurve.frequency_Hz), toVector(response.modelCurve.magnitude),
            true});
    markStatic(report.known, static_Hz, content);
    content.summary = knownSummary(report.known);
    return content;
}

PlotContent knownDeviationCurves(const ResponseResult &response, const UncertaintyReport &report)
{
    constexpr double kLeastReach_percent = 2.0;
    constexpr double kMargin = 1.5;
    const double static_Hz = 0.5 * lowestShown_Hz(response, report.known);
    const double sensitivity = std::abs(report.sensitivity->value);
    const BarPoints known = asPercentFrom(sensitivity, pointsOfKnown(report.known, static_Hz));
    PlotContent content
        = withPoints(asPercentFrom(sensitivity, pointsOfRows(response, report.rows)), known);
    content.title = Plots::tr("Less the sensitivity at the onset");
    content.yAxis = {Plots::tr("Deviation"), QStringLiteral("%")};
    double reach = kLeastReach_percent;
    for (const BarPoint &point : known)
        reach = std::max(reach, kMargin * (std::abs(point.y) + point.U));
    content.yMin = -reach;
    content.yMax = reach;
    markStatic(report.known, static_Hz, content);
    content.summary = knownSummary(report.known);
    return content;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/comparison_curves.h"

#include "ui/plot/curves/curve_building.h"
#include "ui/plot/values/axis_prefix.h"
#include "ui/text/shown_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

using Rows = std::vector<ComparedRow>;
using OneOfTwo = ReportedValue ComparedRow::*;

/// Bars, not a band: between two frequencies there may be a resonance.
PlotCurve barsOfOne(const QString &name, CurveRole role, const Rows &rows, OneOfTwo one)
{
    PlotCurve bars{name, role, CurveStyle::ErrorBars, {}, {}, true};
    for (const ComparedRow &row : rows) {
        const ReportedValue &stated = row.*one;
        const auto U = stated.expanded();
        if (!U || !std::isfinite(stated.value))
            continue;
        bars.x.insert(bars.x.end(), 3, row.frequency_Hz);
        bars.y.insert(bars.y.end(), {stated.value - *U, stated.value + *U, std::nan("")});
    }
    return bars;
}

PlotCurve dotsOfOne(const QString &name, CurveRole role, const Rows &rows, OneOfTwo one)
{
    PlotCurve dots{name, role, CurveStyle::Markers, {}, {}, true};
    for (const ComparedRow &row : rows) {
        if (!std::isfinite((row.*one).value))
            continue;
        dots.x.push_back(row.frequency_Hz);
        dots.y.push_back((row.*one).value);
    }
    return dots;
}

void addUnlessEmpty(PlotContent &content, PlotCurve curve)
{
    if (!curve.x.empty())
        content.curves.push_back(std::move(curve));
}

QString comparisonSummary(const ComparisonResult &comparison)
{
    if (!comparison.againstStep)
        return Plots::tr(
            "Magnitude against the reference transducer; the pressure step is not known well enough to compare.");
    return Plots::tr(
        "Magnitude against the reference transducer and against the pressure step; these differ by %1 on the mean.")
        .arg(valueWithUnit(
            100.0 * comparison.againstStep->difference_relative, QStringLiteral("%"), 2));
}

/// Both, as values and bars.
void addBoth(PlotContent &content, const Rows &rows)
{
    const QString byStep = Plots::tr("Pressure step"), byRef = Plots::tr("Reference transducer");
    const QString withU = Plots::tr("%1, ± U");
    addUnlessEmpty(
        content, barsOfOne(withU.arg(byStep), CurveRole::ShotLow, rows, &ComparedRow::byStep));
    addUnlessEmpty(content,
        barsOfOne(withU.arg(byRef), CurveRole::ShotHigh, rows, &ComparedRow::byTransducer));
    addUnlessEmpty(content, dotsOfOne(byStep, CurveRole::ShotLow, rows, &ComparedRow::byStep));
    addUnlessEmpty(
        content, dotsOfOne(byRef, CurveRole::ShotHigh, rows, &ComparedRow::byTransducer));
}

/// In percent of `mean`, from it; u and the least U with it.
void relateTo(double mean, ReportedValue &stated)
{
    const double toPercent = 100.0 / mean;
    stated.value = toPercent * (stated.value - mean);
    stated.leastExpanded *= toPercent;
    if (stated.u)
        *stated.u *= toPercent;
}

/// Rows that both have.
Rows asDeviations(Rows rows)
{
    for (ComparedRow &row : rows) {
        const double mean = 0.5 * (row.byStep.value + row.byTransducer.value);
        relateTo(mean, row.byStep);
        relateTo(mean, row.byTransducer);
    }
    return rows;
}

/// Room for the limits, whatever the values are.
void showLimits(PlotContent &content, const PlotCurve &curve)
{
    double reach = 1.0;
    for (const double e_n : curve.y)
        reach = std::max(reach, std::abs(e_n));
    content.yMax = 1.2 * reach;
    content.yMin = -*content.yMax;
    content.levels = {{1.0, Plots::tr("limit"), CurveRole::Reference},
        {-1.0, Plots::tr("limit"), CurveRole::Reference}};
}

} // namespace

PlotContent comparedMagnitudeCurves(const ComparisonResult &comparison)
{
    const Rows rows = comparedRows(comparison);
    const ResponseResult &response = comparison.byTransducer->response;
    PlotContent content;
    content.title = Plots::tr("Magnitude against reference transducer and pressure step");
    content.xAxis = frequencyAxisMeaning();
    const QString unit = shownText(response.unit);
    content.yAxis = {Plots::tr("Magnitude"), unit == QLatin1String("1") ? QString() : unit, true};
    addUnlessEmpty(content,
        {Plots::tr("Model"), CurveRole::Model, CurveStyle::Line,
            toVector(response.modelCurve.frequency_Hz), toVector(response.modelCurve.magnitude),
            true});
    addBoth(content, rows);
    content.summary = comparisonSummary(comparison);
    return content;
}

PlotContent comparedDeviationCurves(const ComparisonResult &comparison)
{
    PlotContent content;
    content.title = Plots::tr("Both magnitudes less their mean");
    content.xAxis = frequencyAxisMeaning();
    content.yAxis = {Plots::tr("Deviation"), QStringLiteral("%")};
    addBoth(content, asDeviations(comparedRows(comparison)));
    content.summary = comparisonSummary(comparison);
    return content;
}

PlotContent normalisedErrorCurves(const ComparisonResult &comparison)
{
    PlotContent content;
    content.title = Plots::tr("Step less transducer, over the U of the difference");
    content.xAxis = frequencyAxisMeaning();
    content.yAxis = {Plots::tr("Eₙ"), QString()};
    PlotCurve curve{Plots::tr("Eₙ"), CurveRole::Error, CurveStyle::LineAndDots, {}, {}, false};
    for (const ComparedRow &row : comparedRows(comparison)) {
        if (!std::isfinite(row.e_n))
            continue;
        curve.x.push_back(row.frequency_Hz);
        curve.y.push_back(row.e_n);
    }
    showLimits(content, curve);
    const auto beyond
        = std::ranges::count_if(curve.y, [](double e_n) { return std::abs(e_n) > 1.0; });
    content.summary = Plots::tr("Eₙ over frequency; beyond ±1 at %1 of %2 frequencies.")
                          .arg(beyond)
                          .arg(curve.x.size());
    addUnlessEmpty(content, std::move(curve));
    return content;
}

} // namespace dyncal

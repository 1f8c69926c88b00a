// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/uncertainty_curves.h"

#include "ui/plot/curves/curve_building.h"
#include "ui/plot/values/axis_prefix.h"
#include "ui/text/shown_text.h"

#include <cmath>

namespace dyncal {

namespace {

BarPoints pointsWithU(const std::vector<Budget> &budgets)
{
    BarPoints points;
    for (const Budget &budget : budgets)
        if (const auto U = budget.reported.expanded(); budget.kind == BudgetOf::Magnitude && U)
            points.push_back({budget.frequency_Hz, budget.reported.value, *U});
    return points;
}

PlotCurve relativeU(const QString &name, CurveRole role, const std::vector<Budget> &budgets)
{
    PlotCurve curve{name, role, CurveStyle::LineAndDots, {}, {}, true};
    curve.onSecondAxis = true;
    for (const Budget &budget : budgets) {
        const auto U = budget.reported.expanded();
        if (budget.kind != BudgetOf::Magnitude || !U)
            continue;
        curve.x.push_back(budget.frequency_Hz);
        curve.y.push_back(100.0 * *U / std::abs(budget.reported.value));
    }
    return curve;
}

PlotCurve valuesOf(const std::vector<Budget> &budgets)
{
    PlotCurve dots{
        Plots::tr("Non-parametric"), CurveRole::Measured, CurveStyle::Dots, {}, {}, true};
    for (const Budget &budget : budgets) {
        if (budget.kind != BudgetOf::Magnitude)
            continue;
        dots.x.push_back(budget.frequency_Hz);
        dots.y.push_back(budget.reported.value);
    }
    return dots;
}

void addIfAny(PlotContent &content, PlotCurve curve)
{
    if (!curve.x.empty())
        content.curves.push_back(std::move(curve));
}

QString summaryOf(const PlotCurve &relative)
{
    if (relative.y.empty())
        return Plots::tr(
            "Magnitude of the frequency response; its expanded uncertainty is not known.");
    const auto [least, most] = std::ranges::minmax_element(relative.y);
    return Plots::tr("Magnitude of the frequency response; U is %1 to %2 of it.")
        .arg(valueWithUnit(*least, QStringLiteral("%"), 2),
            valueWithUnit(*most, QStringLiteral("%"), 2));
}

} // namespace

PlotContent expandedMagnitudeCurves(const ResponseResult &response,
    const std::vector<Budget> &budgets, const std::vector<Budget> &tried,
    std::optional<double> marked_Hz)
{
    PlotContent content;
    content.title = Plots::tr("Frequency response with its expanded uncertainty U");
    content.xAxis = frequencyAxisMeaning();
    const QString unit = shownText(response.unit);
    content.yAxis = {Plots::tr("Magnitude"), unit == QLatin1String("1") ? QString() : unit, true};
    addIfAny(content,
        {Plots::tr("Model"), CurveRole::Model, CurveStyle::Line,
            toVector(response.modelCurve.frequency_Hz), toVector(response.modelCurve.magnitude),
            true});
    addIfAny(content, barsOf(Plots::tr("± U"), CurveRole::Noise, pointsWithU(budgets)));
    addIfAny(content, valuesOf(budgets));
    const PlotCurve relative = relativeU(Plots::tr("U, relative"), CurveRole::Error, budgets);
    content.summary = summaryOf(relative);
    addIfAny(content, relative);
    addIfAny(content, relativeU(Plots::tr("U, what if"), CurveRole::Suggestion, tried));
    if (!relative.x.empty())
        content.yAxis2 = PlotAxis{Plots::tr("U"), QStringLiteral("%"), true};
    if (marked_Hz)
        content.marks.push_back({*marked_Hz, Plots::tr("budget"), CurveRole::Reference});
    return content;
}

std::vector<ResponseRow> rowsOf(const std::vector<Budget> &budgets)
{
    std::vector<ResponseRow> rows;
    for (const Budget &budget : budgets)
        if (budget.kind == BudgetOf::Magnitude)
            rows.push_back({budget.frequency_Hz, budget.reported.value,
                budget.reported.expanded().value_or(kUnknown)});
    return rows;
}

void layOver(const EarlierResponse &earlier, const QString &name, PlotContent &content)
{
    BarPoints points;
    for (const ResponseRow &row : earlier.rows)
        points.push_back({row.frequency_Hz, row.magnitude, row.U});
    addWithBars(name, CurveRole::ShotHigh, points, content);
}

} // namespace dyncal

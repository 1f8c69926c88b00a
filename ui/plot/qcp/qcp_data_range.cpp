// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_data_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {

namespace {

constexpr double kNarrowest = 1e-9; ///< of what shows all: a tenth of a sample of 100 MS
constexpr double kWidest = 1e6;
constexpr double kLeastRelativeWidth
    = 1e-12; ///< of the larger bound; less leaves no digits for pixels

QCPRange widened(QCPRange range, const PlotAxis &axis, double margin)
{
    if (axis.logarithmic) {
        const double factor
            = range.upper > range.lower ? std::pow(range.upper / range.lower, margin) : 3.0;
        return {range.lower / factor, range.upper * factor};
    }
    double extra = margin * range.size();
    if (!(range.size() > 0.0))
        extra = range.lower == 0.0 ? 1.0 : 0.1 * std::abs(range.lower);
    return {range.lower - extra, range.upper + extra};
}

bool hasMargin(const PlotCurve &curve)
{
    return curve.style == CurveStyle::Markers || curve.style == CurveStyle::Dots
        || curve.style == CurveStyle::Bars || curve.style == CurveStyle::Stems;
}

QCPRange exponentsOf(const QCPRange &range)
{
    constexpr double kLeast = std::numeric_limits<double>::min();
    return {std::log10(std::max(range.lower, kLeast)), std::log10(std::max(range.upper, kLeast))};
}

} // namespace

QCPRange drawableRange(const QCPRange &range, const QCPRange &home, bool logarithmic)
{
    if (logarithmic) {
        const QCPRange exponents = exponentsOf(range);
        const QCPRange near = drawableRange(exponents, exponentsOf(home), false);
        return near == exponents ? range
                                 : QCPRange(std::pow(10.0, near.lower), std::pow(10.0, near.upper));
    }
    const double whole = home.size();
    if (!(whole > 0.0) || !std::isfinite(whole))
        return range;
    const double far = kWidest * whole;
    const double center = std::isfinite(range.center())
        ? std::clamp(range.center(), home.center() - far, home.center() + far)
        : home.center();
    const double least = std::max(kNarrowest * whole, kLeastRelativeWidth * std::abs(center));
    const double size = std::isfinite(range.size()) ? std::clamp(range.size(), least, far) : whole;
    if (size == range.size() && center == range.center())
        return range;
    return {center - 0.5 * size, center + 0.5 * size};
}

QCPRange dataRange(DataAxis of, const PlotContent &content, const std::vector<DrawnCurve> &curves)
{
    const bool alongX = of == DataAxis::X;
    const bool second = of == DataAxis::SecondY;
    const PlotAxis axis = alongX ? content.xAxis
        : second                 ? content.yAxis2.value_or(PlotAxis())
                                 : content.yAxis;
    bool any = false;
    bool margin = !alongX;
    QCPRange range(0.0, 0.0);
    const auto include = [&](double value) {
        if (!std::isfinite(value) || (axis.logarithmic && !(value > 0.0)))
            return;
        range.lower = any ? std::min(range.lower, value) : value;
        range.upper = any ? std::max(range.upper, value) : value;
        any = true;
    };
    for (const DrawnCurve &drawn : curves) {
        if (!drawn.visible || (!alongX && drawn.curve->onSecondAxis != second))
            continue;
        for (const double value : alongX ? drawn.x() : drawn.y())
            include(value);
        if (drawn.bars && !alongX)
            include(0.0);
        margin = margin || hasMargin(*drawn.curve);
    }
    if (any && !alongX && !second)
        for (const PlotLevel &level : content.levels)
            include(level.y);
    if (content.unitCircle && !second) {
        include(-1.0);
        include(1.0);
    }
    if (!any)
        return axis.logarithmic ? QCPRange(1.0, 10.0) : QCPRange(0.0, 1.0);
    const bool single = !(range.upper > range.lower);
    return widened(range, axis, margin || single ? 0.05 : 0.0);
}

} // namespace dyncal

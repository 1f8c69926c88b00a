// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/content_comparison.h"

#include <algorithm>
#include <cstring>

namespace dyncal {

namespace {

bool isSame(const PlotAxis &a, const PlotAxis &b)
{
    return a.quantity == b.quantity && a.unit == b.unit && a.logarithmic == b.logarithmic
        && a.integers == b.integers;
}

/// Compares bits, so that a gap (NaN) equals a gap.
bool isSame(const std::vector<double> &a, const std::vector<double> &b)
{
    return a.size() == b.size()
        && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

bool isSame(const PlotCurve &a, const PlotCurve &b)
{
    return a.name == b.name && a.role == b.role && a.style == b.style && a.inLegend == b.inLegend
        && a.variant == b.variant && a.record == b.record && a.onSecondAxis == b.onSecondAxis
        && isSame(a.x, b.x) && isSame(a.y, b.y);
}

} // namespace

bool isSameButDecorations(const PlotContent &a, const PlotContent &b)
{
    const bool sameSecond = a.yAxis2.has_value() == b.yAxis2.has_value()
        && (!a.yAxis2 || isSame(*a.yAxis2, *b.yAxis2));
    return a.title == b.title && isSame(a.xAxis, b.xAxis) && isSame(a.yAxis, b.yAxis) && sameSecond
        && a.equalAspect == b.equalAspect && a.unitCircle == b.unitCircle && a.xMin == b.xMin
        && a.xMax == b.xMax && a.yMin == b.yMin && a.yMax == b.yMax && a.growing == b.growing
        && a.dampingGridRate_Hz == b.dampingGridRate_Hz && a.marks.size() == b.marks.size()
        && std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(),
            [](const PlotLevel &x, const PlotLevel &y) { // bands lie behind the curves
                return x.from == y.from && (!x.from || x.y == y.y);
            })
        && std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
            [](const PlotCurve &x, const PlotCurve &y) { return isSame(x, y); });
}

bool hasSameDecorations(const PlotContent &a, const PlotContent &b)
{
    return a.marks == b.marks && a.levels == b.levels;
}

} // namespace dyncal

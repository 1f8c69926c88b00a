// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/long_curves.h"

#include "ui/plot/values/curve_envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dyncal {

namespace {

constexpr int kColumns = 4000; ///< of the whole curve: as many as of a recording

struct Numbers
{
    std::vector<double> x;
    std::vector<double> y;
};

/// An envelope that keeps its numbers: a base before it, so that they are there first.
class KeptCurve : private Numbers, public CurveEnvelope
{
public:
    explicit KeptCurve(Numbers numbers)
        : Numbers(std::move(numbers))
        , CurveEnvelope(Numbers::x, Numbers::y)
    {
    }
};

bool isCondensable(const PlotCurve &curve, Index most)
{
    return !curve.record && curve.x.size() == curve.y.size() && std::ssize(curve.x) > most
        && curve.style == CurveStyle::Line && std::ranges::is_sorted(curve.x);
}

/// What a plot would not show anyway.
void leaveOutUnshowable(const PlotContent &content, bool onSecondAxis, Numbers &numbers)
{
    const bool logX = content.xAxis.logarithmic;
    const bool second = onSecondAxis && content.yAxis2;
    const bool logY = second ? content.yAxis2->logarithmic : content.yAxis.logarithmic;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < numbers.x.size(); ++i) {
        const double x = numbers.x[i];
        if (!std::isfinite(x) || (logX && !(x > 0.0)))
            continue;
        const double y = numbers.y[i];
        numbers.x[kept] = x;
        numbers.y[kept++] = logY && !(y > 0.0) ? std::numeric_limits<double>::quiet_NaN() : y;
    }
    numbers.x.resize(kept);
    numbers.y.resize(kept);
}

std::vector<double> edgesOf(double from, double to, bool logarithmic)
{
    std::vector<double> edges(kColumns + 1);
    for (int k = 0; k <= kColumns; ++k) {
        const double share = static_cast<double>(k) / kColumns;
        edges[static_cast<std::size_t>(k)]
            = logarithmic ? from * std::pow(to / from, share) : from + share * (to - from);
    }
    edges.back() = to; // whatever rounding says, the last point is in the last column
    return edges;
}

void condense(const PlotContent &content, PlotCurve &curve)
{
    Numbers numbers{std::move(curve.x), std::move(curve.y)};
    leaveOutUnshowable(content, curve.onSecondAxis, numbers);
    if (numbers.x.empty()) {
        curve.x.clear();
        curve.y.clear();
        return;
    }
    const std::vector<double> edges
        = edgesOf(numbers.x.front(), numbers.x.back(), content.xAxis.logarithmic);
    auto record = std::make_shared<const KeptCurve>(std::move(numbers));
    DrawnPoints whole = record->points(edges);
    curve.x = std::move(whole.x);
    curve.y = std::move(whole.y);
    curve.record = std::move(record);
}

} // namespace

PlotContent condensed(PlotContent content, Index most)
{
    for (PlotCurve &curve : content.curves)
        if (isCondensable(curve, most))
            condense(content, curve);
    return content;
}

} // namespace dyncal

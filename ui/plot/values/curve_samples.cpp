// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/curve_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dyncal {

namespace {

/// Up to this many samples per column are drawn as they are: the polyline is then as exact.
constexpr Index kSamplesPerColumn = 4;
/// A column of this many grains (grain() samples each) may begin half a grain off unseen.
constexpr Index kGrainsPerColumn = 8;

void appendColumn(const SampleExtremes &found, double x, DrawnPoints &drawn)
{
    double first = found.any ? found.min : std::numeric_limits<double>::quiet_NaN();
    double second = found.any ? found.max : first;
    // Begin with the value nearer to the end of the line so far: no needless vertical strokes.
    if (!drawn.y.empty() && std::abs(drawn.y.back() - second) < std::abs(drawn.y.back() - first))
        std::swap(first, second);
    drawn.x.insert(drawn.x.end(), {x, x});
    drawn.y.insert(drawn.y.end(), {first, second});
}

} // namespace

std::vector<Index> CurveSamples::sampleEdges(std::span<const double> edges) const
{
    std::vector<Index> found;
    found.reserve(edges.size());
    for (const double edge : edges.first(edges.size() - 1))
        found.push_back(firstFrom(edge));
    found.push_back(firstBeyond(edges.back()));
    const Index grains = grain();
    const auto columns = static_cast<Index>(edges.size()) - 1;
    if (found.back() - found.front() >= kGrainsPerColumn * grains * columns)
        for (Index &edge : found)
            edge = edge == size() ? edge : (edge + grains / 2) / grains * grains;
    return found;
}

double CurveSamples::placeOf(double x, double y, std::span<const double> edges) const
{
    const auto after = std::ranges::upper_bound(edges, x);
    if (after == edges.begin() || after == edges.end())
        return x;
    const std::vector<Index> from = sampleEdges(edges);
    const auto column = static_cast<std::size_t>(after - edges.begin()) - 1;
    Index begin = from[column];
    Index end = from[column + 1];
    while (end - begin > 1) {
        const Index middle = begin + (end - begin) / 2;
        const SampleExtremes first = stretches(std::array{begin, middle}).front();
        (first.any && (first.min == y || first.max == y) ? end : begin) = middle;
    }
    const DrawnPoints found = samples(begin, end);
    return found.x.empty() ? x : found.x.front();
}

DrawnPoints CurveSamples::points(std::span<const double> edges) const
{
    if (edges.size() < 2 || size() == 0)
        return {};
    const auto columns = static_cast<Index>(edges.size()) - 1;
    const Index begin = std::max<Index>(0, firstFrom(edges.front()) - 1);
    const Index end = std::min(size(), firstBeyond(edges.back()) + 1);
    if (end - begin <= kSamplesPerColumn * columns)
        return samples(begin, end);

    DrawnPoints drawn;
    drawn.enveloped = true;
    drawn.x.reserve(static_cast<std::size_t>(2 * columns));
    drawn.y.reserve(static_cast<std::size_t>(2 * columns));
    const std::vector<Index> from = sampleEdges(edges);
    const std::vector<SampleExtremes> found = stretches(from);
    for (std::size_t column = 0; column < found.size(); ++column)
        if (from[column + 1] > from[column])
            appendColumn(found[column], 0.5 * (edges[column] + edges[column + 1]), drawn);
    return drawn;
}

} // namespace dyncal

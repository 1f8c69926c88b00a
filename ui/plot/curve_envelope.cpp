// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curve_envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {

namespace {

constexpr Index kFirstBlock = 64;
constexpr Index kFanOut = 4;
/// Up to this many samples per column are drawn as they are: the polyline is then as exact.
constexpr Index kSamplesPerColumn = 4;

void include(CurveEnvelope::Extremes &found, double low, double high)
{
    if (std::isnan(low))
        return;
    found.min = found.any ? std::min(found.min, low) : low;
    found.max = found.any ? std::max(found.max, high) : high;
    found.any = true;
}

} // namespace

CurveEnvelope::CurveEnvelope(std::span<const double> x, std::span<const double> y)
    : m_x(x)
    , m_y(y)
{
    const Index count = size();
    for (Index block = kFirstBlock; block <= count; block *= kFanOut) {
        const Index blocks = count / block;
        Level level;
        level.blockSize = block;
        level.min.reserve(static_cast<std::size_t>(blocks));
        level.max.reserve(static_cast<std::size_t>(blocks));
        for (Index k = 0; k < blocks; ++k) {
            // Uses the finer level that is already there.
            const Extremes found = extremes(k * block, (k + 1) * block);
            const double none = std::numeric_limits<double>::quiet_NaN();
            level.min.push_back(found.any ? found.min : none);
            level.max.push_back(found.any ? found.max : none);
        }
        m_levels.push_back(std::move(level));
    }
}

void CurveEnvelope::scanSamples(Index begin, Index end, Extremes &found) const
{
    for (Index i = begin; i < end; ++i) {
        const double y = m_y[static_cast<std::size_t>(i)];
        include(found, y, y);
    }
}

CurveEnvelope::Extremes CurveEnvelope::extremes(Index begin, Index end) const
{
    Extremes found;
    Index i = begin;
    while (i < end) {
        // The coarsest block that starts here and ends within the stretch.
        const Level *usable = nullptr;
        for (const Level &level : m_levels) {
            if (i % level.blockSize != 0 || i + level.blockSize > end)
                break;
            usable = &level;
        }
        if (usable) {
            const auto block = static_cast<std::size_t>(i / usable->blockSize);
            include(found, usable->min[block], usable->max[block]);
            i += usable->blockSize;
        } else {
            const Index next = std::min(end, (i / kFirstBlock + 1) * kFirstBlock);
            scanSamples(i, next, found);
            i = next;
        }
    }
    return found;
}

Index CurveEnvelope::firstFrom(double value) const
{
    return std::lower_bound(m_x.begin(), m_x.end(), value) - m_x.begin();
}

Index CurveEnvelope::firstBeyond(double value) const
{
    return std::upper_bound(m_x.begin(), m_x.end(), value) - m_x.begin();
}

DrawnPoints CurveEnvelope::samples(Index begin, Index end) const
{
    DrawnPoints drawn;
    drawn.x.assign(m_x.begin() + begin, m_x.begin() + end);
    drawn.y.assign(m_y.begin() + begin, m_y.begin() + end);
    return drawn;
}

void CurveEnvelope::appendColumn(const Extremes &found, double x, DrawnPoints &drawn) const
{
    double first = found.any ? found.min : std::numeric_limits<double>::quiet_NaN();
    double second = found.any ? found.max : first;
    // Begin with the end that is nearer to where the line is: no needless verticals.
    if (!drawn.y.empty() && std::abs(drawn.y.back() - second) < std::abs(drawn.y.back() - first))
        std::swap(first, second);
    drawn.x.insert(drawn.x.end(), {x, x});
    drawn.y.insert(drawn.y.end(), {first, second});
}

DrawnPoints CurveEnvelope::points(std::span<const double> edges) const
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
    Index from = firstFrom(edges[0]);
    for (std::size_t column = 0; column + 1 < edges.size(); ++column) {
        const bool last = column + 2 == edges.size();
        const Index to = last ? firstBeyond(edges.back()) : firstFrom(edges[column + 1]);
        if (to > from)
            appendColumn(extremes(from, to), 0.5 * (edges[column] + edges[column + 1]), drawn);
        from = to;
    }
    return drawn;
}

} // namespace dyncal

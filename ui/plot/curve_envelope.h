// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <span>
#include <vector>

namespace dyncal {

/// Points to draw for one view of a curve.
struct DrawnPoints
{
    std::vector<double> x;
    std::vector<double> y;
    bool enveloped = false; ///< two points per pixel column; else the samples themselves
};

/// Exact minima and maxima over any stretch of a curve in O(log n): blocks of 64 samples, then
/// blocks of 4 blocks and so on. Never plain decimation: a spike of one sample stays visible.
/// Keeps views of the samples: they must outlive it. x ascending; NaN in y is skipped.
class CurveEnvelope
{
public:
    struct Extremes
    {
        double min = 0.0;
        double max = 0.0;
        bool any = false; ///< false: no number in the stretch
    };

    CurveEnvelope(std::span<const double> x, std::span<const double> y);

    Index size() const { return static_cast<Index>(m_x.size()); }
    /// Extremes of y over samples [begin, end).
    Extremes extremes(Index begin, Index end) const;
    /// First sample with x >= `value`.
    Index firstFrom(double value) const;
    Index firstBeyond(double value) const; ///< first sample with x > `value`
    /// What to draw for columns between ascending `edges` (one more than columns): the samples
    /// (and one neighbour at either side) while they are few, else min and max of each column.
    DrawnPoints points(std::span<const double> edges) const;

private:
    struct Level
    {
        Index blockSize = 0;
        std::vector<double> min; ///< NaN where the block holds no number
        std::vector<double> max;
    };
    void scanSamples(Index begin, Index end, Extremes &found) const;
    void appendColumn(const Extremes &found, double x, DrawnPoints &drawn) const;
    DrawnPoints samples(Index begin, Index end) const;

    std::span<const double> m_x;
    std::span<const double> m_y;
    std::vector<Level> m_levels; ///< finest first
};

} // namespace dyncal

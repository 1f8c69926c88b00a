// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/envelope_pyramid.h"

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

/// The samples of a curve, x ascending, as a plot asks for them: however many there are, a view
/// costs about what its pixels cost.
class CurveSamples
{
public:
    CurveSamples() = default;
    CurveSamples(const CurveSamples &) = delete;
    CurveSamples &operator=(const CurveSamples &) = delete;
    virtual ~CurveSamples() = default;

    virtual Index size() const = 0;
    virtual Index firstFrom(double x) const = 0; ///< first sample with x >= `x`
    virtual Index firstBeyond(double x) const = 0; ///< first sample with x > `x`
    /// Samples [begin, end) as they are; y is NaN where they cannot be read any more.
    virtual DrawnPoints samples(Index begin, Index end) const = 0;

    /// What to draw for columns between ascending `edges` (one more than columns): the samples
    /// (and one neighbour at either side) while they are few, else min and max of each column.
    /// Never plain decimation: a spike of one sample stays visible.
    DrawnPoints points(std::span<const double> edges) const;
    /// Where in its column the sample lies that gave (`x`, `y`) of an enveloped points(edges).
    double placeOf(double x, double y, std::span<const double> edges) const;

protected:
    /// Extremes of [edges[k], edges[k + 1]); `edges` ascend within 0..size().
    virtual std::vector<SampleExtremes> stretches(std::span<const Index> edges) const = 0;
    /// If columns hold many times this number of samples, their edges are moved to multiples of it.
    virtual Index grain() const { return 1; }

private:
    std::vector<Index> sampleEdges(std::span<const double> edges) const;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/curve_samples.h"

namespace dyncal {

/// The samples of a curve that is held as numbers, with exact minima and maxima of any stretch.
/// Keeps views of the samples: they must outlive it. x ascending; NaN and infinities in y are
/// skipped.
class CurveEnvelope : public CurveSamples
{
public:
    CurveEnvelope(std::span<const double> x, std::span<const double> y);

    /// Extremes of y over samples [begin, end).
    SampleExtremes extremes(Index begin, Index end) const;

    Index size() const override { return static_cast<Index>(m_x.size()); }
    Index firstFrom(double x) const override;
    Index firstBeyond(double x) const override;
    DrawnPoints samples(Index begin, Index end) const override;

protected:
    std::vector<SampleExtremes> stretches(std::span<const Index> edges) const override;

private:
    std::span<const double> m_x;
    std::span<const double> m_y;
    EnvelopePyramid m_pyramid;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/curve_samples.h"
#include "ui/plot/values/plot_content.h"
#include "ui/plot/values/plot_theme.h"

#include <qcustomplot.h>

#include <memory>
#include <vector>

namespace dyncal {

QCPScatterStyle scatterStyle(MarkerShape shape, const QColor &color, double size);

/// A graph whose legend icon shows dash and marker together; markers are drawn by another graph.
/// Dashes are drawn as lines of their own: drawn as one dashed path, a ringing curve with its many
/// crossings takes the rasteriser 25 times as long.
class RoleGraph : public QCPGraph
{
public:
    using QCPGraph::QCPGraph;
    void setLegendMarker(const QCPScatterStyle &marker) { m_legendMarker = marker; }

protected:
    void drawLegendIcon(QCPPainter *painter, const QRectF &rect) const override;
    void drawLinePlot(QCPPainter *painter, const QVector<QPointF> &lines) const override;
    /// Only those in view: far outside Qt's rasteriser fails.
    void drawScatterPlot(QCPPainter *painter, const QVector<QPointF> &scatters,
        const QCPScatterStyle &style) const override;

private:
    QCPScatterStyle m_legendMarker;
};

/// One curve as QCustomPlot draws it, and the samples it comes from.
struct DrawnCurve
{
    const PlotCurve *curve = nullptr;
    RoleGraph *graph = nullptr; ///< null for bars
    RoleGraph *markers = nullptr; ///< a few role markers along a line, or dots on every sample
    QCPBars *bars = nullptr;
    /// Sorted, positive on logarithmic axes; empty if the content's own vectors can be used as they
    /// are.
    std::vector<double> ownX, ownY;
    std::shared_ptr<const CurveSamples> samples; ///< these values, or the long record behind them
    bool dense = false; ///< too many points to hand over: drawn by columns
    std::vector<double> drawnEdges; ///< columns that the graph has now
    bool enveloped = false; ///< they hold extremes, not single samples
    bool visible = true;

    QCPAbstractPlottable *plottable() const;
    const std::vector<double> &x() const { return ownX.empty() ? curve->x : ownX; }
    const std::vector<double> &y() const { return ownX.empty() ? curve->y : ownY; }
};

} // namespace dyncal

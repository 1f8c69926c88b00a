// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_curve.h"

#include <memory>
#include <set>
#include <vector>

namespace dyncal {

/// The curves of one content on one QCustomPlot. Of a long one only the part in view is handed
/// over, reduced to pixel columns.
class SceneCurves
{
public:
    explicit SceneCurves(QCustomPlot &plot)
        : m_plot(plot)
    {
    }

    /// Replaces all curves. The content is shared, never copied: curves refer to its vectors.
    void make(std::shared_ptr<const PlotContent> content);
    void style(const PlotTheme &theme);
    void setColumnsPerPixel(int columns) { m_columnsPerPixel = columns; }
    /// Hands the present view over; to be called when the layout is known.
    void draw();

    const std::vector<DrawnCurve> &all() const { return m_curves; }
    bool hasData() const;
    /// One entry of the legend may stand for several curves: all of the same name go together.
    void setVisible(std::size_t position, bool visible);
    /// The content; curves with a long record behind them get the points of the present view.
    PlotContent inView(PlotContent content) const;

private:
    void prepareSamples(DrawnCurve &drawn) const;
    void makePlottable(DrawnCurve &drawn);
    void styleCurve(DrawnCurve &drawn) const;
    void styleLine(DrawnCurve &drawn) const;
    void drawCurve(DrawnCurve &drawn, const std::vector<double> &edges) const;
    bool isEntangled(const QCPGraph &graph) const;
    void drawMarkers(DrawnCurve &drawn) const;
    std::vector<double> columnEdges() const;

    QCustomPlot &m_plot;
    std::shared_ptr<const PlotContent> m_content; ///< whose vectors the curves refer to
    PlotTheme m_theme;
    int m_columnsPerPixel = 1;
    std::vector<DrawnCurve> m_curves;
    std::set<QString> m_hidden; ///< names of curves hidden by the operator
};

} // namespace dyncal

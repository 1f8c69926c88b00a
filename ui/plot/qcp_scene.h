// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/curve_samples.h"
#include "ui/plot/plot_content.h"
#include "ui/plot/plot_theme.h"

#include <qcustomplot.h>

#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace dyncal {

class DampingGrid;

QCPScatterStyle scatterStyle(MarkerShape shape, const QColor &color, double size);

/// A graph whose legend icon shows dash and marker together; markers are drawn by another graph.
/// Dashes are drawn as lines of their own: as one dashed path, the many crossings of a ringing
/// cost the rasteriser 25 times as much.
class RoleGraph : public QCPGraph
{
public:
    using QCPGraph::QCPGraph;
    void setLegendMarker(const QCPScatterStyle &marker) { m_legendMarker = marker; }

protected:
    void drawLegendIcon(QCPPainter *painter, const QRectF &rect) const override;
    void drawLinePlot(QCPPainter *painter, const QVector<QPointF> &lines) const override;

private:
    QCPScatterStyle m_legendMarker;
};

/// One curve as QCustomPlot draws it, and the samples it comes from.
struct DrawnCurve
{
    const PlotCurve *curve = nullptr;
    RoleGraph *graph = nullptr; ///< null for bars
    QCPGraph *markers = nullptr; ///< a few role markers along a line, or dots on every sample
    QCPBars *bars = nullptr;
    /// Sorted, positive on logarithmic axes; empty while the content's own vectors serve.
    std::vector<double> ownX, ownY;
    std::shared_ptr<const CurveSamples> samples; ///< the same, or the long record behind them
    bool dense = false; ///< too many points to hand over: drawn by columns
    std::vector<double> drawnEdges; ///< columns that the graph has now
    bool enveloped = false; ///< they hold extremes, not single samples
    bool visible = true;

    QCPAbstractPlottable *plottable() const;
    const std::vector<double> &x() const { return ownX.empty() ? curve->x : ownX; }
    const std::vector<double> &y() const { return ownX.empty() ? curve->y : ownY; }
};

/// What one content looks like on one QCustomPlot: axes, curves, marks, levels, legend, theme.
/// Used by the widget and, without any widget shown, by printing. No mouse, no keyboard.
class PlotScene
{
public:
    explicit PlotScene(QCustomPlot &plot);

    /// Replaces what is drawn; the ranges stay. The content is shared, never copied.
    void setContent(std::shared_ptr<const PlotContent> content);
    /// Takes a content over that has as many marks and levels as the present one and differs
    /// by these and its summary at most; only they are drawn again, by replotDecorations(). False,
    /// with nothing done, where more differs.
    bool moveDecorations(const std::shared_ptr<const PlotContent> &content);
    /// At once, without the rest of the plot.
    void replotDecorations() { m_decorationLayer->replot(); }
    const PlotContent &content() const { return *m_content; }
    const std::shared_ptr<const PlotContent> &sharedContent() const { return m_content; }
    /// With the points of the present view where there is a long record behind a curve.
    PlotContent contentInView() const;
    void setTheme(const PlotTheme &theme);
    const PlotTheme &theme() const { return m_theme; }
    void setColumnsPerPixel(int columns) { m_columnsPerPixel = columns; }

    void fitX();
    void fitY();
    bool hasData() const;
    /// What depends on the size of the viewport: rows of the legend, equal scales. Done by itself
    /// before every replot; printing calls it.
    void prepare();

    /// That of the axes, or that of damping ratio and frequency where the content asks for it.
    void setGridVisible(bool visible);
    bool isGridVisible() const { return m_gridVisible; }

    const std::vector<DrawnCurve> &curves() const { return m_curves; }
    void setLegendVisible(bool visible);
    /// Position in curves() of the legend entry at a pixel, if any.
    std::optional<std::size_t> legendEntryAt(const QPointF &position) const;
    void setCurveVisible(std::size_t position, bool visible);

private:
    struct Decoration
    {
        QCPItemLine *line = nullptr;
        QCPItemText *label = nullptr;
        CurveRole role = CurveRole::Reference;
        std::optional<double> markX;
        double levelY = 0.0; ///< of a level
        QCPItemRect *band = nullptr; ///< of a level that has one
    };

    // qcp_scene.cpp: axes, title, legend, theme, ranges
    void makeAxis(QCPAxis *axis, const PlotAxis &meaning);
    void updateAxisLabel(QCPAxis *axis);
    void updateLayout();
    void fitLabels();
    void arrange();
    void makeLegend();
    void styleLegend();
    void wrapLegend();
    /// Widens one axis so that both have the same scale, for contents that ask for it.
    void equaliseAspect();
    QCPRange dataRange(const QCPAxis *axis) const;
    // qcp_scene_curves.cpp
    void makeCurves();
    void prepareSamples(DrawnCurve &drawn) const;
    void makePlottable(DrawnCurve &drawn);
    void styleCurve(DrawnCurve &drawn) const;
    void styleLine(DrawnCurve &drawn) const;
    void drawView();
    void drawCurve(DrawnCurve &drawn, const std::vector<double> &edges) const;
    bool isEntangled(const QCPGraph &graph) const;
    void drawMarkers(DrawnCurve &drawn) const;
    std::vector<double> columnEdges() const;
    // qcp_scene_decorations.cpp
    void makeDecorations();
    void makeMark(const PlotMark &mark);
    void makeLevel(const PlotLevel &level);
    static void placeMark(Decoration &decoration, const PlotMark &mark);
    static void placeLevel(Decoration &decoration, const PlotLevel &level);
    QCPItemRect *makeBand(const PlotLevel &level);
    void styleDecorations();
    void placeLabels();
    void staggerMarks(std::vector<QRectF> &taken);
    void placeLevelLabel(const Decoration &decoration, std::vector<QRectF> &taken);

    QCustomPlot &m_plot;
    std::shared_ptr<const PlotContent> m_content;
    std::shared_ptr<const PlotContent> m_drawnContent; ///< whose vectors the curves look into
    PlotTheme m_theme;
    int m_columnsPerPixel = 1;
    std::vector<DrawnCurve> m_curves;
    std::set<QString> m_hidden; ///< names of curves hidden by the operator
    bool m_legendVisible = true;
    QCPTextElement *m_title = nullptr;
    QCPLayoutGrid *m_legendRow = nullptr; ///< keeps the legend at the left
    int m_legendWrap = 0;
    std::vector<Decoration> m_decorations;
    QCPLayer *m_decorationLayer = nullptr; ///< with pixels of its own
    QCPItemEllipse *m_unitCircle = nullptr;
    DampingGrid *m_dampingGrid = nullptr;
    bool m_gridVisible = true;
};

} // namespace dyncal

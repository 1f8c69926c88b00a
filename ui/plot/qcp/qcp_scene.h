// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_data_range.h"
#include "ui/plot/qcp/qcp_legend.h"
#include "ui/plot/qcp/qcp_scene_curves.h"
#include "ui/plot/qcp/qcp_scene_decorations.h"
#include "ui/plot/values/plot_text.h"

#include <memory>
#include <optional>
#include <vector>

namespace dyncal {

/// What one content looks like on one QCustomPlot: axes, curves, marks, levels, legend, theme.
/// Used by the widget and, without any widget shown, by printing. No mouse, no keyboard.
class PlotScene
{
public:
    explicit PlotScene(QCustomPlot &plot);

    /// Replaces what is drawn; the ranges stay. The content is shared, never copied.
    void setContent(std::shared_ptr<const PlotContent> content);
    /// Takes over a content that differs from the present one only in the places and words of its
    /// marks and levels, as many as before, and in its summary; only these are drawn again, by
    /// replotDecorations(). False, with nothing done, if more differs.
    bool moveDecorations(const std::shared_ptr<const PlotContent> &content);
    /// Draws marks and levels at once, without the rest of the plot.
    void replotDecorations() { m_decorations.replot(); }
    const PlotContent &content() const { return *m_content; }
    const std::shared_ptr<const PlotContent> &sharedContent() const { return m_content; }
    /// The content; curves with a long record behind them get the points of the present view.
    PlotContent contentInView() const { return m_curves.inView(*m_content); }
    void setTheme(const PlotTheme &theme);
    const PlotTheme &theme() const { return m_theme; }
    void setColumnsPerPixel(int columns) { m_curves.setColumnsPerPixel(columns); }
    /// Titles and labels of axes go on in further lines where they are too long; else labels are
    /// shortened, as on paper.
    void setBreaksText(bool breaks) { m_breaksText = breaks; }

    void fitX();
    void fitY();
    bool hasData() const { return m_curves.hasData(); }
    /// What depends on the size of the viewport: rows of the legend, equal scales. Every replot
    /// begins with it; printing has to call it.
    void prepare();

    /// The grid of the axes, or that of damping ratio and frequency if the content asks for it.
    void setGridVisible(bool visible) { m_decorations.setGridVisible(visible); }
    bool isGridVisible() const { return m_decorations.isGridVisible(); }

    const std::vector<DrawnCurve> &curves() const { return m_curves.all(); }
    void setLegendVisible(bool visible);
    /// Position in curves() of the legend entry at a pixel, if any.
    std::optional<std::size_t> legendEntryAt(const QPointF &position) const
    {
        return m_legend.entryAt(position);
    }
    void setCurveVisible(std::size_t position, bool visible);
    /// Title, legend and the labels of the damping grid, as they were drawn last.
    void addTexts(std::vector<PlotText> &texts) const;

private:
    void makeAxis(QCPAxis *axis, const PlotAxis &meaning);
    void updateAxisLabel(QCPAxis *axis);
    void updateLayout();
    void fitLabels();
    void arrange();
    /// Widens one axis so that both have the same scale, for contents that ask for it.
    void equaliseAspect();
    QCPRange dataRange(DataAxis axis) const;
    void keepDrawable();

    QCustomPlot &m_plot;
    std::shared_ptr<const PlotContent> m_content;
    QCPRange m_homeX, m_homeY; ///< that show all
    PlotTheme m_theme;
    SceneCurves m_curves;
    SceneLegend m_legend;
    SceneDecorations m_decorations;
    QCPTextElement *m_title = nullptr;
    bool m_breaksText = false;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_label.h"
#include "ui/plot/values/plot_content.h"
#include "ui/plot/values/plot_text.h"
#include "ui/plot/values/plot_theme.h"

#include <qcustomplot.h>

#include <optional>
#include <vector>

namespace dyncal {

class DampingGrid;

/// What one content shows beside its curves, on one QCustomPlot: marks, levels, unit circle, and
/// the grid, that of the axes or that of damping ratio and frequency where the content asks for it.
class SceneDecorations
{
public:
    explicit SceneDecorations(QCustomPlot &plot);

    void make(const PlotContent &content);
    /// Puts marks and levels elsewhere; there are as many of them as before.
    void move(const PlotContent &content);
    void style(const PlotTheme &theme);
    /// To be called when the layout is known.
    void placeLabels();
    /// Draws marks and levels at once, without the rest of the plot.
    void replot() { m_layer->replot(); }

    void setGridVisible(bool visible);
    bool isGridVisible() const { return m_gridVisible; }
    void addTexts(std::vector<PlotText> &texts) const; ///< those that are no items

private:
    struct Decoration
    {
        QCPItemLine *line = nullptr;
        PlotLabel *label = nullptr;
        CurveRole role = CurveRole::Reference;
        std::optional<double> markX;
        double levelY = 0.0; ///< of a level
        QCPItemRect *band = nullptr; ///< of a level that has one
    };

    void restyle();
    void makeMark(const PlotMark &mark);
    void makeLevel(const PlotLevel &level);
    static void placeMark(Decoration &decoration, const PlotMark &mark);
    static void placeLevel(Decoration &decoration, const PlotLevel &level);
    QCPItemRect *makeBand(const PlotLevel &level);
    std::vector<QRectF> othersLabels() const;
    void staggerMarks(std::vector<QRectF> &taken);
    void placeLevelLabel(const Decoration &decoration, std::vector<QRectF> &taken);

    QCustomPlot &m_plot;
    QCPLayer *m_layer; ///< has a paint buffer of its own
    PlotTheme m_theme;
    std::vector<Decoration> m_decorations;
    QCPItemEllipse *m_unitCircle = nullptr;
    DampingGrid *m_dampingGrid = nullptr;
    bool m_gridVisible = true;
};

} // namespace dyncal

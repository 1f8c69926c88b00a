// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_scene_curves.h"

#include <optional>

namespace dyncal {

/// The legend of one scene: an entry for each named curve, in as many columns as fit.
class SceneLegend
{
public:
    SceneLegend(QCustomPlot &plot, const SceneCurves &curves);

    QCPLayoutGrid *row() { return m_row; } ///< its place in the layout; keeps it at the left

    void make(); ///< new entries, of the curves as they are now
    void style(const PlotTheme &theme);
    void restyle(); ///< hidden curves are struck out
    void wrap(bool breaksNames); ///< to the width there is

    void setWanted(bool wanted) { m_wanted = wanted; }
    bool isShown() const; ///< wanted, and there is more than one entry
    /// Position among the curves of the entry at a pixel, if any.
    std::optional<std::size_t> entryAt(const QPointF &position) const;

private:
    QCustomPlot &m_plot;
    const SceneCurves &m_curves;
    QCPLayoutGrid *m_row;
    PlotTheme m_theme;
    bool m_wanted = true;
    int m_wrap = 0; ///< columns; 0 = to be found
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_scene.h"

#include <array>

namespace dyncal {

/// A sample of one curve.
struct CurvePoint
{
    std::size_t curve = 0; ///< position in PlotScene::curves()
    double x = 0.0;
    double y = 0.0;
};

/// The sample of a visible curve that is nearest to a pixel, within `reach_px` in both directions;
/// without a reach, at any distance.
std::optional<CurvePoint> nearestPoint(const QCustomPlot &plot, const PlotScene &scene,
    const QPointF &position, std::optional<double> reach_px);

/// Cursors A and B: vertical lines on samples, with a readout in a corner (x, y, dx, 1/dx, dy).
class PlotCursors
{
public:
    explicit PlotCursors(QCustomPlot &plot);

    void place(int which, const CurvePoint &point); ///< 0 = A, 1 = B
    void clear();
    bool any() const { return m_points[0] || m_points[1]; }
    QString readout(const PlotContent &content) const;
    /// Draws lines and readout; call after the content, the theme or a cursor changed.
    void refresh(const PlotScene &scene);

private:
    QCustomPlot &m_plot;
    std::array<std::optional<CurvePoint>, 2> m_points;
    std::array<QCPItemLine *, 2> m_lines{};
    std::array<QCPItemText *, 2> m_names{};
    QCPItemText *m_readout = nullptr;
};

} // namespace dyncal

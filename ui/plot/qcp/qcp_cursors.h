// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_label.h"
#include "ui/plot/qcp/qcp_scene.h"
#include "ui/plot/values/cursor_values.h"

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
    const std::optional<CurvePoint> &at(int which) const
    {
        return m_points[static_cast<std::size_t>(which)];
    }
    /// The cursor whose line is within `reach_px` of a pixel of the axes, if any.
    std::optional<int> cursorAt(const QPointF &position, double reach_px) const;
    /// The one placed last, if it still stands.
    std::optional<int> last() const { return at(m_last) ? std::optional(m_last) : std::nullopt; }
    /// Where that cursor comes to, `steps` samples further on its curve; as it is at the ends.
    CurvePoint stepped(const PlotScene &scene, int which, Index steps) const;
    /// The sample nearest to `x` of the first curve on show that has one there; else no y.
    static CurvePoint sampleAt(const PlotScene &scene, double x);
    CursorValues values(const PlotScene &scene) const;
    QString readout(const PlotContent &content) const;
    /// Draws lines and readout; call after the content, the theme or a cursor changed.
    void refresh(const PlotScene &scene);

private:
    void readAgain(const PlotScene &scene);

    QCustomPlot &m_plot;
    std::array<std::optional<CurvePoint>, 2> m_points;
    int m_last = 0;
    std::array<QCPItemLine *, 2> m_lines{};
    std::array<PlotLabel *, 2> m_names{};
    QCPItemText *m_readout = nullptr;
};

} // namespace dyncal

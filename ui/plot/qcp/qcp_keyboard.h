// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_mouse.h"

class QKeyEvent;

namespace dyncal {

/// The keys of one plot: fit, grid, cursors, view, and the focused handle moved step by step.
class PlotKeyboard
{
public:
    PlotKeyboard(PlotCanvas &canvas, PlotMouse &mouse)
        : m_canvas(canvas)
        , m_mouse(mouse)
    {
    }

    /// False: the key means nothing here.
    bool press(const QKeyEvent &event);
    /// Whether the key comes before shortcuts of the window while the plot has the focus.
    bool takesPrecedence(const QKeyEvent &event) const;
    /// False: there is no further handle.
    bool focusNextGrip(bool next);

private:
    bool escape();
    void placeCursor(int which);
    bool stepCursor(Index steps);
    void nudge(double steps);

    PlotCanvas &m_canvas;
    PlotMouse &m_mouse;
};

} // namespace dyncal

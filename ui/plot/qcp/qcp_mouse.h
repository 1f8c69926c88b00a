// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/qcp/qcp_canvas.h"

#include <QRubberBand>

#include <variant>

class QMouseEvent;
class QWheelEvent;

namespace dyncal {

/// What the mouse is doing between press and release.
struct DragPan
{
    QPointF from;
    QCPRange x, y;
    bool moved = false;
};
struct DragBox
{
    QPointF from;
    bool moved = false;
};
struct DragHandle
{
    HandleGrip grip;
    HandleState before;
    double grabbedAt = 0.0; ///< pointer minus handle, so that it does not jump
};
struct DragCursor
{
    int which = 0;
    CurvePoint before;
};
struct DragSpan
{
    QPointF from;
};
using Drag = std::variant<std::monostate, DragPan, DragBox, DragHandle, DragCursor, DragSpan>;

/// The mouse on one plot: pan, box, handles, spans, picks, hints, wheel.
class PlotMouse
{
public:
    explicit PlotMouse(PlotCanvas &canvas);

    void press(const QMouseEvent &event);
    void move(const QMouseEvent &event);
    void release(const QMouseEvent &event);
    void wheel(const QWheelEvent &event);
    /// Restores what the drag under way has moved; false without one.
    bool cancelDrag();
    bool isDragging() const { return !std::holds_alternative<std::monostate>(m_drag); }
    bool isDraggingHandle() const { return std::holds_alternative<DragHandle>(m_drag); }

    void setMarkable(bool markable) { m_markable = markable; }
    void setMarking(bool on);
    bool isMarking() const { return m_marking; }
    QPointF pointer() const { return m_pointer; } ///< where it was last seen

private:
    QPointF inPlot(const QPointF &position) const;
    void hover(const QPointF &position);
    std::optional<int> cursorAt(const QPointF &position) const;
    void dragHandleTo(DragHandle &drag, const QPointF &position);
    void dragCursorTo(const DragCursor &drag, const QPointF &position);
    void panTo(DragPan &drag, const QPointF &position);
    void showSpan(const DragSpan &span);
    void markSpan(const DragSpan &span);
    void zoomBox(const QRectF &box);
    void click(const QPointF &position, Qt::KeyboardModifiers modifiers);
    void toggleCurve(std::size_t position, bool alone);

    PlotCanvas &m_canvas;
    QCustomPlot *m_plot;
    QRubberBand *m_rubberBand;
    Drag m_drag;
    bool m_markable = false; ///< Shift and drag mark a span
    bool m_marking = false; ///< the next drag marks a span
    QPointF m_pointer;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/plot_export.h"
#include "ui/plot/plot_widget.h"
#include "ui/plot/qcp_cursors.h"
#include "ui/plot/qcp_handles.h"
#include "ui/plot/qcp_scene.h"

#include <QRubberBand>

#include <variant>

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
struct DragSpan
{
    QPointF from;
};
using Drag = std::variant<std::monostate, DragPan, DragBox, DragHandle, DragSpan>;

struct View
{
    QCPRange x, y;
};

/// A range moved by a fraction of itself, along the axis' own scale.
QCPRange shiftedRange(const QCPAxis &axis, const QCPRange &range, double fraction);

/// State and behaviour behind PlotWidget. Positions are pixels of the inner QCustomPlot.
struct PlotWidget::Private
{
    explicit Private(PlotWidget *widget);

    // plot_widget.cpp
    void replot();
    void replotDecorations();
    void applyTheme();
    void fitView();
    void fitContent(const PlotContent &before);
    View view() const { return {plot->xAxis->range(), plot->yAxis->range()}; }
    void setView(const View &view);
    PlotPicture picture() const;
    void announce(const HandleState &state, bool finished);

    // plot_mouse.cpp
    QPointF inPlot(const QPointF &widgetPosition) const;
    void press(const QMouseEvent &event);
    void move(const QMouseEvent &event);
    void release(const QMouseEvent &event);
    void hover(const QPointF &position);
    void dragHandleTo(DragHandle &drag, const QPointF &position);
    void panTo(DragPan &drag, const QPointF &position);
    void showSpan(const DragSpan &span);
    void markSpan(const DragSpan &span);
    void zoomBox(const QRectF &box);
    void click(const QPointF &position, Qt::KeyboardModifiers modifiers);
    void toggleCurve(std::size_t position, bool alone);
    void wheel(const QWheelEvent &event);
    bool cancelDrag();

    // plot_keyboard.cpp
    bool key(const QKeyEvent &event);
    void placeCursor(int which);
    void nudge(double steps);
    void pan(double xFraction, double yFraction);
    void zoomBy(double factor);
    void remember();
    void goBack(bool forward);
    bool focusNextGrip(bool next);
    void focusGrip(const std::optional<HandleGrip> &grip);

    PlotWidget *q;
    QCustomPlot *plot; ///< child of q, shows only; all events are handled by q
    PlotScene scene;
    PlotHandles handles;
    PlotCursors cursors;
    QRubberBand *rubberBand;
    bool isReplotQueued = false;
    bool hasView = false; ///< a content with data has been fitted
    View fitted; ///< the view as it was last fitted to a content
    Drag drag;
    bool markable = false; ///< Shift and drag mark a span
    bool marking = false; ///< so does the next drag
    QPointF pointer; ///< where it was last seen
    std::optional<HandleGrip> focused;
    std::vector<View> back, forward;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot_widget_private.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kPanStep = 0.1; ///< of the range per arrow
constexpr double kKeyZoom = 0.7;
constexpr std::size_t kMostViews = 50;

} // namespace

QCPRange shiftedRange(const QCPAxis &axis, const QCPRange &range, double fraction)
{
    if (axis.scaleType() == QCPAxis::stLogarithmic) {
        const double factor = std::pow(range.upper / range.lower, fraction);
        return {range.lower * factor, range.upper * factor};
    }
    return {range.lower + fraction * range.size(), range.upper + fraction * range.size()};
}

void PlotWidget::Private::remember()
{
    back.push_back(view());
    if (back.size() > kMostViews)
        back.erase(back.begin());
    forward.clear();
}

void PlotWidget::Private::goBack(bool toForward)
{
    std::vector<View> &from = toForward ? forward : back;
    std::vector<View> &to = toForward ? back : forward;
    if (from.empty())
        return;
    to.push_back(view());
    const View target = from.back();
    from.pop_back();
    setView(target);
}

void PlotWidget::Private::pan(double xFraction, double yFraction)
{
    plot->xAxis->setRange(shiftedRange(*plot->xAxis, plot->xAxis->range(), xFraction));
    plot->yAxis->setRange(shiftedRange(*plot->yAxis, plot->yAxis->range(), yFraction));
    replot();
}

void PlotWidget::Private::zoomBy(double factor)
{
    remember();
    plot->xAxis->scaleRange(factor);
    if (scene.content().equalAspect)
        plot->yAxis->scaleRange(factor);
    replot();
}

void PlotWidget::Private::placeCursor(int which)
{
    const QRect rect = plot->axisRect()->rect();
    const QPointF at = rect.contains(pointer.toPoint()) ? pointer : QPointF(rect.center());
    if (const auto point = nearestPoint(*plot, scene, at, std::nullopt)) {
        cursors.place(which, *point);
        cursors.refresh(scene);
        replot();
        emit q->cursorPlaced(which, point->x);
    }
}

void PlotWidget::Private::nudge(double steps)
{
    const HandleState *state = focused ? handles.find(focused->id) : nullptr;
    if (!state)
        return;
    const double at = handles.positionOf(*focused);
    double step = 1.0;
    if (!state->snapToIntegers) // one pixel at this zoom
        step = plot->xAxis->pixelToCoord(plot->xAxis->coordToPixel(at) + 1.0) - at;
    const HandleState after = handles.moved(*state, *focused, at + steps * step);
    handles.set(after);
    replot();
    announce(after, true);
}

void PlotWidget::Private::focusGrip(const std::optional<HandleGrip> &grip)
{
    focused = grip;
    handles.setFocus(grip);
    replot();
}

bool PlotWidget::Private::focusNextGrip(bool next)
{
    const std::vector<HandleGrip> grips = handles.grips();
    if (grips.empty())
        return false;
    const auto count = static_cast<Index>(grips.size());
    Index at = next ? -1 : count;
    if (focused)
        at = std::find(grips.begin(), grips.end(), *focused) - grips.begin();
    at += next ? 1 : -1;
    const bool inside = at >= 0 && at < count;
    focusGrip(inside ? std::optional(grips[static_cast<std::size_t>(at)]) : std::nullopt);
    return inside;
}

bool PlotWidget::Private::key(const QKeyEvent &event)
{
    const double many = event.modifiers().testFlag(Qt::ShiftModifier) ? 10.0 : 1.0;
    const bool onHandle = focused && handles.find(focused->id);
    switch (event.key()) {
    case Qt::Key_F:
        q->fit();
        return true;
    case Qt::Key_G:
        scene.setGridVisible(!scene.isGridVisible());
        replot();
        return true;
    case Qt::Key_1:
    case Qt::Key_2:
        placeCursor(event.key() == Qt::Key_1 ? 0 : 1);
        return true;
    case Qt::Key_Left:
    case Qt::Key_Right: {
        const double sign = event.key() == Qt::Key_Left ? -1.0 : 1.0;
        onHandle ? nudge(sign * many) : pan(sign * kPanStep, 0.0);
        return true;
    }
    case Qt::Key_Up:
    case Qt::Key_Down:
        pan(0.0, event.key() == Qt::Key_Up ? kPanStep : -kPanStep);
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Minus:
        zoomBy(event.key() == Qt::Key_Plus ? kKeyZoom : 1.0 / kKeyZoom);
        return true;
    case Qt::Key_Backspace:
        goBack(event.modifiers().testFlag(Qt::ShiftModifier));
        return true;
    case Qt::Key_Escape:
        if (marking) {
            cancelDrag();
            q->setMarking(false);
            return true;
        }
        if (cancelDrag())
            return true;
        if (!cursors.any())
            return false;
        cursors.clear();
        cursors.refresh(scene);
        emit q->cursorsCleared();
        replot();
        return true;
    default:
        return false;
    }
}

void PlotWidget::keyPressEvent(QKeyEvent *event)
{
    if (!d->key(*event))
        QWidget::keyPressEvent(event);
}

bool PlotWidget::event(QEvent *event)
{
    // The keys of the plot come before shortcuts of the window while the plot has the focus.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool dragging = !std::holds_alternative<std::monostate>(d->drag);
        if (key->key() == Qt::Key_Escape && (dragging || d->marking || d->cursors.any())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

bool PlotWidget::focusNextPrevChild(bool next)
{
    return (hasFocus() && d->focusNextGrip(next)) || QWidget::focusNextPrevChild(next);
}

void PlotWidget::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    update();
}

void PlotWidget::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    d->focusGrip(std::nullopt);
    update();
}

} // namespace dyncal

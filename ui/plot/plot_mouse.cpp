// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/plot_widget_private.h"

#include "ui/plot/axis_prefix.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kWheelZoom = 0.85; ///< range kept per wheel notch
constexpr double kPanStep = 0.1; ///< of the range per wheel notch
constexpr double kDragStart_px = 4.0;
constexpr double kHoverReach_px = 12.0;
constexpr double kPickReach_px = 20.0;

double length(const QPointF &vector)
{
    return std::hypot(vector.x(), vector.y());
}

} // namespace

QPointF PlotWidget::Private::inPlot(const QPointF &widgetPosition) const
{
    return widgetPosition - QPointF(plot->pos());
}

void PlotWidget::Private::press(const QMouseEvent &event)
{
    pointer = inPlot(event.position());
    if (!std::holds_alternative<std::monostate>(drag))
        return; // a second button during a drag changes nothing
    if (event.button() == Qt::RightButton) {
        drag = DragBox{pointer};
    } else if (event.button() == Qt::LeftButton) {
        const bool marks = marking || (markable && event.modifiers() == Qt::ShiftModifier);
        if (marks && plot->axisRect()->rect().contains(pointer.toPoint())) {
            drag = DragSpan{pointer};
        } else if (const auto grip = handles.gripAt(pointer)) {
            const HandleState before = *handles.find(grip->id);
            const double grabbedAt
                = plot->xAxis->pixelToCoord(pointer.x()) - handles.positionOf(*grip);
            drag = DragHandle{*grip, before, before.snapToIntegers ? 0.0 : grabbedAt};
            focusGrip(grip);
        } else {
            drag = DragPan{pointer, plot->xAxis->range(), plot->yAxis->range()};
        }
    }
}

void PlotWidget::Private::move(const QMouseEvent &event)
{
    pointer = inPlot(event.position());
    if (auto *pan = std::get_if<DragPan>(&drag)) {
        panTo(*pan, pointer);
    } else if (auto *box = std::get_if<DragBox>(&drag)) {
        box->moved = box->moved || length(pointer - box->from) >= kDragStart_px;
        const QRectF rect = QRectF(box->from, pointer).normalized().translated(plot->pos());
        rubberBand->setGeometry(rect.toRect());
        rubberBand->setVisible(box->moved);
    } else if (auto *handle = std::get_if<DragHandle>(&drag)) {
        dragHandleTo(*handle, pointer);
    } else if (auto *span = std::get_if<DragSpan>(&drag)) {
        showSpan(*span);
    } else {
        hover(pointer);
    }
}

void PlotWidget::Private::panTo(DragPan &pan, const QPointF &position)
{
    if (!pan.moved && length(position - pan.from) < kDragStart_px)
        return;
    if (!pan.moved)
        remember();
    pan.moved = true;
    q->setCursor(Qt::ClosedHandCursor);
    const QRect rect = plot->axisRect()->rect();
    const QPointF way = position - pan.from;
    plot->xAxis->setRange(shiftedRange(*plot->xAxis, pan.x, -way.x() / std::max(1, rect.width())));
    plot->yAxis->setRange(shiftedRange(*plot->yAxis, pan.y, way.y() / std::max(1, rect.height())));
    replot();
}

void PlotWidget::Private::dragHandleTo(DragHandle &handle, const QPointF &position)
{
    const HandleState *now = handles.find(handle.grip.id);
    if (!now) { // the page took the handle away meanwhile
        drag = {};
        return;
    }
    const double x = plot->xAxis->pixelToCoord(position.x()) - handle.grabbedAt;
    HandleState after = handles.moved(handle.before, handle.grip, x);
    after.label = now->label;
    if (after.x == now->x)
        return;
    handles.set(after);
    replot();
    announce(after, false);
}

void PlotWidget::Private::release(const QMouseEvent &event)
{
    pointer = inPlot(event.position());
    const Drag done = std::exchange(drag, Drag{});
    if (const auto *pan = std::get_if<DragPan>(&done)) {
        if (!pan->moved)
            click(pointer, event.modifiers());
    } else if (const auto *box = std::get_if<DragBox>(&done)) {
        rubberBand->hide();
        if (box->moved)
            zoomBox(QRectF(box->from, pointer).normalized());
        else
            q->showMenu(event.globalPosition().toPoint());
    } else if (const auto *handle = std::get_if<DragHandle>(&done)) {
        if (const HandleState *state = handles.find(handle->grip.id))
            announce(*state, true);
    } else if (const auto *span = std::get_if<DragSpan>(&done)) {
        markSpan(*span);
    }
    hover(pointer);
}

/// The span under way, over the full height: it is one of x only.
void PlotWidget::Private::showSpan(const DragSpan &span)
{
    const QRectF rect = plot->axisRect()->rect();
    const QRectF shown(QPointF(span.from.x(), rect.top()), QPointF(pointer.x(), rect.bottom()));
    rubberBand->setGeometry(shown.normalized().intersected(rect).translated(plot->pos()).toRect());
    rubberBand->show();
}

/// A click marks nothing, and leaves the mode as it is.
void PlotWidget::Private::markSpan(const DragSpan &span)
{
    rubberBand->hide();
    const QRectF rect = plot->axisRect()->rect();
    const double a = span.from.x();
    const double b = std::clamp(pointer.x(), rect.left(), rect.right());
    if (std::abs(b - a) < kDragStart_px)
        return;
    q->setMarking(false);
    emit q->spanMarked(
        {plot->xAxis->pixelToCoord(std::min(a, b)), plot->xAxis->pixelToCoord(std::max(a, b))});
}

void PlotWidget::Private::zoomBox(const QRectF &box)
{
    const QRectF inside = box.intersected(plot->axisRect()->rect());
    if (inside.width() < kDragStart_px || inside.height() < kDragStart_px)
        return;
    remember();
    setView({QCPRange(plot->xAxis->pixelToCoord(inside.left()),
                 plot->xAxis->pixelToCoord(inside.right())),
        QCPRange(
            plot->yAxis->pixelToCoord(inside.bottom()), plot->yAxis->pixelToCoord(inside.top()))});
}

void PlotWidget::Private::click(const QPointF &position, Qt::KeyboardModifiers modifiers)
{
    if (const auto entry = scene.legendEntryAt(position)) {
        toggleCurve(*entry, modifiers.testFlag(Qt::ControlModifier));
        return;
    }
    if (!plot->axisRect()->rect().contains(position.toPoint()))
        return;
    if (const auto point = nearestPoint(*plot, scene, position, kPickReach_px))
        emit q->pointPicked(point->x, point->y);
}

void PlotWidget::Private::toggleCurve(std::size_t position, bool alone)
{
    if (alone) {
        const QString name = scene.curves()[position].curve->name;
        for (std::size_t i = 0; i < scene.curves().size(); ++i)
            scene.setCurveVisible(i, scene.curves()[i].curve->name == name);
    } else {
        scene.setCurveVisible(position, !scene.curves()[position].visible);
    }
    replot();
}

void PlotWidget::Private::hover(const QPointF &position)
{
    const auto grip = marking ? std::nullopt : handles.gripAt(position);
    q->setCursor(marking                    ? Qt::CrossCursor
            : grip                          ? Qt::SplitHCursor
            : scene.legendEntryAt(position) ? Qt::PointingHandCursor
                                            : Qt::ArrowCursor);
    if (grip || !plot->axisRect()->rect().contains(position.toPoint()))
        return;
    const auto point = nearestPoint(*plot, scene, position, kHoverReach_px);
    if (!point) {
        QToolTip::hideText();
        return;
    }
    const PlotContent &content = scene.content();
    QStringList lines;
    if (const QString name = scene.curves()[point->curve].curve->name; !name.isEmpty())
        lines += name;
    lines += valueWithUnit(point->x, content.xAxis.unit, 6) + QStringLiteral("; ")
        + valueWithUnit(point->y, content.yAxis.unit, 6);
    const QPoint shown = position.toPoint() + plot->pos();
    QToolTip::showText(q->mapToGlobal(shown), lines.join(QLatin1Char('\n')), q);
}

void PlotWidget::Private::wheel(const QWheelEvent &event)
{
    const QPoint delta = event.angleDelta();
    const double notches = (delta.y() != 0 ? delta.y() : delta.x()) / 120.0;
    if (notches == 0.0)
        return;
    const QPointF at = inPlot(event.position());
    if (event.modifiers().testFlag(Qt::ShiftModifier)) {
        pan(-kPanStep * notches, 0.0);
        return;
    }
    const QRect rect = plot->axisRect()->rect();
    const double factor = std::pow(kWheelZoom, notches);
    const bool both = scene.content().equalAspect;
    const bool onY = at.x() < rect.left() || event.modifiers().testFlag(Qt::ControlModifier);
    remember();
    if (!onY || both)
        plot->xAxis->scaleRange(factor, plot->xAxis->pixelToCoord(at.x()));
    if (onY || both)
        plot->yAxis->scaleRange(factor, plot->yAxis->pixelToCoord(at.y()));
    replot();
}

bool PlotWidget::Private::cancelDrag()
{
    const Drag cancelled = std::exchange(drag, Drag{});
    rubberBand->hide();
    if (const auto *handle = std::get_if<DragHandle>(&cancelled)) {
        handles.set(handle->before);
        announce(handle->before, true);
    } else if (const auto *pan = std::get_if<DragPan>(&cancelled)) {
        setView({pan->x, pan->y});
    }
    replot();
    return !std::holds_alternative<std::monostate>(cancelled);
}

void PlotWidget::mousePressEvent(QMouseEvent *event)
{
    d->press(*event);
}

void PlotWidget::mouseMoveEvent(QMouseEvent *event)
{
    d->move(*event);
}

void PlotWidget::mouseReleaseEvent(QMouseEvent *event)
{
    d->release(*event);
}

void PlotWidget::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        fit();
}

void PlotWidget::wheelEvent(QWheelEvent *event)
{
    d->wheel(*event);
    event->accept();
}

void PlotWidget::contextMenuEvent(QContextMenuEvent *event)
{
    // The right button opens the menu on release: a drag with it zooms.
    if (event->reason() == QContextMenuEvent::Keyboard)
        showMenu(mapToGlobal(rect().center()));
    event->accept();
}

} // namespace dyncal

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
constexpr double kPanStep = 0.1; ///< of the range per wheel notch or arrow
constexpr double kKeyZoom = 0.7;
constexpr double kDragStart_px = 4.0;
constexpr double kHoverReach_px = 12.0;
constexpr double kPickReach_px = 20.0;
constexpr std::size_t kMostViews = 50;

QCPRange shifted(const QCPAxis &axis, const QCPRange &range, double fraction)
{
    if (axis.scaleType() == QCPAxis::stLogarithmic) {
        const double factor = std::pow(range.upper / range.lower, fraction);
        return {range.lower * factor, range.upper * factor};
    }
    return {range.lower + fraction * range.size(), range.upper + fraction * range.size()};
}

double length(const QPointF &vector)
{
    return std::hypot(vector.x(), vector.y());
}

} // namespace

QPointF PlotWidget::Private::inPlot(const QPointF &widgetPosition) const
{
    return widgetPosition - QPointF(plot->pos());
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

void PlotWidget::Private::press(const QMouseEvent &event)
{
    pointer = inPlot(event.position());
    if (!std::holds_alternative<std::monostate>(drag))
        return; // a second button during a drag changes nothing
    if (event.button() == Qt::RightButton) {
        drag = DragBox{pointer};
    } else if (event.button() == Qt::LeftButton) {
        if (const auto grip = handles.gripAt(pointer)) {
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
    plot->xAxis->setRange(shifted(*plot->xAxis, pan.x, -way.x() / std::max(1, rect.width())));
    plot->yAxis->setRange(shifted(*plot->yAxis, pan.y, way.y() / std::max(1, rect.height())));
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
    }
    hover(pointer);
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
        for (std::size_t i = 0; i < scene.curves().size(); ++i)
            scene.setCurveVisible(i, i == position);
    } else {
        scene.setCurveVisible(position, !scene.curves()[position].visible);
    }
    replot();
}

void PlotWidget::Private::hover(const QPointF &position)
{
    const auto grip = handles.gripAt(position);
    q->setCursor(grip                       ? Qt::SplitHCursor
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

void PlotWidget::Private::pan(double xFraction, double yFraction)
{
    plot->xAxis->setRange(shifted(*plot->xAxis, plot->xAxis->range(), xFraction));
    plot->yAxis->setRange(shifted(*plot->yAxis, plot->yAxis->range(), yFraction));
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

void PlotWidget::Private::placeCursor(int which)
{
    const QRect rect = plot->axisRect()->rect();
    const QPointF at = rect.contains(pointer.toPoint()) ? pointer : QPointF(rect.center());
    if (const auto point = nearestPoint(*plot, scene, at, std::nullopt)) {
        cursors.place(which, *point);
        cursors.refresh(scene);
        replot();
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
    case Qt::Key_G: {
        const bool visible = !plot->xAxis->grid()->visible();
        plot->xAxis->grid()->setVisible(visible);
        plot->yAxis->grid()->setVisible(visible);
        replot();
        return true;
    }
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
        if (cancelDrag())
            return true;
        if (!cursors.any())
            return false;
        cursors.clear();
        cursors.refresh(scene);
        replot();
        return true;
    default:
        return false;
    }
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

void PlotWidget::keyPressEvent(QKeyEvent *event)
{
    if (!d->key(*event))
        QWidget::keyPressEvent(event);
}

void PlotWidget::contextMenuEvent(QContextMenuEvent *event)
{
    // The right button opens the menu on release: a drag with it zooms.
    if (event->reason() == QContextMenuEvent::Keyboard)
        showMenu(mapToGlobal(rect().center()));
    event->accept();
}

bool PlotWidget::event(QEvent *event)
{
    // The keys of the plot come before shortcuts of the window while the plot has the focus.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool dragging = !std::holds_alternative<std::monostate>(d->drag);
        if (key->key() == Qt::Key_Escape && (dragging || d->cursors.any())) {
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

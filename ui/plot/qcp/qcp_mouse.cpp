// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_mouse.h"

#include "ui/plot/values/axis_prefix.h"

#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {

namespace {

constexpr double kWheelZoom = 0.85; ///< range kept per wheel notch
constexpr double kWheelPanStep = 0.1; ///< of the range per wheel notch
constexpr double kDragStart_px = 4.0;
constexpr double kCursorReach_px = 4.0;
constexpr double kHoverReach_px = 12.0;
constexpr double kPickReach_px = 20.0;

double length(const QPointF &vector)
{
    return std::hypot(vector.x(), vector.y());
}

} // namespace

PlotMouse::PlotMouse(PlotCanvas &canvas)
    : m_canvas(canvas)
    , m_plot(&canvas.plot())
    , m_rubberBand(new QRubberBand(QRubberBand::Rectangle, &canvas.owner()))
{
    m_rubberBand->hide();
}

void PlotMouse::setMarking(bool on)
{
    if (m_marking == on)
        return;
    m_marking = on;
    m_canvas.owner().setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
    emit m_canvas.markingChanged(on);
}

QPointF PlotMouse::inPlot(const QPointF &widgetPosition) const
{
    return widgetPosition - QPointF(m_plot->pos());
}

void PlotMouse::press(const QMouseEvent &event)
{
    m_pointer = inPlot(event.position());
    if (!std::holds_alternative<std::monostate>(m_drag))
        return; // a second button during a drag changes nothing
    if (event.button() == Qt::RightButton) {
        m_drag = DragBox{m_pointer};
    } else if (event.button() == Qt::LeftButton) {
        const bool marks = m_marking || (m_markable && event.modifiers() == Qt::ShiftModifier);
        if (marks && m_plot->axisRect()->rect().contains(m_pointer.toPoint())) {
            m_drag = DragSpan{m_pointer};
        } else if (const auto grip = m_canvas.handles().gripAt(m_pointer)) {
            const HandleState before = *m_canvas.handles().find(grip->id);
            const double grabbedAt
                = m_plot->xAxis->pixelToCoord(m_pointer.x()) - m_canvas.handles().positionOf(*grip);
            m_drag = DragHandle{*grip, before, before.snapToIntegers ? 0.0 : grabbedAt};
            m_canvas.focusGrip(grip);
        } else if (const auto which = cursorAt(m_pointer)) {
            m_drag = DragCursor{*which, *m_canvas.cursors().at(*which)};
        } else {
            m_drag = DragPan{m_pointer, m_plot->xAxis->range(), m_plot->yAxis->range()};
        }
    }
}

void PlotMouse::move(const QMouseEvent &event)
{
    m_pointer = inPlot(event.position());
    if (auto *pan = std::get_if<DragPan>(&m_drag)) {
        panTo(*pan, m_pointer);
    } else if (auto *box = std::get_if<DragBox>(&m_drag)) {
        box->moved = box->moved || length(m_pointer - box->from) >= kDragStart_px;
        const QRectF rect = QRectF(box->from, m_pointer).normalized().translated(m_plot->pos());
        m_rubberBand->setGeometry(rect.toRect());
        m_rubberBand->setVisible(box->moved);
    } else if (auto *handle = std::get_if<DragHandle>(&m_drag)) {
        dragHandleTo(*handle, m_pointer);
    } else if (const auto *cursor = std::get_if<DragCursor>(&m_drag)) {
        dragCursorTo(*cursor, m_pointer);
    } else if (auto *span = std::get_if<DragSpan>(&m_drag)) {
        showSpan(*span);
    } else {
        hover(m_pointer);
    }
}

void PlotMouse::panTo(DragPan &pan, const QPointF &position)
{
    if (!pan.moved && length(position - pan.from) < kDragStart_px)
        return;
    if (!pan.moved)
        m_canvas.remember();
    pan.moved = true;
    m_canvas.owner().setCursor(Qt::ClosedHandCursor);
    const QRect rect = m_plot->axisRect()->rect();
    const QPointF way = position - pan.from;
    m_plot->xAxis->setRange(
        shiftedRange(*m_plot->xAxis, pan.x, -way.x() / std::max(1, rect.width())));
    m_plot->yAxis->setRange(
        shiftedRange(*m_plot->yAxis, pan.y, way.y() / std::max(1, rect.height())));
    m_canvas.replot();
}

void PlotMouse::dragHandleTo(DragHandle &handle, const QPointF &position)
{
    const HandleState *now = m_canvas.handles().find(handle.grip.id);
    if (!now) { // the page took the handle away meanwhile
        m_drag = {};
        return;
    }
    const double x = m_plot->xAxis->pixelToCoord(position.x()) - handle.grabbedAt;
    HandleState after = m_canvas.handles().moved(handle.before, handle.grip, x);
    after.label = now->label;
    if (after.x == now->x)
        return;
    m_canvas.handles().set(after);
    m_canvas.replot();
    emit m_canvas.handleMoved(after, false);
}

/// To the sample nearest to the pointer, wherever in the axes it is.
void PlotMouse::dragCursorTo(const DragCursor &drag, const QPointF &position)
{
    const QRectF rect = m_plot->axisRect()->rect();
    const QPointF inside(std::clamp(position.x(), rect.left(), rect.right()),
        std::clamp(position.y(), rect.top(), rect.bottom()));
    if (const auto point = nearestPoint(*m_plot, m_canvas.scene(), inside, std::nullopt))
        m_canvas.moveCursor(drag.which, *point);
}

std::optional<int> PlotMouse::cursorAt(const QPointF &position) const
{
    return m_canvas.cursors().cursorAt(position, kCursorReach_px);
}

void PlotMouse::release(const QMouseEvent &event)
{
    m_pointer = inPlot(event.position());
    const Drag done = std::exchange(m_drag, Drag{});
    if (const auto *pan = std::get_if<DragPan>(&done)) {
        if (!pan->moved)
            click(m_pointer, event.modifiers());
    } else if (const auto *box = std::get_if<DragBox>(&done)) {
        m_rubberBand->hide();
        if (box->moved)
            zoomBox(QRectF(box->from, m_pointer).normalized());
        else
            emit m_canvas.menuRequested(event.globalPosition().toPoint());
    } else if (const auto *handle = std::get_if<DragHandle>(&done)) {
        if (const HandleState *state = m_canvas.handles().find(handle->grip.id))
            emit m_canvas.handleMoved(*state, true);
    } else if (const auto *span = std::get_if<DragSpan>(&done)) {
        markSpan(*span);
    }
    hover(m_pointer);
}

/// Shows the span being dragged over the full height, because it is one of x only.
void PlotMouse::showSpan(const DragSpan &span)
{
    const QRectF rect = m_plot->axisRect()->rect();
    const QRectF shown(QPointF(span.from.x(), rect.top()), QPointF(m_pointer.x(), rect.bottom()));
    m_rubberBand->setGeometry(
        shown.normalized().intersected(rect).translated(m_plot->pos()).toRect());
    m_rubberBand->show();
}

/// A click marks nothing, and leaves the mode as it is.
void PlotMouse::markSpan(const DragSpan &span)
{
    m_rubberBand->hide();
    const QRectF rect = m_plot->axisRect()->rect();
    const double a = span.from.x();
    const double b = std::clamp(m_pointer.x(), rect.left(), rect.right());
    if (std::abs(b - a) < kDragStart_px)
        return;
    setMarking(false);
    emit m_canvas.spanMarked(
        {m_plot->xAxis->pixelToCoord(std::min(a, b)), m_plot->xAxis->pixelToCoord(std::max(a, b))});
}

void PlotMouse::zoomBox(const QRectF &box)
{
    const QRectF inside = box.intersected(m_plot->axisRect()->rect());
    if (inside.width() < kDragStart_px || inside.height() < kDragStart_px)
        return;
    m_canvas.remember();
    m_canvas.setView({QCPRange(m_plot->xAxis->pixelToCoord(inside.left()),
                          m_plot->xAxis->pixelToCoord(inside.right())),
        QCPRange(m_plot->yAxis->pixelToCoord(inside.bottom()),
            m_plot->yAxis->pixelToCoord(inside.top()))});
}

void PlotMouse::click(const QPointF &position, Qt::KeyboardModifiers modifiers)
{
    if (const auto entry = m_canvas.scene().legendEntryAt(position)) {
        toggleCurve(*entry, modifiers.testFlag(Qt::ControlModifier));
        return;
    }
    if (!m_plot->axisRect()->rect().contains(position.toPoint()))
        return;
    if (const auto point = nearestPoint(*m_plot, m_canvas.scene(), position, kPickReach_px))
        emit m_canvas.pointPicked(point->x, point->y);
}

void PlotMouse::toggleCurve(std::size_t position, bool alone)
{
    if (alone) {
        const QString name = m_canvas.scene().curves()[position].curve->name;
        for (std::size_t i = 0; i < m_canvas.scene().curves().size(); ++i)
            m_canvas.scene().setCurveVisible(i, m_canvas.scene().curves()[i].curve->name == name);
    } else {
        m_canvas.scene().setCurveVisible(position, !m_canvas.scene().curves()[position].visible);
    }
    m_canvas.replot();
}

void PlotMouse::hover(const QPointF &position)
{
    const auto grip = m_marking ? std::nullopt : m_canvas.handles().gripAt(position);
    m_canvas.owner().setCursor(m_marking               ? Qt::CrossCursor
            : grip || cursorAt(position)               ? Qt::SplitHCursor
            : m_canvas.scene().legendEntryAt(position) ? Qt::PointingHandCursor
                                                       : Qt::ArrowCursor);
    if (grip || !m_plot->axisRect()->rect().contains(position.toPoint()))
        return;
    const auto point = nearestPoint(*m_plot, m_canvas.scene(), position, kHoverReach_px);
    if (!point) {
        QToolTip::hideText();
        return;
    }
    const PlotContent &content = m_canvas.scene().content();
    QStringList lines;
    if (const QString name = m_canvas.scene().curves()[point->curve].curve->name; !name.isEmpty())
        lines += name;
    lines += valueWithUnit(point->x, content.xAxis.unit, 6) + QStringLiteral("; ")
        + valueWithUnit(point->y, content.yAxis.unit, 6);
    const QPoint shown = position.toPoint() + m_plot->pos();
    QToolTip::showText(
        m_canvas.owner().mapToGlobal(shown), lines.join(QLatin1Char('\n')), &m_canvas.owner());
}

void PlotMouse::wheel(const QWheelEvent &event)
{
    const QPoint delta = event.angleDelta();
    const double notches = (delta.y() != 0 ? delta.y() : delta.x()) / 120.0;
    if (notches == 0.0)
        return;
    const QPointF at = inPlot(event.position());
    if (event.modifiers().testFlag(Qt::ShiftModifier)) {
        m_canvas.pan(-kWheelPanStep * notches, 0.0);
        return;
    }
    const QRect rect = m_plot->axisRect()->rect();
    const double factor = std::pow(kWheelZoom, notches);
    const bool both = m_canvas.scene().content().equalAspect;
    const bool onY = at.x() < rect.left() || event.modifiers().testFlag(Qt::ControlModifier);
    m_canvas.remember();
    if (!onY || both)
        m_plot->xAxis->scaleRange(factor, m_plot->xAxis->pixelToCoord(at.x()));
    if (onY || both)
        m_plot->yAxis->scaleRange(factor, m_plot->yAxis->pixelToCoord(at.y()));
    m_canvas.replot();
}

bool PlotMouse::cancelDrag()
{
    const Drag cancelled = std::exchange(m_drag, Drag{});
    m_rubberBand->hide();
    if (const auto *handle = std::get_if<DragHandle>(&cancelled)) {
        m_canvas.handles().set(handle->before);
        emit m_canvas.handleDragCancelled(handle->before);
    } else if (const auto *cursor = std::get_if<DragCursor>(&cancelled)) {
        m_canvas.moveCursor(cursor->which, cursor->before);
    } else if (const auto *pan = std::get_if<DragPan>(&cancelled)) {
        m_canvas.setView({pan->x, pan->y});
    }
    m_canvas.replot();
    return !std::holds_alternative<std::monostate>(cancelled);
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_keyboard.h"

#include <QKeyEvent>

#include <algorithm>

namespace dyncal {

namespace {

constexpr double kPanStep = 0.1; ///< of the range per arrow
constexpr double kKeyZoom = 0.7;

} // namespace

void PlotKeyboard::placeCursor(int which)
{
    const QRect rect = m_canvas.plot().axisRect()->rect();
    const QPointF pointer = m_mouse.pointer();
    const QPointF at = rect.contains(pointer.toPoint()) ? pointer : QPointF(rect.center());
    if (const auto point = nearestPoint(m_canvas.plot(), m_canvas.scene(), at, std::nullopt))
        m_canvas.moveCursor(which, *point);
}

/// By samples of its curve: the cursor placed last.
bool PlotKeyboard::stepCursor(Index steps)
{
    const std::optional<int> which = m_canvas.cursors().last();
    if (which)
        m_canvas.moveCursor(*which, m_canvas.cursors().stepped(m_canvas.scene(), *which, steps));
    return which.has_value();
}

void PlotKeyboard::nudge(double steps)
{
    const auto &focused = m_canvas.focusedGrip();
    const HandleState *state = focused ? m_canvas.handles().find(focused->id) : nullptr;
    if (!state)
        return;
    const double at = m_canvas.handles().positionOf(*focused);
    double step = 1.0;
    if (!state->snapToIntegers) { // one pixel at this zoom
        const QCPAxis &axis = *m_canvas.plot().xAxis;
        step = axis.pixelToCoord(axis.coordToPixel(at) + 1.0) - at;
    }
    const HandleState after = m_canvas.handles().moved(*state, *focused, at + steps * step);
    m_canvas.handles().set(after);
    m_canvas.replot();
    emit m_canvas.handleMoved(after, true);
}

bool PlotKeyboard::focusNextGrip(bool next)
{
    const std::vector<HandleGrip> grips = m_canvas.handles().grips();
    if (grips.empty())
        return false;
    const auto count = static_cast<Index>(grips.size());
    Index at = next ? -1 : count;
    if (const auto &focused = m_canvas.focusedGrip())
        at = std::find(grips.begin(), grips.end(), *focused) - grips.begin();
    at += next ? 1 : -1;
    const bool inside = at >= 0 && at < count;
    m_canvas.focusGrip(inside ? std::optional(grips[static_cast<std::size_t>(at)]) : std::nullopt);
    return inside;
}

/// Ends what is under way, the latest first.
bool PlotKeyboard::escape()
{
    if (m_mouse.isMarking()) {
        m_mouse.cancelDrag();
        m_mouse.setMarking(false);
        return true;
    }
    if (m_mouse.cancelDrag())
        return true;
    if (!m_canvas.cursors().any())
        return false;
    m_canvas.clearCursors();
    emit m_canvas.cursorsCleared();
    return true;
}

bool PlotKeyboard::press(const QKeyEvent &event)
{
    const double many = event.modifiers().testFlag(Qt::ShiftModifier) ? 10.0 : 1.0;
    const auto &focused = m_canvas.focusedGrip();
    const bool onHandle = focused && m_canvas.handles().find(focused->id);
    switch (event.key()) {
    case Qt::Key_F:
        emit m_canvas.fitRequested();
        return true;
    case Qt::Key_G:
        if (event.modifiers().testFlag(Qt::ControlModifier)) {
            emit m_canvas.goToRequested();
            return true;
        }
        m_canvas.scene().setGridVisible(!m_canvas.scene().isGridVisible());
        m_canvas.replot();
        return true;
    case Qt::Key_1:
    case Qt::Key_2:
        placeCursor(event.key() == Qt::Key_1 ? 0 : 1);
        return true;
    case Qt::Key_Left:
    case Qt::Key_Right: {
        const double sign = event.key() == Qt::Key_Left ? -1.0 : 1.0;
        if (event.modifiers().testFlag(Qt::ControlModifier))
            return stepCursor(static_cast<Index>(sign * many));
        onHandle ? nudge(sign * many) : m_canvas.pan(sign * kPanStep, 0.0);
        return true;
    }
    case Qt::Key_Up:
    case Qt::Key_Down:
        m_canvas.pan(0.0, event.key() == Qt::Key_Up ? kPanStep : -kPanStep);
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Minus:
        m_canvas.zoomBy(event.key() == Qt::Key_Plus ? kKeyZoom : 1.0 / kKeyZoom);
        return true;
    case Qt::Key_Backspace:
        m_canvas.goBack(event.modifiers().testFlag(Qt::ShiftModifier));
        return true;
    case Qt::Key_Escape:
        return escape();
    default:
        return false;
    }
}

bool PlotKeyboard::takesPrecedence(const QKeyEvent &event) const
{
    return event.key() == Qt::Key_Escape
        && (m_mouse.isDragging() || m_mouse.isMarking() || m_canvas.cursors().any());
}

} // namespace dyncal

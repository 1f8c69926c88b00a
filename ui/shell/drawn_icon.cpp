// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/drawn_icon.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <functional>
#include <utility>

namespace dyncal {

namespace {

constexpr double kGrid = 24.0; ///< all signs are drawn on 24 x 24
constexpr double kPen = 2.0;

/// Calls `draw` on a painter whose grid fills the icon.
class DrawnIconEngine : public QIconEngine
{
public:
    using Draw = std::function<void(QPainter &painter, QIcon::Mode mode)>;

    explicit DrawnIconEngine(Draw draw)
        : m_draw(std::move(draw))
    {
    }

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        const double side = std::min(rect.width(), rect.height());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(
            rect.x() + (rect.width() - side) / 2, rect.y() + (rect.height() - side) / 2);
        painter->scale(side / kGrid, side / kGrid);
        m_draw(*painter, mode);
        painter->restore();
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }

    QIconEngine *clone() const override { return new DrawnIconEngine(m_draw); }

private:
    Draw m_draw;
};

/// The arrow of undo; redo is its mirror image.
void addTurn(QPainterPath &path)
{
    path.moveTo(9, 5);
    path.lineTo(4, 10);
    path.lineTo(9, 15);
    path.moveTo(4, 10);
    path.lineTo(14, 10);
    path.arcTo(QRectF(9.5, 10, 9, 9), 90, -180);
    path.lineTo(11, 19);
}

void addFolder(QPainterPath &path)
{
    path.moveTo(3, 19);
    path.lineTo(3, 5);
    path.lineTo(9, 5);
    path.lineTo(11, 8);
    path.lineTo(20, 8);
    path.lineTo(20, 11);
    path.moveTo(3, 19);
    path.lineTo(6, 11);
    path.lineTo(22, 11);
    path.lineTo(19, 19);
    path.lineTo(3, 19);
}

/// A record with a step that rings.
void addRecord(QPainterPath &path)
{
    path.moveTo(2, 18);
    path.lineTo(8, 18);
    path.lineTo(10, 4);
    path.lineTo(12, 13);
    path.lineTo(14, 7);
    path.lineTo(16, 10);
    path.lineTo(22, 10);
}

void addDisk(QPainterPath &path)
{
    path.addRect(4, 4, 16, 16);
    path.addRect(8, 4, 8, 5);
    path.addRect(7, 13, 10, 7);
}

void addSheetWithArrow(QPainterPath &path)
{
    path.moveTo(12, 3);
    path.lineTo(4, 3);
    path.lineTo(4, 21);
    path.lineTo(17, 21);
    path.lineTo(17, 15);
    path.moveTo(9, 11);
    path.lineTo(21, 11);
    path.moveTo(17, 7);
    path.lineTo(21, 11);
    path.lineTo(17, 15);
}

void addArrowBack(QPainterPath &path)
{
    path.moveTo(20, 12);
    path.lineTo(4, 12);
    path.moveTo(11, 5);
    path.lineTo(4, 12);
    path.lineTo(11, 19);
}

void addRound(QPainterPath &path)
{
    path.arcMoveTo(QRectF(4, 4, 16, 16), 60);
    path.arcTo(QRectF(4, 4, 16, 16), 60, 290);
    path.moveTo(15, 1);
    path.lineTo(16.5, 5.5);
    path.lineTo(12, 7.5);
}

QPainterPath mirrored(const QPainterPath &path)
{
    return QTransform(-1, 0, 0, 1, kGrid, 0).map(path);
}

QPainterPath pathOf(ToolSign sign)
{
    QPainterPath path;
    switch (sign) {
    case ToolSign::OpenCaptures:
        addRecord(path);
        break;
    case ToolSign::OpenProject:
        addFolder(path);
        break;
    case ToolSign::Save:
        addDisk(path);
        break;
    case ToolSign::Export:
        addSheetWithArrow(path);
        break;
    case ToolSign::Undo:
    case ToolSign::Redo:
        addTurn(path);
        break;
    case ToolSign::Back:
    case ToolSign::Forward:
        addArrowBack(path);
        break;
    case ToolSign::Compute:
        addRound(path);
        break;
    }
    return sign == ToolSign::Redo || sign == ToolSign::Forward ? mirrored(path) : path;
}

QColor lineColour(QIcon::Mode mode)
{
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
    return QGuiApplication::palette().color(group, role);
}

bool isDark()
{
    return QGuiApplication::palette().color(QPalette::Base).lightness() < 128;
}

/// At least 3:1 against the base of its theme; on a selected row they are drawn on a plate of it.
QColor statusColour(StageStatus status)
{
    switch (status) {
    case StageStatus::Blocked:
        return isDark() ? QColor(0xff8a80) : QColor(0xb3261e);
    case StageStatus::DoneWithCautions:
    case StageStatus::Incomplete:
        return isDark() ? QColor(0xffb74d) : QColor(0xa85b00);
    case StageStatus::Done:
        return isDark() ? QColor(0x66d19e) : QColor(0x0b7a4b);
    case StageStatus::NotStarted:
    case StageStatus::Computing:
    case StageStatus::Stale:
        break;
    }
    return isDark() ? QColor(0xb0b0b0) : QColor(0x5f5f5f);
}

void drawStatus(QPainter &painter, StageStatus status)
{
    const QColor colour = statusColour(status);
    painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(colour);
    switch (status) {
    case StageStatus::NotStarted:
        painter.drawLine(QPointF(6, 12), QPointF(18, 12));
        break;
    case StageStatus::Blocked:
        painter.drawRect(QRectF(5, 5, 14, 14));
        break;
    case StageStatus::DoneWithCautions:
        painter.drawPolygon(QPolygonF({{12, 4}, {21, 19}, {3, 19}}));
        break;
    case StageStatus::Done:
        painter.drawEllipse(QRectF(5, 5, 14, 14));
        break;
    case StageStatus::Incomplete:
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(5, 5, 14, 14));
        break;
    case StageStatus::Stale:
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, 2.5, Qt::DotLine, Qt::RoundCap));
        painter.drawEllipse(QRectF(4, 4, 16, 16));
        break;
    case StageStatus::Computing:
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(pathOf(ToolSign::Compute));
        break;
    }
}

} // namespace

QIcon toolIcon(ToolSign sign)
{
    return QIcon(new DrawnIconEngine([path = pathOf(sign)](QPainter &painter, QIcon::Mode mode) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(lineColour(mode), kPen, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(path);
    }));
}

QIcon statusIcon(StageStatus status)
{
    return QIcon(new DrawnIconEngine([status](QPainter &painter, QIcon::Mode mode) {
        if (mode == QIcon::Selected) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(QGuiApplication::palette().color(QPalette::Base));
            painter.drawRoundedRect(QRectF(0, 0, kGrid, kGrid), 4, 4);
        }
        drawStatus(painter, status);
    }));
}

} // namespace dyncal

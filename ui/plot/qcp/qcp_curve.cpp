// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_curve.h"

#include "ui/plot/values/dashes.h"

#include <algorithm>
#include <iterator>

namespace dyncal {

QCPScatterStyle scatterStyle(MarkerShape shape, const QColor &color, double size)
{
    const auto style = [&](QCPScatterStyle::ScatterShape scatter, bool filled) {
        return QCPScatterStyle(
            scatter, QPen(color, 1.3), filled ? QBrush(color) : QBrush(Qt::NoBrush), size);
    };
    switch (shape) {
    case MarkerShape::None:
        return QCPScatterStyle(QCPScatterStyle::ssNone);
    case MarkerShape::Dot:
        return style(QCPScatterStyle::ssDisc, true);
    case MarkerShape::Circle:
        return style(QCPScatterStyle::ssCircle, false);
    case MarkerShape::TriangleUp:
        return style(QCPScatterStyle::ssTriangle, false);
    case MarkerShape::TriangleDown:
        return style(QCPScatterStyle::ssTriangleInverted, true);
    case MarkerShape::Square:
        return style(QCPScatterStyle::ssSquare, false);
    case MarkerShape::Diamond:
        return style(QCPScatterStyle::ssDiamond, false);
    case MarkerShape::Cross:
        return style(QCPScatterStyle::ssCross, false);
    case MarkerShape::Plus:
        return style(QCPScatterStyle::ssPlus, false);
    case MarkerShape::Star:
        return style(QCPScatterStyle::ssStar, false);
    case MarkerShape::CrossInBox:
        return style(QCPScatterStyle::ssCrossSquare, false);
    }
    return {};
}

void RoleGraph::drawLegendIcon(QCPPainter *painter, const QRectF &rect) const
{
    QCPGraph::drawLegendIcon(painter, rect);
    if (m_legendMarker.isNone())
        return;
    applyScattersAntialiasingHint(painter);
    m_legendMarker.applyTo(painter, pen());
    m_legendMarker.drawShape(painter, rect.center());
}

void RoleGraph::drawLinePlot(QCPPainter *painter, const QVector<QPointF> &lines) const
{
    const QPen pen = painter->pen();
    if (pen.style() == Qt::SolidLine || pen.style() == Qt::NoPen
        || painter->modes().testFlag(QCPPainter::pmVectorized)) {
        QCPGraph::drawLinePlot(painter, lines);
        return;
    }
    applyDefaultAntialiasingHint(painter);
    QVector<qreal> pattern = pen.dashPattern();
    for (qreal &length : pattern)
        length *= std::max(1.0, pen.widthF());
    painter->setPen(QPen(pen.color(), pen.widthF(), Qt::SolidLine, Qt::FlatCap));
    Dashes dashes(std::move(pattern));
    QVector<QLineF> parts;
    for (int i = 1; i < lines.size(); ++i)
        dashes.add(lines[i - 1], lines[i], clipRect(), parts);
    painter->drawLines(parts);
    painter->setPen(pen);
}

void RoleGraph::drawScatterPlot(
    QCPPainter *painter, const QVector<QPointF> &scatters, const QCPScatterStyle &style) const
{
    const double size = style.size();
    const QRectF room = QRectF(clipRect()).adjusted(-size, -size, size, size);
    QVector<QPointF> seen;
    seen.reserve(scatters.size());
    std::ranges::copy_if(scatters, std::back_inserter(seen), [&room](const QPointF &point) {
        return point.x() >= room.left() && point.x() <= room.right() && point.y() >= room.top()
            && point.y() <= room.bottom(); // not a number is nowhere
    });
    QCPGraph::drawScatterPlot(painter, seen, style);
}

QCPAbstractPlottable *DrawnCurve::plottable() const
{
    return bars ? static_cast<QCPAbstractPlottable *>(bars) : graph;
}

} // namespace dyncal

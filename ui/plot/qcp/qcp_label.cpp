// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_label.h"

#include <QFontMetrics>
#include <QPainterPath>

namespace dyncal {
namespace {

constexpr double kRim_px = 3.0; ///< half of it outside the letters

} // namespace

PlotLabel::PlotLabel(QCustomPlot *plot)
    : QCPItemText(plot)
{
}

void PlotLabel::draw(QCPPainter *painter)
{
    // On paper a label is plain letters: an outline is no text for who searches or edits the file.
    if (m_rim.isValid() && !painter->modes().testFlag(QCPPainter::pmVectorized)) {
        // As QCPItemText places its text; its anchors still tell where it stood before.
        const QFontMetrics metrics(font(), painter->device());
        const QMargins pads = padding();
        const QRect letters = metrics.boundingRect(
            0, 0, 0, 0, Qt::TextDontClip | static_cast<int>(textAlignment()), text());
        const QRectF box = letters.adjusted(-pads.left(), -pads.top(), pads.right(), pads.bottom());
        const QPointF corner = position->pixelPosition()
            + getTextDrawPoint(QPointF(0, 0), box, positionAlignment()).toPoint();
        QPainterPath outline;
        outline.addText(
            corner + QPointF(pads.left(), pads.top() + metrics.ascent()), font(), text());
        painter->save();
        painter->setAntialiasing(true);
        painter->strokePath(
            outline, QPen(m_rim, kRim_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->restore();
    }
    QCPItemText::draw(painter);
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_label.h"

#include <QFontMetrics>
#include <QTextLayout>

#include <array>

namespace dyncal {
namespace {

/// Around each letter, in pixels.
constexpr std::array<QPoint, 8> kAround{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

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
        // Letters once more on every side: stroking their outline took a seventh of an order drag's
        // time in the window (docs/benchmarks.md).
        QTextLayout around(text(), font());
        around.beginLayout();
        around.createLine().setLineWidth(QWIDGETSIZE_MAX); // one line
        around.endLayout();
        painter->save();
        painter->setPen(m_rim);
        for (const QPoint &side : kAround)
            around.draw(painter, corner + QPointF(pads.left(), pads.top()) + side);
        painter->restore();
    }
    QCPItemText::draw(painter);
}

} // namespace dyncal

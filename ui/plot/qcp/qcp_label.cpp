// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_label.h"

#include <QFontMetricsF>
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
    if (m_rim.isValid()) {
        const QPointF corner = topLeft->pixelPosition();
        QPainterPath letters;
        letters.addText(corner.x() + padding().left(),
            corner.y() + padding().top() + QFontMetricsF(font()).ascent(), font(), text());
        painter->save();
        painter->setAntialiasing(true);
        painter->strokePath(
            letters, QPen(m_rim, kRim_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->restore();
    }
    QCPItemText::draw(painter);
}

} // namespace dyncal

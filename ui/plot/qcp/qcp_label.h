// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QColor>

#include <qcustomplot.h>

namespace dyncal {

/// A line of text inside a plot that can be read over curves: its letters have a rim of the colour
/// of the background. The rim hides less than a filled box would, and needs no alpha (PDF/A).
class PlotLabel : public QCPItemText
{
public:
    explicit PlotLabel(QCustomPlot *plot);

    void setRim(const QColor &color) { m_rim = color; }

protected:
    void draw(QCPPainter *painter) override;

private:
    QColor m_rim;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/plot_text.h"
#include "ui/plot/values/plot_theme.h"

#include <qcustomplot.h>

#include <complex>

namespace dyncal {

/// Behind a map of the z plane: where poles of one damping ratio lie (spirals from 1) and where
/// those of one undamped frequency lie (arcs from the unit circle), with their values.
class DampingGrid : public QCPAbstractItem
{
public:
    /// `rate_Hz`: the sample rate, from which the labels get their frequencies.
    DampingGrid(QCustomPlot *plot, double rate_Hz);

    void setTheme(const PlotTheme &theme);
    const std::vector<PlotText> &texts() const { return m_texts; } ///< drawn last
    double selectTest(const QPointF &, bool, QVariant * = nullptr) const override { return -1.0; }

protected:
    void draw(QCPPainter *painter) override;

private:
    QPointF pixelOf(std::complex<double> z) const;
    void drawLines(QCPPainter *painter) const;
    void drawFrequencies(QCPPainter *painter);
    void drawDampingRatios(QCPPainter *painter);
    void drawLabel(QCPPainter *painter, const QPointF &at, const QString &text);

    double m_rate_Hz;
    QColor m_line;
    QColor m_text;
    QFont m_font;
    std::vector<PlotText> m_texts;
};

} // namespace dyncal

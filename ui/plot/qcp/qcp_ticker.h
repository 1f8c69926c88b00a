// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/axis_prefix.h"
#include "ui/plot/values/plot_content.h"

#include <qcustomplot.h>

#include <limits>

namespace dyncal {

/// Ticks of a linear axis whose data stay SI: labels are divided by the prefix of the range shown
/// and have just the decimals that the step needs.
class PrefixTicker : public QCPAxisTicker
{
public:
    explicit PrefixTicker(const PlotAxis &axis);

protected:
    double getTickStep(const QCPRange &range) override;
    int getSubTickCount(double tickStep) override;
    QVector<double> createTickVector(double tickStep, const QCPRange &range) override;
    QVector<QString> createLabelVector(const QVector<double> &ticks, const QLocale &locale,
        QChar formatChar, int precision) override;

private:
    PlotAxis m_axis;
    AxisPrefix m_prefix;
};

/// Ticks of a logarithmic axis: decades, with 2 and 5 where few decades are shown, and linear
/// steps below half a decade. Labels are in the prefix of the axis where the unit takes any ("0.1",
/// "10" of "Frequency / kHz"), else "10⁻³".
class DecadeTicker : public QCPAxisTicker
{
public:
    explicit DecadeTicker(const PlotAxis &axis);
    /// At most as many labels as have room; without a call as many as the decades give.
    void setMostTicks(int ticks) { m_mostTicks = ticks; }

protected:
    QVector<double> createTickVector(double tickStep, const QCPRange &range) override;
    QVector<double> createSubTickVector(int subTickCount, const QVector<double> &ticks) override;
    QString getTickLabel(
        double tick, const QLocale &locale, QChar formatChar, int precision) override;

private:
    PlotAxis m_axis;
    QCPRange m_range;
    AxisPrefix m_prefix;
    bool m_decadesOnly = false;
    int m_mostTicks = std::numeric_limits<int>::max();
};

} // namespace dyncal

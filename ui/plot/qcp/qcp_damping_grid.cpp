// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_damping_grid.h"

#include "ui/plot/values/axis_prefix.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {

namespace {

constexpr std::array<double, 5> kDampingRatios{0.1, 0.3, 0.5, 0.7, 0.9};
constexpr int kFrequencies = 5; ///< even steps up to half the sample rate
constexpr int kPoints = 60; ///< of a line: steps of some pixels
constexpr double kLeastRadius_px = 40.0; ///< of the unit circle, for labels to have room
constexpr double kGridLabelGap_px = 4.0;
constexpr double kSmaller = 0.85; ///< size of labels relative to those of the axes

/// e^(sT) with undamped angular frequency w0 T and damping ratio zeta, upper half.
std::complex<double> pole(double w0T, double zeta)
{
    return std::exp(w0T * std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta)));
}

double frequencyAngle(int step)
{
    return M_PI * step / kFrequencies;
}

} // namespace

DampingGrid::DampingGrid(QCustomPlot *plot, double rate_Hz)
    : QCPAbstractItem(plot)
    , m_rate_Hz(rate_Hz)
{
    setLayer("grid");
    setSelectable(false);
}

void DampingGrid::setTheme(const PlotTheme &theme)
{
    m_line = theme.grid;
    m_text = theme.axis;
    m_font = theme.font;
    if (theme.font.pointSizeF() > 0.0)
        m_font.setPointSizeF(kSmaller * theme.font.pointSizeF());
    else
        m_font.setPixelSize(std::max(1, static_cast<int>(kSmaller * theme.font.pixelSize())));
}

QPointF DampingGrid::pixelOf(std::complex<double> z) const
{
    return {mParentPlot->xAxis->coordToPixel(z.real()), mParentPlot->yAxis->coordToPixel(z.imag())};
}

void DampingGrid::draw(QCPPainter *painter)
{
    drawLines(painter);
    m_texts.clear();
    if (pixelOf(1.0).x() - pixelOf(0.0).x() < kLeastRadius_px)
        return;
    painter->setFont(m_font);
    painter->setPen(m_text);
    drawFrequencies(painter);
    drawDampingRatios(painter);
}

void DampingGrid::drawLines(QCPPainter *painter) const
{
    painter->setPen(QPen(m_line, 1.0));
    const auto line = [&](const auto &at) {
        QPolygonF upper, lower;
        for (int i = 0; i <= kPoints; ++i) {
            const std::complex<double> z = at(static_cast<double>(i) / kPoints);
            upper << pixelOf(z);
            lower << pixelOf(std::conj(z));
        }
        painter->drawPolyline(upper);
        painter->drawPolyline(lower);
    };
    for (const double zeta : kDampingRatios) // up to the Nyquist frequency
        line([&](double part) { return pole(part * M_PI / std::sqrt(1.0 - zeta * zeta), zeta); });
    for (int step = 1; step <= kFrequencies; ++step)
        line([&](double zeta) { return pole(frequencyAngle(step), zeta); });
}

/// Left out where it would lie on another or leave the axes.
void DampingGrid::drawLabel(QCPPainter *painter, const QPointF &at, const QString &text)
{
    const QFontMetricsF metrics(m_font);
    const QRectF rect(at - QPointF(0.0, metrics.ascent()), metrics.size(0, text));
    const bool isFree = QRectF(mParentPlot->axisRect()->rect()).contains(rect)
        && std::ranges::none_of(
            m_texts, [&](const PlotText &other) { return other.rect.intersects(rect); });
    if (!isFree)
        return;
    painter->drawText(at, text);
    m_texts.push_back({text, rect, true});
}

/// Outside the upper half of the unit circle.
void DampingGrid::drawFrequencies(QCPPainter *painter)
{
    const QFontMetricsF metrics(m_font);
    for (int step = 1; step <= kFrequencies; ++step) {
        const std::complex<double> z = pole(frequencyAngle(step), 0.0);
        const QString text
            = valueWithUnit(step * m_rate_Hz / (2.0 * kFrequencies), QStringLiteral("Hz"), 2);
        const double width = metrics.horizontalAdvance(text);
        const double side = z.real() < 0.0 ? -kGridLabelGap_px - width : kGridLabelGap_px;
        drawLabel(painter, pixelOf(z) + QPointF(side, 0.3 * metrics.height()), text);
    }
}

/// Beside the lower half of the imaginary axis, where a quarter of the sample rate is.
void DampingGrid::drawDampingRatios(QCPPainter *painter)
{
    const QFontMetricsF metrics(m_font);
    double above = pixelOf({0.0, -1.0}).y();
    for (const double zeta : kDampingRatios) {
        const QPointF at
            = pixelOf(std::conj(pole(0.5 * M_PI / std::sqrt(1.0 - zeta * zeta), zeta)));
        if (above - at.y() < 0.8 * metrics.height())
            continue;
        above = at.y();
        drawLabel(painter, at + QPointF(kGridLabelGap_px, 0.35 * metrics.height()),
            QStringLiteral("ζ ") + QLocale().toString(zeta));
    }
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/trace_cell.h"

#include "ui/text/quantity_format.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr QSize kTraceSize(150, 28);
constexpr double kTraceMargin_px = 2.0;

/// Gives the sentences below their translation context.
struct TraceText
{
    Q_DECLARE_TR_FUNCTIONS(TraceText)
};

} // namespace

TraceCell::TraceCell(QWidget *parent)
    : QWidget(parent)
{
    setMinimumSize(kTraceSize);
}

QSize TraceCell::sizeHint() const
{
    return kTraceSize;
}

void TraceCell::setGlance(const ChannelGlance &glance)
{
    m_glance = glance;
    update();
}

QPolygonF TraceCell::outline(const ChannelGlance &glance, const QRectF &inside)
{
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const SampleExtremes &stretch : glance.trace) {
        if (!stretch.any)
            continue;
        lowest = std::min(lowest, stretch.min);
        highest = std::max(highest, stretch.max);
    }
    if (!(lowest <= highest))
        return {};
    const double range = highest > lowest ? highest - lowest : 1.0;
    const double width = inside.width() / static_cast<double>(glance.trace.size());
    const auto at = [&](std::size_t i, double value) {
        return QPointF(inside.left() + (static_cast<double>(i) + 0.5) * width,
            inside.bottom() - (value - lowest) / range * inside.height());
    };
    QPolygonF upper;
    QPolygonF lower;
    for (std::size_t i = 0; i < glance.trace.size(); ++i) {
        const SampleExtremes &stretch = glance.trace[i];
        if (!stretch.any)
            continue;
        upper << at(i, stretch.max);
        lower.prepend(at(i, stretch.min));
    }
    return upper + lower;
}

void TraceCell::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = palette().color(QPalette::Text);
    painter.setPen(QPen(ink, 1.0));
    painter.setBrush(ink);
    painter.drawPolygon(outline(m_glance,
        QRectF(rect()).adjusted(
            kTraceMargin_px, kTraceMargin_px, -kTraceMargin_px, -kTraceMargin_px)));
}

QString glanceText(const ChannelGlance &glance, const QString &unit)
{
    if (glance.trace.empty())
        return {};
    if (!glance.steps())
        return TraceText::tr("no step");
    const QString step = shownQuantity(glance.step, unit, 3);
    return glance.noise > 0.0 ? TraceText::tr("step %1, %2 times the noise")
                                    .arg(step, shownNumber(std::abs(glance.step) / glance.noise, 2))
                              : TraceText::tr("step %1, no noise").arg(step);
}

} // namespace dyncal

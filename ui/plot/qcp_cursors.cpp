// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp_cursors.h"

#include "ui/plot/axis_prefix.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {

namespace {

constexpr int kDigits = 6;
/// Samples looked at around the pointer at most; more share a pixel column and look alike.
constexpr Index kMostCandidates = 20000;

const char *cursorName(std::size_t which)
{
    return which == 0 ? "A" : "B";
}

QString valueText(double value, const PlotAxis &axis)
{
    return valueWithUnit(value, axis.unit, kDigits);
}

} // namespace

std::optional<CurvePoint> nearestPoint(const QCustomPlot &plot, const PlotScene &scene,
    const QPointF &position, std::optional<double> reach_px)
{
    std::optional<CurvePoint> best;
    double bestDistance = std::numeric_limits<double>::infinity();
    const double halfWidth = reach_px.value_or(1e9);
    const double from = plot.xAxis->pixelToCoord(position.x() - halfWidth);
    const double to = plot.xAxis->pixelToCoord(position.x() + halfWidth);
    for (std::size_t c = 0; c < scene.curves().size(); ++c) {
        const DrawnCurve &drawn = scene.curves()[c];
        if (!drawn.visible)
            continue;
        Index begin = drawn.samples->firstFrom(from);
        Index end = drawn.samples->firstBeyond(to);
        if (end - begin > kMostCandidates) {
            const Index middle = drawn.samples->firstFrom(plot.xAxis->pixelToCoord(position.x()));
            begin = std::max(begin, middle - kMostCandidates / 2);
            end = std::min(end, middle + kMostCandidates / 2);
        }
        const DrawnPoints around = drawn.samples->samples(begin, std::max(begin, end));
        for (std::size_t i = 0; i < around.x.size(); ++i) {
            const double x = around.x[i];
            const double y = around.y[i];
            const double dx = plot.xAxis->coordToPixel(x) - position.x();
            const double dy = plot.yAxis->coordToPixel(y) - position.y();
            const double distance = std::hypot(dx, dy);
            if (distance <= bestDistance) { // false for NaN; what is drawn on top wins
                bestDistance = distance;
                best = CurvePoint{c, x, y};
            }
        }
    }
    if (reach_px && bestDistance > *reach_px)
        return std::nullopt;
    return best;
}

PlotCursors::PlotCursors(QCustomPlot &plot)
    : m_plot(plot)
{
    for (std::size_t i = 0; i < 2; ++i) {
        auto *line = new QCPItemLine(&m_plot);
        for (QCPItemPosition *position : {line->start, line->end}) {
            position->setTypeX(QCPItemPosition::ptPlotCoords);
            position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        }
        line->setSelectable(false);
        line->setVisible(false);
        auto *name = new QCPItemText(&m_plot);
        name->position->setTypeX(QCPItemPosition::ptPlotCoords);
        name->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        name->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
        name->setPadding(QMargins(3, 0, 3, 20));
        name->setText(cursorName(i));
        name->setSelectable(false);
        name->setVisible(false);
        m_lines[i] = line;
        m_names[i] = name;
    }
    m_readout = new QCPItemText(&m_plot);
    m_readout->position->setType(QCPItemPosition::ptAxisRectRatio);
    m_readout->position->setCoords(0.995, 0.99);
    m_readout->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
    m_readout->setTextAlignment(Qt::AlignLeft);
    m_readout->setPadding(QMargins(5, 3, 5, 3));
    m_readout->setSelectable(false);
    m_readout->setVisible(false);
}

void PlotCursors::place(int which, const CurvePoint &point)
{
    m_points[static_cast<std::size_t>(which)] = point;
}

void PlotCursors::clear()
{
    m_points = {};
}

QString PlotCursors::readout(const PlotContent &content) const
{
    QStringList lines;
    for (std::size_t i = 0; i < 2; ++i)
        if (m_points[i])
            lines += QStringLiteral("%1: %2; %3")
                         .arg(cursorName(i), valueText(m_points[i]->x, content.xAxis),
                             valueText(m_points[i]->y, content.yAxis));
    if (m_points[0] && m_points[1]) {
        const double dx = m_points[1]->x - m_points[0]->x;
        lines += QStringLiteral("Δx: %1").arg(valueText(dx, content.xAxis));
        if (content.xAxis.unit == QLatin1String("s") && dx != 0.0)
            lines += QStringLiteral("1/Δx: %1")
                         .arg(valueWithUnit(1.0 / std::abs(dx), QStringLiteral("Hz"), kDigits));
        lines += QStringLiteral("Δy: %1").arg(
            valueText(m_points[1]->y - m_points[0]->y, content.yAxis));
    }
    return lines.join(QLatin1Char('\n'));
}

void PlotCursors::refresh(const PlotScene &scene)
{
    const PlotTheme &theme = scene.theme();
    for (std::size_t i = 0; i < 2; ++i) {
        m_lines[i]->setVisible(m_points[i].has_value());
        m_names[i]->setVisible(m_points[i].has_value());
        if (!m_points[i])
            continue;
        m_lines[i]->start->setCoords(m_points[i]->x, 0.0);
        m_lines[i]->end->setCoords(m_points[i]->x, 1.0);
        m_lines[i]->setPen(QPen(theme.text, 1.0, i == 0 ? Qt::SolidLine : Qt::DashLine));
        m_names[i]->position->setCoords(m_points[i]->x, 1.0);
        m_names[i]->setColor(theme.text);
        m_names[i]->setFont(theme.font);
    }
    m_readout->setVisible(any());
    m_readout->setText(readout(scene.content()));
    m_readout->setColor(theme.text);
    m_readout->setFont(theme.font);
    m_readout->setBrush(theme.readoutFill);
    m_readout->setPen(QPen(theme.axis, 1));
}

} // namespace dyncal

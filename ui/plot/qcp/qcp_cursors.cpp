// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_cursors.h"

#include "ui/plot/values/axis_prefix.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace dyncal {

namespace {

constexpr int kReadingDigits = 6;
/// Up to this many samples are examined one by one; of more, only the extremes of pixel columns.
constexpr Index kMostCandidates = 20000;

const char *cursorName(std::size_t which)
{
    return which == 0 ? "A" : "B";
}

/// Edges of the pixel columns within reach; without a reach, those of the whole plot.
std::vector<double> pixelEdges(
    const QCustomPlot &plot, const QPointF &position, std::optional<double> reach_px)
{
    const QRect rect = plot.axisRect()->rect();
    const double reach
        = reach_px.value_or(rect.width() + std::abs(position.x() - rect.center().x()));
    std::vector<double> edges;
    for (double pixel = position.x() - reach; pixel < position.x() + reach + 1.0; pixel += 1.0)
        edges.push_back(plot.xAxis->pixelToCoord(pixel));
    if (plot.xAxis->rangeReversed())
        std::ranges::reverse(edges);
    return edges;
}

/// The samples between the edges; if there are many, only the lowest and highest of every column.
/// With `all`, samples beyond the edges too, unless there are many.
DrawnPoints candidates(const CurveSamples &samples, const std::vector<double> &edges, bool all)
{
    const Index begin = all ? 0 : samples.firstFrom(edges.front());
    const Index end = all ? samples.size() : samples.firstBeyond(edges.back());
    return end - begin <= kMostCandidates ? samples.samples(begin, std::max(begin, end))
                                          : samples.points(edges);
}

/// Whether there is one y for each x: not of the points of a map or of a strip of orders.
bool hasOneValue(const PlotContent &content, const PlotCurve &curve)
{
    return !content.equalAspect
        && (curve.record
            || std::ranges::adjacent_find(curve.x, std::ranges::greater_equal()) == curve.x.end());
}

QString valueText(double value, const PlotAxis &axis)
{
    return valueWithUnit(value, axis.unit, kReadingDigits);
}

} // namespace

std::optional<CurvePoint> nearestPoint(const QCustomPlot &plot, const PlotScene &scene,
    const QPointF &position, std::optional<double> reach_px)
{
    std::optional<CurvePoint> best;
    double bestDistance = std::numeric_limits<double>::infinity();
    bool isExtreme = false;
    const std::vector<double> edges = pixelEdges(plot, position, reach_px);
    for (std::size_t c = 0; c < scene.curves().size(); ++c) {
        const DrawnCurve &drawn = scene.curves()[c];
        if (!drawn.visible || drawn.curve->onSecondAxis)
            continue;
        const DrawnPoints around = candidates(*drawn.samples, edges, !reach_px);
        for (std::size_t i = 0; i < around.x.size(); ++i) {
            const double dx = plot.xAxis->coordToPixel(around.x[i]) - position.x();
            const double dy = plot.yAxis->coordToPixel(around.y[i]) - position.y();
            const double distance = std::hypot(dx, dy);
            if (distance <= bestDistance) { // false for NaN; what is drawn on top wins
                bestDistance = distance;
                best = CurvePoint{c, around.x[i], around.y[i]};
                isExtreme = around.enveloped;
            }
        }
    }
    if (!best || (reach_px && bestDistance > *reach_px))
        return std::nullopt;
    if (isExtreme)
        best->x = scene.curves()[best->curve].samples->placeOf(best->x, best->y, edges);
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
        auto *name = new PlotLabel(&m_plot);
        name->setLayer(QStringLiteral("overlay"));
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
    m_readout->setLayer(QStringLiteral("overlay")); // never under the curves
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
    m_last = which;
}

void PlotCursors::clear()
{
    m_points = {};
}

std::optional<int> PlotCursors::cursorAt(const QPointF &position, double reach_px) const
{
    if (!m_plot.axisRect()->rect().contains(position.toPoint()))
        return std::nullopt;
    for (int which : {0, 1})
        if (at(which)
            && std::abs(m_plot.xAxis->coordToPixel(at(which)->x) - position.x()) <= reach_px)
            return which;
    return std::nullopt;
}

CurvePoint PlotCursors::sampleAt(const PlotScene &scene, double x)
{
    for (std::size_t c = 0; c < scene.curves().size(); ++c) {
        const DrawnCurve &drawn = scene.curves()[c];
        if (!drawn.visible || drawn.curve->onSecondAxis
            || !hasOneValue(scene.content(), *drawn.curve))
            continue;
        if (const auto at = sampleNear(*drawn.samples, x)) {
            const DrawnPoints sample = drawn.samples->samples(*at, *at + 1);
            return {c, sample.x.front(), sample.y.front()};
        }
    }
    return {0, x, std::numeric_limits<double>::quiet_NaN()};
}

CurvePoint PlotCursors::stepped(const PlotScene &scene, int which, Index steps) const
{
    const CurvePoint here = at(which).value_or(CurvePoint());
    const CurvePoint from = std::isfinite(here.y) ? here : sampleAt(scene, here.x);
    if (!std::isfinite(from.y) || from.curve >= scene.curves().size())
        return here;
    const CurveSamples &samples = *scene.curves()[from.curve].samples;
    const Index to
        = std::clamp<Index>(sampleNear(samples, from.x).value_or(0) + steps, 0, samples.size() - 1);
    const DrawnPoints sample = samples.samples(to, to + 1);
    return {from.curve, sample.x.front(), sample.y.front()};
}

CursorValues PlotCursors::values(const PlotScene &scene) const
{
    const PlotContent &content = scene.content();
    CursorValues values{content.xAxis.quantity, content.xAxis.unit, {}, {}};
    for (std::size_t i = 0; i < 2; ++i)
        if (m_points[i])
            values.x[i] = m_points[i]->x;
    for (const DrawnCurve &drawn : scene.curves()) {
        if (!drawn.visible || !hasOneValue(content, *drawn.curve))
            continue;
        const bool isSecond = drawn.curve->onSecondAxis && content.yAxis2;
        CursorRow row{drawn.curve->name, isSecond ? content.yAxis2->unit : content.yAxis.unit, {}};
        for (std::size_t i = 0; i < 2; ++i)
            if (values.x[i])
                row.y[i] = valueNear(*drawn.samples, *values.x[i]);
        values.rows.push_back(row);
    }
    return values;
}

/// Of a curve that changed the cursor shows what it is now, where the cursor stands.
void PlotCursors::readAgain(const PlotScene &scene)
{
    for (std::optional<CurvePoint> &point : m_points) {
        if (!point || !std::isfinite(point->y))
            continue;
        const DrawnCurve *drawn
            = point->curve < scene.curves().size() ? &scene.curves()[point->curve] : nullptr;
        if (drawn && !hasOneValue(scene.content(), *drawn->curve))
            continue;
        const auto now = drawn ? valueNear(*drawn->samples, point->x) : std::nullopt;
        point->y = now.value_or(std::numeric_limits<double>::quiet_NaN());
    }
}

QString PlotCursors::readout(const PlotContent &content) const
{
    QStringList lines;
    for (std::size_t i = 0; i < 2; ++i)
        if (m_points[i]) {
            QString line = QStringLiteral("%1: %2").arg(
                cursorName(i), valueText(m_points[i]->x, content.xAxis));
            if (std::isfinite(m_points[i]->y)) // of another plot's cursor only x is known
                line += QStringLiteral("; ") + valueText(m_points[i]->y, content.yAxis);
            lines += line;
        }
    if (m_points[0] && m_points[1]) {
        const double dx = m_points[1]->x - m_points[0]->x;
        lines += QStringLiteral("Δx: %1").arg(valueText(dx, content.xAxis));
        if (content.xAxis.unit == QLatin1String("s") && dx != 0.0)
            lines += QStringLiteral("1/Δx: %1")
                         .arg(valueWithUnit(
                             1.0 / std::abs(dx), QStringLiteral("Hz"), kReadingDigits));
        if (const double dy = m_points[1]->y - m_points[0]->y; std::isfinite(dy))
            lines += QStringLiteral("Δy: %1").arg(valueText(dy, content.yAxis));
    }
    return lines.join(QLatin1Char('\n'));
}

void PlotCursors::refresh(const PlotScene &scene)
{
    const PlotTheme &theme = scene.theme();
    readAgain(scene);
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
        m_names[i]->setRim(theme.background);
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

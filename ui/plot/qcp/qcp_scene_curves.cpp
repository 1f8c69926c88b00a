// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_scene_curves.h"

#include "ui/plot/values/curve_envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {

namespace {

constexpr std::size_t kDensePoints = 4000;
constexpr int kPixelsPerDot = 4; ///< samples get dots when they are at least this far apart
constexpr int kPixelsPerDash = 2; ///< least distance of samples for a dashed line
constexpr double kLongestDashed
    = 30.0; ///< heights of the plot that a dashed line may go up and down
constexpr Index kMarkersPerCurve = 8;
constexpr double kMarkerSize = 6.0;
constexpr double kDotSize = 4.0;

QVector<double> toQt(const std::vector<double> &values)
{
    return {values.begin(), values.end()};
}

bool isShot(CurveRole role)
{
    return role == CurveRole::ShotLow || role == CurveRole::ShotMedium
        || role == CurveRole::ShotHigh || role == CurveRole::ShotOther;
}

/// Roles whose lines may lie on each other and are told apart by markers too.
bool hasMarkers(CurveRole role)
{
    return isShot(role) || (role >= CurveRole::Candidate1 && role <= CurveRole::Candidate4);
}

bool isLine(CurveStyle style)
{
    return style == CurveStyle::Line || style == CurveStyle::Steps
        || style == CurveStyle::LineAndDots;
}

bool usable(const PlotCurve &curve, const PlotContent &content, std::size_t i)
{
    const double x = curve.x[i];
    return std::isfinite(x) && !(content.xAxis.logarithmic && !(x > 0.0));
}

} // namespace

void SceneCurves::make(std::shared_ptr<const PlotContent> content)
{
    m_content = std::move(content);
    m_plot.legend->clearItems();
    m_plot.clearPlottables();
    m_curves.clear();
    // Samples keep views of the vectors in here: never reallocate.
    m_curves.reserve(m_content->curves.size());
    for (const PlotCurve &curve : m_content->curves) {
        DrawnCurve &drawn = m_curves.emplace_back();
        drawn.curve = &curve;
        drawn.visible = m_hidden.count(curve.name) == 0;
        prepareSamples(drawn);
        makePlottable(drawn);
    }
}

void SceneCurves::prepareSamples(DrawnCurve &drawn) const
{
    const PlotCurve &curve = *drawn.curve;
    const std::size_t count = std::min(curve.x.size(), curve.y.size());
    const bool second = curve.onSecondAxis && m_content->yAxis2;
    const bool logY = second ? m_content->yAxis2->logarithmic : m_content->yAxis.logarithmic;
    bool asGiven = curve.x.size() == curve.y.size();
    for (std::size_t i = 0; asGiven && i < count; ++i)
        asGiven = usable(curve, *m_content, i) && (i == 0 || curve.x[i] >= curve.x[i - 1])
            && !(logY && curve.y[i] <= 0.0);
    if (!asGiven) {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < count; ++i)
            if (usable(curve, *m_content, i))
                order.push_back(i);
        std::stable_sort(order.begin(), order.end(),
            [&curve](std::size_t a, std::size_t b) { return curve.x[a] < curve.x[b]; });
        for (const std::size_t i : order) {
            const double y = curve.y[i];
            drawn.ownX.push_back(curve.x[i]);
            drawn.ownY.push_back(logY && !(y > 0.0) ? std::numeric_limits<double>::quiet_NaN() : y);
        }
        if (drawn.ownX.empty()) { // not even one usable point: shows nothing
            drawn.ownX.push_back(std::numeric_limits<double>::quiet_NaN());
            drawn.ownY.push_back(std::numeric_limits<double>::quiet_NaN());
        }
    }
    drawn.samples = curve.record;
    if (!drawn.samples)
        drawn.samples = std::make_shared<CurveEnvelope>(drawn.x(), drawn.y());
    drawn.dense = static_cast<std::size_t>(drawn.samples->size()) > kDensePoints || curve.record;
}

void SceneCurves::makePlottable(DrawnCurve &drawn)
{
    const PlotCurve &curve = *drawn.curve;
    QCPAxis *y = curve.onSecondAxis ? m_plot.yAxis2 : m_plot.yAxis;
    if (curve.style == CurveStyle::Bars) {
        drawn.bars = new QCPBars(m_plot.xAxis, m_plot.yAxis);
        drawn.bars->setData(toQt(drawn.x()), toQt(drawn.y()), true);
        drawn.bars->setWidth(0.6);
    } else {
        drawn.graph = new RoleGraph(m_plot.xAxis, y);
        if (!drawn.dense)
            drawn.graph->setData(toQt(drawn.x()), toQt(drawn.y()), true);
    }
    drawn.plottable()->setName(curve.name);
    drawn.plottable()->setVisible(drawn.visible);
    if (isLine(curve.style)) {
        drawn.markers = new RoleGraph(m_plot.xAxis, y);
        drawn.markers->setLineStyle(QCPGraph::lsNone);
        drawn.markers->setVisible(drawn.visible);
    }
}

void SceneCurves::style(const PlotTheme &theme)
{
    m_theme = theme;
    for (DrawnCurve &drawn : m_curves)
        styleCurve(drawn);
}

void SceneCurves::styleCurve(DrawnCurve &drawn) const
{
    const RoleStyle style = m_theme.style(drawn.curve->role, drawn.curve->variant);
    if (drawn.bars) {
        drawn.bars->setPen(QPen(style.color, 1));
        drawn.bars->setBrush(style.color);
        return;
    }
    const MarkerShape lone = style.marker == MarkerShape::None ? MarkerShape::Dot : style.marker;
    switch (drawn.curve->style) {
    case CurveStyle::Dots:
        drawn.graph->setLineStyle(QCPGraph::lsNone);
        drawn.graph->setScatterStyle(scatterStyle(MarkerShape::Dot, style.color, kDotSize));
        break;
    case CurveStyle::Markers:
        drawn.graph->setLineStyle(QCPGraph::lsNone);
        drawn.graph->setScatterStyle(scatterStyle(lone, style.color, kMarkerSize + 2));
        break;
    case CurveStyle::Stems:
        drawn.graph->setLineStyle(QCPGraph::lsImpulse);
        drawn.graph->setScatterStyle(scatterStyle(MarkerShape::Dot, style.color, kDotSize));
        drawn.graph->setPen(QPen(style.color, 1));
        break;
    case CurveStyle::ErrorBars:
        drawn.graph->setLineStyle(QCPGraph::lsLine);
        drawn.graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssNone));
        drawn.graph->setPen(QPen(style.color, style.width));
        break;
    default:
        styleLine(drawn);
    }
}

void SceneCurves::styleLine(DrawnCurve &drawn) const
{
    const RoleStyle style = m_theme.style(drawn.curve->role, drawn.curve->variant);
    const bool steps = drawn.curve->style == CurveStyle::Steps;
    drawn.graph->setLineStyle(steps ? QCPGraph::lsStepLeft : QCPGraph::lsLine);
    drawn.graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssNone));
    QPen pen(style.color, style.width, style.dash);
    pen.setJoinStyle(Qt::RoundJoin);
    drawn.graph->setPen(pen);
    drawn.graph->setLegendMarker(hasMarkers(drawn.curve->role)
            ? scatterStyle(style.marker, style.color, kMarkerSize)
            : QCPScatterStyle());
}

std::vector<double> SceneCurves::columnEdges() const
{
    const QCPAxis *axis = m_plot.xAxis;
    const QRect rect = m_plot.axisRect()->rect();
    const int columns = std::max(1, rect.width() * m_columnsPerPixel);
    std::vector<double> edges(static_cast<std::size_t>(columns) + 1);
    for (int k = 0; k <= columns; ++k)
        edges[static_cast<std::size_t>(k)]
            = axis->pixelToCoord(rect.left() + static_cast<double>(k) / m_columnsPerPixel);
    if (axis->rangeReversed())
        std::reverse(edges.begin(), edges.end());
    return edges;
}

PlotContent SceneCurves::inView(PlotContent content) const
{
    const std::vector<double> edges = columnEdges();
    for (PlotCurve &curve : content.curves) {
        if (!curve.record)
            continue;
        DrawnPoints points = curve.record->points(edges);
        curve.x = std::move(points.x);
        curve.y = std::move(points.y);
    }
    return content;
}

bool SceneCurves::hasData() const
{
    return std::any_of(m_curves.begin(), m_curves.end(),
        [](const DrawnCurve &drawn) { return !drawn.x().empty(); });
}

void SceneCurves::setVisible(std::size_t position, bool visible)
{
    const QString name = m_curves[position].curve->name;
    for (DrawnCurve &drawn : m_curves) {
        if (drawn.curve->name != name)
            continue;
        drawn.visible = visible;
        drawn.plottable()->setVisible(visible);
        if (drawn.markers)
            drawn.markers->setVisible(visible);
    }
    if (visible)
        m_hidden.erase(name);
    else
        m_hidden.insert(name);
}

void SceneCurves::draw()
{
    const std::vector<double> edges = columnEdges();
    for (DrawnCurve &drawn : m_curves)
        if (drawn.graph && drawn.visible)
            drawCurve(drawn, edges);
}

/// Whether the line in view runs up and down so often that dashes would only be noise: a second
/// and more for some thousand points.
bool SceneCurves::isEntangled(const QCPGraph &graph) const
{
    const double longest_px = kLongestDashed * m_plot.axisRect()->height();
    const QCPAxis *axis = graph.valueAxis();
    const double perUnit_px = m_plot.axisRect()->height() / axis->range().size();
    const bool logarithmic = axis->scaleType() == QCPAxis::stLogarithmic;
    const auto end = graph.data()->findEnd(m_plot.xAxis->range().upper);
    auto point = graph.data()->findBegin(m_plot.xAxis->range().lower);
    const auto height_px
        = [&](double y) { return logarithmic ? axis->coordToPixel(y) : perUnit_px * y; };
    double length_px = 0.0;
    for (double before = std::numeric_limits<double>::quiet_NaN(); point != end; ++point) {
        const double here = height_px(point->value);
        if (const double way = std::abs(here - before); std::isfinite(way)) // no gap
            length_px += way;
        before = here;
    }
    return length_px > longest_px;
}

void SceneCurves::drawCurve(DrawnCurve &drawn, const std::vector<double> &edges) const
{
    if (drawn.dense && drawn.drawnEdges != edges) {
        const DrawnPoints points = drawn.samples->points(edges);
        drawn.graph->setData(toQt(points.x), toQt(points.y), true);
        drawn.enveloped = points.enveloped;
        drawn.drawnEdges = edges;
    }
    if (!drawn.markers)
        return;
    // Dashes and width need room: on an envelope or on noise they are unreadable, and slow.
    const QCPRange range = m_plot.xAxis->range();
    const Index count
        = drawn.samples->firstBeyond(range.upper) - drawn.samples->firstFrom(range.lower);
    const bool crowded
        = (isShot(drawn.curve->role) && count > m_plot.axisRect()->width() / kPixelsPerDash)
        || isEntangled(*drawn.graph);
    const RoleStyle style = m_theme.style(drawn.curve->role, drawn.curve->variant);
    QPen pen = drawn.graph->pen();
    pen.setStyle(drawn.enveloped || crowded ? Qt::SolidLine : style.dash);
    pen.setWidthF(drawn.enveloped || crowded ? m_theme.lineScale : style.width);
    drawn.graph->setPen(pen);
    drawMarkers(drawn);
}

void SceneCurves::drawMarkers(DrawnCurve &drawn) const
{
    const RoleStyle style = m_theme.style(drawn.curve->role, drawn.curve->variant);
    const QCPRange range = m_plot.xAxis->range();
    const Index begin = drawn.samples->firstFrom(range.lower);
    const Index count = drawn.samples->firstBeyond(range.upper) - begin;
    const bool wide = count < m_plot.axisRect()->width() / kPixelsPerDot;
    const bool everySample = drawn.curve->style == CurveStyle::LineAndDots
        || (wide && drawn.curve->role != CurveRole::Noise);
    QVector<double> x;
    QVector<double> y;
    const auto add = [&](Index first, Index samples) {
        const DrawnPoints some = drawn.samples->samples(first, first + samples);
        x += toQt(some.x);
        y += toQt(some.y);
    };
    if (everySample) {
        add(begin, count);
    } else if (hasMarkers(drawn.curve->role)) {
        // Each role begins elsewhere, so that markers of curves on each other do not coincide.
        const Index phase
            = (1 + 2 * static_cast<Index>(drawn.curve->role) + 3 * Index(drawn.curve->variant)) % 8;
        for (Index k = 0; k < kMarkersPerCurve; ++k)
            add(begin + (8 * k + phase) * count / (8 * kMarkersPerCurve), 1);
    }
    const bool plain = !hasMarkers(drawn.curve->role);
    drawn.markers->setData(x, y, true);
    drawn.markers->setScatterStyle(scatterStyle(
        plain ? MarkerShape::Dot : style.marker, style.color, plain ? kDotSize : kMarkerSize));
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/widget/overview_strip.h"

#include "ui/plot/values/curve_envelope.h"
#include "ui/plot/values/theme.h"
#include "ui/plot/widget/plot_widget.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr int kHeight_px = 40;
constexpr int kPadding_px = 3;
constexpr double kGrip_px = 5.0;
constexpr double kLeastBox_px = 4.0; ///< however little of the record is shown
constexpr double kLeastShare = 1e-9; ///< of the record that dragging an edge can leave

Interval finiteRange(const std::vector<PlotCurve> &curves, std::vector<double> PlotCurve::*values)
{
    std::optional<Interval> range;
    for (const PlotCurve &curve : curves)
        for (const double value : curve.*values)
            if (std::isfinite(value))
                range = range ? Interval{std::min(range->begin, value), std::max(range->end, value)}
                              : Interval{value, value};
    return range.value_or(Interval{0.0, 0.0});
}

} // namespace

OverviewStrip::OverviewStrip(QWidget *parent)
    : QWidget(parent)
{
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Overview of the recording"));
    setToolTip(tr(
        "The whole recording. Drag the box to move the view, its edges to zoom; double click shows everything."));
}

void OverviewStrip::follow(PlotWidget *plot)
{
    const bool first = m_plots.empty();
    m_plots.push_back(plot);
    connect(plot, &PlotWidget::xRangeChanged, this, &OverviewStrip::showX);
    connect(plot, &PlotWidget::contentChanged, this, [this, first] {
        if (first)
            takeContent();
        showX(m_plots.front()->xRange());
    });
    if (!first)
        return;
    connect(plot, &PlotWidget::replotted, this, [this] {
        if (area() != m_drawnArea)
            redraw();
    });
    takeContent();
}

void OverviewStrip::takeContent()
{
    const PlotContent &content = m_plots.front()->content();
    const Interval points = finiteRange(content.curves, &PlotCurve::x);
    // A first view may be of a part; one of a record that is still read goes beyond the points.
    m_whole = {std::min(points.begin, content.xMin.value_or(points.begin)),
        std::max(points.end, content.xMax.value_or(points.end))};
    redraw();
}

void OverviewStrip::redraw()
{
    m_picture = QPixmap();
    update();
}

QSize OverviewStrip::sizeHint() const
{
    return {200, kHeight_px};
}

QRect OverviewStrip::area() const
{
    if (m_plots.empty())
        return rect();
    const QRect axes = m_plots.front()->axesRect();
    const int left = mapFromGlobal(m_plots.front()->mapToGlobal(axes.topLeft())).x();
    return {left, kPadding_px, std::max(1, axes.width()), height() - 2 * kPadding_px};
}

double OverviewStrip::pixelOf(double x) const
{
    const QRect inside = area();
    const double length = m_whole.end - m_whole.begin;
    return inside.left() + (length > 0.0 ? (x - m_whole.begin) / length * inside.width() : 0.0);
}

double OverviewStrip::xAt(double pixel) const
{
    const QRect inside = area();
    return m_whole.begin + (pixel - inside.left()) / inside.width() * (m_whole.end - m_whole.begin);
}

QRectF OverviewStrip::box() const
{
    const QRect inside = area();
    if (m_plots.empty())
        return inside;
    const Interval shown = m_plots.front()->xRange();
    const double right = inside.left() + inside.width();
    double from = std::clamp<double>(pixelOf(shown.begin), inside.left(), right);
    double to = std::clamp<double>(pixelOf(shown.end), inside.left(), right);
    if (to - from < kLeastBox_px) {
        const double middle = std::clamp(0.5 * (from + to), inside.left() + 0.5 * kLeastBox_px,
            std::max(right - 0.5 * kLeastBox_px, inside.left() + 0.5 * kLeastBox_px));
        from = middle - 0.5 * kLeastBox_px;
        to = middle + 0.5 * kLeastBox_px;
    }
    return {
        from, static_cast<double>(inside.top()), to - from, static_cast<double>(inside.height())};
}

void OverviewStrip::drawCurve(QPainter &painter, const PlotCurve &curve, Interval y) const
{
    std::shared_ptr<const CurveSamples> samples = curve.record;
    if (!samples)
        samples = std::make_shared<CurveEnvelope>(curve.x, curve.y);
    const QRect inside = area();
    std::vector<double> edges;
    for (int column = 0; column <= inside.width(); ++column)
        edges.push_back(xAt(inside.left() + column));
    const DrawnPoints points = samples->points(edges);
    const double scale = y.end > y.begin ? (inside.height() - 1) / (y.end - y.begin) : 0.0;
    QPolygonF line;
    const auto draw = [&] {
        painter.drawPolyline(line);
        line.clear();
    };
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        if (std::isfinite(points.y[i]))
            line << QPointF(
                pixelOf(points.x[i]), inside.bottom() - (points.y[i] - y.begin) * scale);
        else
            draw(); // a gap
    }
    draw();
}

void OverviewStrip::paintEvent(QPaintEvent *)
{
    const PlotTheme theme = screenTheme(palette(), font());
    const QRect inside = area();
    if (m_picture.isNull() || m_drawnArea != inside) {
        m_drawnArea = inside;
        m_picture = QPixmap(size() * devicePixelRatioF());
        m_picture.setDevicePixelRatio(devicePixelRatioF());
        m_picture.fill(theme.background);
        QPainter painter(&m_picture);
        if (!m_plots.empty() && m_whole.end > m_whole.begin) {
            const std::vector<PlotCurve> &curves = m_plots.front()->content().curves;
            const Interval y = finiteRange(curves, &PlotCurve::y);
            for (const PlotCurve &curve : curves) {
                painter.setPen(QPen(theme.style(curve.role, curve.variant).color, 1.0));
                drawCurve(painter, curve, y);
            }
        }
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_picture);
    QColor veil = theme.background;
    veil.setAlphaF(0.65F);
    const QRectF shown = box();
    const QRectF all(inside);
    painter.fillRect(QRectF(all.left(), all.top(), shown.left() - all.left(), all.height()), veil);
    painter.fillRect(
        QRectF(shown.right(), all.top(), all.right() - shown.right(), all.height()), veil);
    painter.setPen(QPen(theme.axis, 1.0));
    painter.drawRect(all.adjusted(0.0, -1.0, 0.0, 0.0));
    painter.setPen(QPen(theme.handle, 2.0));
    painter.drawRect(shown.adjusted(1.0, 0.0, -1.0, -1.0));
}

void OverviewStrip::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    redraw();
}

void OverviewStrip::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        redraw();
}

OverviewStrip::Grip OverviewStrip::gripAt(double pixel) const
{
    const QRectF shown = box();
    const double toBegin = std::abs(pixel - shown.left());
    const double toEnd = std::abs(pixel - shown.right());
    // A narrow box can still be moved as a whole: its edges are then gripped from outside.
    const bool inside = pixel > shown.left() && pixel < shown.right();
    if (inside && shown.width() < 4.0 * kGrip_px)
        return Grip::Box;
    if (std::min(toBegin, toEnd) <= kGrip_px)
        return toBegin < toEnd ? Grip::Begin : Grip::End;
    return inside ? Grip::Box : Grip::None;
}

void OverviewStrip::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || m_plots.empty() || !(m_whole.end > m_whole.begin))
        return;
    const double pixel = event->position().x();
    m_before = m_plots.front()->xRange();
    m_grabbedAt = xAt(pixel);
    m_grip = gripAt(pixel);
    if (m_grip == Grip::None) { // move the box here
        m_grip = Grip::Box;
        const double half = 0.5 * (m_before.end - m_before.begin);
        m_before = {m_grabbedAt - half, m_grabbedAt + half};
        showX(m_before);
    }
}

void OverviewStrip::mouseMoveEvent(QMouseEvent *event)
{
    const double pixel = event->position().x();
    const double moved = xAt(pixel) - m_grabbedAt;
    const double least = kLeastShare * (m_whole.end - m_whole.begin);
    const Grip over = m_grip == Grip::None ? gripAt(pixel) : m_grip;
    setCursor(over == Grip::Begin || over == Grip::End ? Qt::SizeHorCursor
            : over == Grip::Box                        ? Qt::OpenHandCursor
                                                       : Qt::ArrowCursor);
    switch (m_grip) {
    case Grip::None:
        break;
    case Grip::Begin:
        showX({std::min(m_before.begin + moved, m_before.end - least), m_before.end});
        break;
    case Grip::End:
        showX({m_before.begin, std::max(m_before.end + moved, m_before.begin + least)});
        break;
    case Grip::Box:
        showX({m_before.begin + moved, m_before.end + moved});
        break;
    }
}

void OverviewStrip::mouseReleaseEvent(QMouseEvent *)
{
    m_grip = Grip::None;
}

void OverviewStrip::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && m_whole.end > m_whole.begin)
        showX(m_whole);
}

void OverviewStrip::showX(Interval x)
{
    for (PlotWidget *plot : m_plots)
        if (plot->xRange() != x)
            plot->setXRange(x);
    update();
}

} // namespace dyncal

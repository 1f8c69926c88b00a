// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_canvas.h"

#include "ui/plot/values/content_comparison.h"
#include "ui/plot/values/theme.h"

#include <cmath>

namespace dyncal {

namespace {

constexpr std::size_t kMostViews = 50;
constexpr double kDimming = 0.6;

bool sameAxis(const PlotAxis &a, const PlotAxis &b)
{
    return a.quantity == b.quantity && a.unit == b.unit && a.logarithmic == b.logarithmic;
}

} // namespace

QCPRange shiftedRange(const QCPAxis &axis, const QCPRange &range, double fraction)
{
    if (axis.scaleType() == QCPAxis::stLogarithmic) {
        const double factor = std::pow(range.upper / range.lower, fraction);
        return {range.lower * factor, range.upper * factor};
    }
    return {range.lower + fraction * range.size(), range.upper + fraction * range.size()};
}

PlotCanvas::PlotCanvas(QWidget &owner)
    : m_owner(owner)
    , m_plot(new QCustomPlot(&owner))
    , m_scene(*m_plot)
    , m_handles(*m_plot)
    , m_cursors(*m_plot)
{
    m_plot->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_scene.setBreaksText(true);
    m_plot->setPlottingHints(QCP::phFastPolylines | QCP::phCacheLabels);
    connect(m_plot, &QCustomPlot::afterReplot, this, [this] {
        m_isReplotQueued = false;
        emit replotted();
    });
    connect(m_plot->xAxis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), this,
        [this](const QCPRange &x) {
            emit xRangeChanged({x.lower, x.upper});
        });
}

void PlotCanvas::setContent(const PlotContent &content)
{
    const std::shared_ptr<const PlotContent> before = m_scene.sharedContent();
    const auto now = std::make_shared<const PlotContent>(content);
    if (m_scene.moveDecorations(now)) {
        if (!hasSameDecorations(*before, *now))
            replotDecorations();
        return;
    }
    m_scene.setContent(now);
    fitContent(*before);
    m_cursors.refresh(m_scene);
    emit cursorsChanged();
    replot();
}

void PlotCanvas::replot()
{
    m_isReplotQueued = true;
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::replotDecorations()
{
    if (m_isReplotQueued)
        return; // that replot draws them too
    m_scene.replotDecorations();
    emit replotted();
}

void PlotCanvas::applyTheme()
{
    PlotTheme theme = screenTheme(m_owner.palette(), m_owner.font());
    theme.fading = m_isDimmed ? kDimming : 0.0;
    m_scene.setTheme(theme);
    m_handles.setTheme(theme);
    m_cursors.refresh(m_scene);
    replot();
}

void PlotCanvas::setDimmed(bool dimmed)
{
    if (dimmed == m_isDimmed)
        return;
    m_isDimmed = dimmed;
    applyTheme();
}

void PlotCanvas::fitView()
{
    m_scene.fitX();
    m_scene.fitY();
}

void PlotCanvas::fitContent(const PlotContent &before)
{
    const PlotContent &now = m_scene.content();
    if (m_hasView && !m_scene.hasData() && sameAxis(now.xAxis, before.xAxis)
        && sameAxis(now.yAxis, before.yAxis))
        return; // a moment without curves (a model that diverges): the view waits for the next
    const View shown = view();
    const auto isFirst = [&](bool moved) { return before.growing ? !moved : !m_hasView; };
    if (isFirst(shown.x != m_fitted.x) || !sameAxis(now.xAxis, before.xAxis)) {
        const QSignalBlocker quiet(this);
        m_scene.fitX();
        m_fitted.x = m_plot->xAxis->range();
    }
    if (!m_hasView || isFirst(shown.y != m_fitted.y) || !sameAxis(now.yAxis, before.yAxis)) {
        m_scene.fitY();
        m_fitted.y = m_plot->yAxis->range();
    }
    m_hasView = m_scene.hasData();
}

void PlotCanvas::setView(const View &view)
{
    m_plot->xAxis->setRange(view.x);
    m_plot->yAxis->setRange(view.y);
    replot();
}

void PlotCanvas::remember()
{
    m_back.push_back(view());
    if (m_back.size() > kMostViews)
        m_back.erase(m_back.begin());
    m_forward.clear();
}

void PlotCanvas::goBack(bool forward)
{
    std::vector<View> &from = forward ? m_forward : m_back;
    std::vector<View> &to = forward ? m_back : m_forward;
    if (from.empty())
        return;
    to.push_back(view());
    const View target = from.back();
    from.pop_back();
    setView(target);
}

void PlotCanvas::pan(double xFraction, double yFraction)
{
    m_plot->xAxis->setRange(shiftedRange(*m_plot->xAxis, m_plot->xAxis->range(), xFraction));
    m_plot->yAxis->setRange(shiftedRange(*m_plot->yAxis, m_plot->yAxis->range(), yFraction));
    replot();
}

void PlotCanvas::zoomBy(double factor)
{
    remember();
    m_plot->xAxis->scaleRange(factor);
    if (m_scene.content().equalAspect)
        m_plot->yAxis->scaleRange(factor);
    replot();
}

void PlotCanvas::placeCursor(int which, const CurvePoint &point)
{
    m_cursors.place(which, point);
    m_cursors.refresh(m_scene);
    emit cursorsChanged();
    replot();
}

void PlotCanvas::moveCursor(int which, const CurvePoint &point)
{
    placeCursor(which, point);
    emit cursorPlaced(which, point.x);
}

void PlotCanvas::goTo(double x)
{
    remember();
    const double half = m_plot->xAxis->coordToPixel(x) - m_plot->axisRect()->rect().center().x();
    pan(half / std::max(1, m_plot->axisRect()->width()), 0.0);
    moveCursor(0, m_cursors.sampleAt(m_scene, x));
}

void PlotCanvas::clearCursors()
{
    m_cursors.clear();
    m_cursors.refresh(m_scene);
    emit cursorsChanged();
    replot();
}

void PlotCanvas::focusGrip(const std::optional<HandleGrip> &grip)
{
    m_focused = grip;
    m_handles.setFocus(grip);
    replot();
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_scene.h"

#include "ui/plot/qcp/qcp_ticker.h"
#include "ui/plot/values/axis_prefix.h"
#include "ui/plot/values/content_comparison.h"
#include "ui/text/broken_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

/// The right margin holds half of the last tick's label.
constexpr QMargins kLeastMargins(4, 6, 16, 4);
constexpr int kTickPadding = 3;

QSharedPointer<QCPAxisTicker> makeTicker(const PlotAxis &axis)
{
    if (axis.logarithmic)
        return QSharedPointer<DecadeTicker>::create(axis);
    return QSharedPointer<PrefixTicker>::create(axis);
}

/// Labels of marks stand at the top: the highest curve must not run through them.
double aboveData(const QCPRange &range, const PlotAxis &axis)
{
    constexpr double kLabelShare = 0.12;
    if (axis.logarithmic)
        return range.upper * std::pow(range.upper / range.lower, kLabelShare);
    return range.upper + kLabelShare * range.size();
}

} // namespace

PlotScene::PlotScene(QCustomPlot &plot)
    : m_plot(plot)
    , m_content(std::make_shared<const PlotContent>())
    , m_curves(plot)
    , m_legend(plot, m_curves)
    , m_decorations(plot)
{
    m_plot.setAutoAddPlottableToLegend(false);
    m_plot.setNoAntialiasingOnDrag(false);
    m_title = new QCPTextElement(&m_plot);
    m_title->setMargins(QMargins(0, 0, 0, 0));
    m_title->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    m_plot.plotLayout()->setRowSpacing(2);
    m_plot.axisRect()->setMinimumMargins(kLeastMargins);
    m_plot.axisRect()->setupFullAxesBox();
    for (QCPAxis *axis : {m_plot.xAxis, m_plot.yAxis, m_plot.yAxis2}) {
        axis->setLabelPadding(3);
        axis->setTickLabelPadding(kTickPadding);
        QObject::connect(axis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), &m_plot,
            [this, axis] { updateAxisLabel(axis); });
    }
    m_plot.xAxis2->setTicks(false);
    m_plot.xAxis2->setTickLabels(false);
    QObject::connect(&m_plot, &QCustomPlot::beforeReplot, &m_plot, [this] { prepare(); });
    QObject::connect(&m_plot, &QCustomPlot::afterLayout, &m_plot, [this] {
        m_curves.draw();
        m_decorations.placeLabels();
    });
}

void PlotScene::setContent(std::shared_ptr<const PlotContent> content)
{
    m_content = std::move(content);
    makeAxis(m_plot.xAxis, m_content->xAxis);
    makeAxis(m_plot.yAxis, m_content->yAxis);
    m_plot.yAxis2->setTicks(m_content->yAxis2.has_value());
    m_plot.yAxis2->setTickLabels(m_content->yAxis2.has_value());
    makeAxis(m_plot.yAxis2, m_content->yAxis2.value_or(PlotAxis()));
    m_plot.yAxis2->grid()->setSubGridVisible(false);
    m_title->setText(m_content->title);
    m_curves.make(m_content);
    if (m_content->yAxis2)
        m_plot.yAxis2->setRange(dataRange(DataAxis::SecondY));
    m_decorations.make(*m_content);
    m_legend.make();
    arrange();
    setTheme(m_theme);
}

bool PlotScene::moveDecorations(const std::shared_ptr<const PlotContent> &content)
{
    if (!isSameButDecorations(*m_content, *content))
        return false;
    m_content = content;
    m_decorations.move(*content);
    return true;
}

QCPRange PlotScene::dataRange(DataAxis axis) const
{
    return dyncal::dataRange(axis, *m_content, m_curves.all());
}

void PlotScene::makeAxis(QCPAxis *axis, const PlotAxis &meaning)
{
    axis->setScaleType(meaning.logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    axis->setTicker(makeTicker(meaning));
    axis->grid()->setSubGridVisible(meaning.logarithmic);
    axis->grid()->setZeroLinePen(Qt::NoPen);
    updateAxisLabel(axis);
}

void PlotScene::updateAxisLabel(QCPAxis *axis)
{
    const PlotAxis meaning = axis == m_plot.xAxis ? m_content->xAxis
        : axis == m_plot.yAxis                    ? m_content->yAxis
                                                  : m_content->yAxis2.value_or(PlotAxis());
    if (meaning.quantity.isEmpty()) {
        axis->setLabel({});
        return;
    }
    const QCPRange range = axis->range();
    const AxisPrefix prefix = prefixOf(meaning, range.lower, range.upper);
    const QFontMetrics metrics(m_theme.font);
    const int room
        = axis == m_plot.xAxis ? m_plot.axisRect()->width() : m_plot.axisRect()->height();
    QString label = axisLabel(meaning.quantity, meaning.unit, prefix);
    const int excess = metrics.horizontalAdvance(label) - room;
    if (excess > 0 && m_breaksText) {
        label = brokenText(metrics, label, room);
    } else if (excess > 0) { // the unit stays
        const int left = metrics.horizontalAdvance(meaning.quantity) - excess;
        label = axisLabel(
            metrics.elidedText(meaning.quantity, Qt::ElideRight, left), meaning.unit, prefix);
    }
    axis->setLabel(label);
}

void PlotScene::arrange()
{
    QCPLayoutGrid *grid = m_plot.plotLayout();
    QCPAxisRect *axes = m_plot.axisRect();
    const bool legendShown = m_legend.isShown();
    for (QCPLayoutElement *element :
        std::initializer_list<QCPLayoutElement *>{m_title, m_legend.row(), axes})
        if (element->layout())
            element->layout()->take(element);
    grid->simplify();
    int row = 0;
    m_title->setVisible(!m_content->title.isEmpty());
    m_plot.legend->setVisible(legendShown);
    if (m_title->visible())
        grid->addElement(row++, 0, m_title);
    if (legendShown) {
        grid->addElement(row, 0, m_legend.row());
        grid->setRowStretchFactor(row++, 0.001);
    }
    grid->addElement(row, 0, axes);
    grid->setRowStretchFactor(row, 1.0);
}

void PlotScene::keepDrawable()
{
    m_plot.xAxis->setRange(
        drawableRange(m_plot.xAxis->range(), m_homeX, m_content->xAxis.logarithmic));
    m_plot.yAxis->setRange(
        drawableRange(m_plot.yAxis->range(), m_homeY, m_content->yAxis.logarithmic));
}

void PlotScene::prepare()
{
    keepDrawable();
    if (m_breaksText)
        m_title->setText(
            brokenText(QFontMetrics(m_title->font()), m_content->title, m_plot.viewport().width()));
    m_legend.wrap(m_breaksText);
    updateLayout(); // the size of the axes is known only after it
    fitLabels();
    equaliseAspect();
}

void PlotScene::updateLayout()
{
    for (const auto phase :
        {QCPLayoutElement::upPreparation, QCPLayoutElement::upMargins, QCPLayoutElement::upLayout})
        m_plot.plotLayout()->update(phase);
}

/// As many ticks as have room for their labels, and no title longer than its axis.
void PlotScene::fitLabels()
{
    const QRect rect = m_plot.axisRect()->rect();
    const QFontMetrics metrics(m_theme.font);
    const int widest = metrics.horizontalAdvance(QStringLiteral("-0.000"));
    const auto ticks = [](int length, int each) { return std::clamp(length / each, 2, 5); };
    m_plot.xAxis->ticker()->setTickCount(ticks(rect.width(), 3 * widest / 2));
    m_plot.yAxis->ticker()->setTickCount(ticks(rect.height(), 2 * metrics.height()));
    m_plot.yAxis2->ticker()->setTickCount(ticks(rect.height(), 2 * metrics.height()));
    for (QCPAxis *axis : {m_plot.xAxis, m_plot.yAxis, m_plot.yAxis2}) {
        const auto decades = qSharedPointerDynamicCast<DecadeTicker>(axis->ticker());
        if (decades && m_breaksText)
            decades->setMostTicks(axis == m_plot.xAxis
                    ? rect.width() / (3 * widest / 2)
                    : rect.height() / (3 * metrics.height() / 2));
        updateAxisLabel(axis);
    }
}

void PlotScene::setLegendVisible(bool visible)
{
    m_legend.setWanted(visible);
    arrange();
}

void PlotScene::setCurveVisible(std::size_t position, bool visible)
{
    m_curves.setVisible(position, visible);
    m_legend.restyle();
}

void PlotScene::addTexts(std::vector<PlotText> &texts) const
{
    const auto add = [&](const QString &text, const QFont &font, const QRectF &room) {
        const QSizeF size = QFontMetricsF(font).size(0, text);
        const bool fits
            = size.width() < room.width() + 2.0 && QRectF(m_plot.viewport()).contains(room);
        texts.push_back({text, {room.topLeft(), size.boundedTo(room.size())}, fits});
    };
    if (m_title->visible())
        add(m_title->text(), m_title->font(), m_title->rect());
    for (int i = 0; m_plot.legend->visible() && i < m_plot.legend->itemCount(); ++i) {
        auto *entry = qobject_cast<QCPPlottableLegendItem *>(m_plot.legend->item(i));
        if (!entry)
            continue; // a place left free in the last row
        const int icon = m_plot.legend->iconSize().width() + m_plot.legend->iconTextPadding();
        add(entry->plottable()->name(), entry->font(), entry->rect().adjusted(icon, 0, 0, 0));
    }
    m_decorations.addTexts(texts);
}

void PlotScene::setTheme(const PlotTheme &theme)
{
    m_theme = theme;
    m_plot.setBackground(theme.background);
    for (QCPAxis *axis : {m_plot.xAxis, m_plot.yAxis, m_plot.xAxis2, m_plot.yAxis2}) {
        axis->setBasePen(QPen(theme.axis, 1));
        axis->setTickPen(QPen(theme.axis, 1));
        axis->setSubTickPen(QPen(theme.axis, 1));
        axis->setTickLabelColor(theme.text);
        axis->setLabelColor(theme.text);
        axis->setTickLabelFont(theme.font);
        axis->setLabelFont(theme.font);
        axis->grid()->setPen(QPen(theme.grid, 1));
        axis->grid()->setSubGridPen(QPen(theme.fineGrid, 1));
    }
    if (m_breaksText) { // large letters need more room around the corner of the axes
        const QFontMetrics metrics(theme.font);
        m_plot.axisRect()->setMinimumMargins(
            kLeastMargins | QMargins(0, metrics.height() / 2, 2 * metrics.averageCharWidth(), 0));
        m_plot.xAxis->setTickLabelPadding(std::max(kTickPadding, metrics.height() / 3));
    }
    QFont bold = theme.font;
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextColor(theme.text);
    m_curves.style(theme);
    m_decorations.style(theme);
    m_legend.style(theme);
}

void PlotScene::fitX()
{
    const QCPRange range = m_homeX = dataRange(DataAxis::X);
    m_plot.xAxis->setRange(
        m_content->xMin.value_or(range.lower), m_content->xMax.value_or(range.upper));
}

void PlotScene::fitY()
{
    QCPRange range = m_homeY = dataRange(DataAxis::Y);
    if (!m_content->marks.empty())
        range.upper = aboveData(range, m_content->yAxis);
    m_plot.yAxis->setRange(
        m_content->yMin.value_or(range.lower), m_content->yMax.value_or(range.upper));
}

void PlotScene::equaliseAspect()
{
    if (!m_content->equalAspect)
        return;
    const QRect rect = m_plot.axisRect()->rect();
    if (rect.width() < 10 || rect.height() < 10)
        return;
    const double perPixelX = m_plot.xAxis->range().size() / rect.width();
    const double perPixelY = m_plot.yAxis->range().size() / rect.height();
    const auto widen = [](QCPAxis *axis, double size) {
        const double centre = axis->range().center();
        axis->setRange(centre - 0.5 * size, centre + 0.5 * size);
    };
    // The slack ends the mutual widening that rounding would otherwise keep going.
    if (perPixelX > perPixelY * (1.0 + 1e-6))
        widen(m_plot.yAxis, perPixelX * rect.height());
    else if (perPixelY > perPixelX * (1.0 + 1e-6))
        widen(m_plot.xAxis, perPixelY * rect.width());
}

} // namespace dyncal

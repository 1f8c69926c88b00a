// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp_scene.h"

#include "ui/plot/axis_prefix.h"
#include "ui/plot/qcp_ticker.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dyncal {

namespace {

constexpr int kLegendIconWidth = 26;
constexpr int kLegendPadding = 4;
constexpr int kLegendGap = 14;
constexpr int kLegendDescent = 2; ///< pixels; without, items end where the tail of a g begins
/// Right: half of the last tick's label.
constexpr QMargins kLeastMargins(4, 6, 16, 4);

QSharedPointer<QCPAxisTicker> makeTicker(const PlotAxis &axis)
{
    if (axis.logarithmic)
        return QSharedPointer<DecadeTicker>::create(axis);
    return QSharedPointer<PrefixTicker>::create(axis);
}

QCPRange widened(QCPRange range, const PlotAxis &axis, double margin)
{
    if (axis.logarithmic) {
        const double factor
            = range.upper > range.lower ? std::pow(range.upper / range.lower, margin) : 3.0;
        return {range.lower / factor, range.upper * factor};
    }
    double extra = margin * range.size();
    if (!(range.size() > 0.0))
        extra = range.lower == 0.0 ? 1.0 : 0.1 * std::abs(range.lower);
    return {range.lower - extra, range.upper + extra};
}

/// Labels of marks stand at the top: the highest curve must not run through them.
double aboveData(const QCPRange &range, const PlotAxis &axis)
{
    constexpr double kLabelShare = 0.12;
    if (axis.logarithmic)
        return range.upper * std::pow(range.upper / range.lower, kLabelShare);
    return range.upper + kLabelShare * range.size();
}

/// As many columns as fit beside each other, filled row by row.
int columnsThatFit(const std::vector<int> &widths, int room)
{
    int columns = std::max(1, static_cast<int>(widths.size()));
    for (; columns > 1; --columns) {
        std::vector<int> widest(static_cast<std::size_t>(columns), 0);
        for (std::size_t i = 0; i < widths.size(); ++i) {
            int &column = widest[i % widest.size()];
            column = std::max(column, widths[i]);
        }
        const int gaps = (columns - 1) * kLegendGap;
        if (std::accumulate(widest.begin(), widest.end(), gaps) <= room)
            break;
    }
    return columns;
}

bool hasMargin(const PlotCurve &curve)
{
    return curve.style == CurveStyle::Markers || curve.style == CurveStyle::Dots
        || curve.style == CurveStyle::Bars || curve.style == CurveStyle::Stems;
}

} // namespace

PlotScene::PlotScene(QCustomPlot &plot)
    : m_plot(plot)
    , m_content(std::make_shared<const PlotContent>())
{
    m_plot.setAutoAddPlottableToLegend(false);
    m_plot.setNoAntialiasingOnDrag(false);
    m_plot.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    m_plot.legend->setMargins(QMargins(0, 0, 0, 0));
    m_plot.legend->setRowSpacing(0);
    m_plot.legend->setColumnSpacing(kLegendGap);
    m_plot.legend->setIconSize(kLegendIconWidth, 12);
    m_plot.legend->setIconTextPadding(kLegendPadding);
    m_plot.legend->setLayer("legend");
    m_title = new QCPTextElement(&m_plot);
    m_title->setMargins(QMargins(0, 0, 0, 0));
    m_title->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    m_legendRow = new QCPLayoutGrid;
    m_plot.plotLayout()->addElement(1, 0, m_legendRow); // a row needs its plot before elements
    m_legendRow->addElement(0, 0, m_plot.legend);
    m_legendRow->expandTo(1, 2);
    m_legendRow->setColumnStretchFactor(0, 0.001);
    m_plot.plotLayout()->setRowSpacing(2);
    m_plot.axisRect()->setMinimumMargins(kLeastMargins);
    m_plot.axisRect()->setupFullAxesBox();
    for (QCPAxis *axis : {m_plot.xAxis, m_plot.yAxis, m_plot.yAxis2}) {
        axis->setLabelPadding(3);
        axis->setTickLabelPadding(3);
        QObject::connect(axis, qOverload<const QCPRange &>(&QCPAxis::rangeChanged), &m_plot,
            [this, axis] { updateAxisLabel(axis); });
    }
    m_plot.addLayer(QStringLiteral("decorations"), m_plot.layer(QStringLiteral("main")));
    m_decorationLayer = m_plot.layer(QStringLiteral("decorations"));
    m_decorationLayer->setMode(QCPLayer::lmBuffered);
    m_plot.xAxis2->setTicks(false);
    m_plot.xAxis2->setTickLabels(false);
    QObject::connect(&m_plot, &QCustomPlot::beforeReplot, &m_plot, [this] { prepare(); });
    QObject::connect(&m_plot, &QCustomPlot::afterLayout, &m_plot, [this] { drawView(); });
}

void PlotScene::setContent(std::shared_ptr<const PlotContent> content)
{
    m_content = m_drawnContent = std::move(content);
    makeAxis(m_plot.xAxis, m_content->xAxis);
    makeAxis(m_plot.yAxis, m_content->yAxis);
    m_plot.yAxis2->setTicks(m_content->yAxis2.has_value());
    m_plot.yAxis2->setTickLabels(m_content->yAxis2.has_value());
    makeAxis(m_plot.yAxis2, m_content->yAxis2.value_or(PlotAxis()));
    m_plot.yAxis2->grid()->setSubGridVisible(false);
    m_title->setText(m_content->title);
    makeCurves();
    if (m_content->yAxis2)
        m_plot.yAxis2->setRange(dataRange(m_plot.yAxis2));
    makeDecorations();
    makeLegend();
    setTheme(m_theme);
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
    // Decades carry their own prefix ("10 k"), so the label of a logarithmic axis has none.
    const AxisPrefix prefix
        = meaning.logarithmic ? AxisPrefix{} : axisPrefix(range.lower, range.upper, meaning.unit);
    const QFontMetrics metrics(m_theme.font);
    const int room
        = axis == m_plot.xAxis ? m_plot.axisRect()->width() : m_plot.axisRect()->height();
    QString label = axisLabel(meaning.quantity, meaning.unit, prefix);
    const int excess = metrics.horizontalAdvance(label) - room;
    if (excess > 0) { // the unit stays
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
    const auto inLegend = std::count_if(m_curves.begin(), m_curves.end(),
        [](const DrawnCurve &c) { return c.curve->inLegend && !c.curve->name.isEmpty(); });
    const bool legendShown = m_legendVisible && inLegend > 1;
    for (QCPLayoutElement *element :
        std::initializer_list<QCPLayoutElement *>{m_title, m_legendRow, axes})
        if (element->layout())
            element->layout()->take(element);
    grid->simplify();
    int row = 0;
    m_title->setVisible(!m_content->title.isEmpty());
    m_plot.legend->setVisible(legendShown);
    if (m_title->visible())
        grid->addElement(row++, 0, m_title);
    if (legendShown) {
        grid->addElement(row, 0, m_legendRow);
        grid->setRowStretchFactor(row++, 0.001);
    }
    grid->addElement(row, 0, axes);
    grid->setRowStretchFactor(row, 1.0);
}

void PlotScene::makeLegend()
{
    m_plot.legend->clearItems();
    for (const DrawnCurve &drawn : m_curves)
        if (drawn.curve->inLegend && !drawn.curve->name.isEmpty())
            drawn.plottable()->addToLegend();
    m_legendWrap = 0;
    styleLegend();
    arrange();
}

void PlotScene::styleLegend()
{
    for (const DrawnCurve &drawn : m_curves) {
        QCPPlottableLegendItem *item = m_plot.legend->itemWithPlottable(drawn.plottable());
        if (!item)
            continue;
        QFont font = m_theme.font;
        font.setStrikeOut(!drawn.visible);
        item->setFont(font);
        item->setMargins(QMargins(0, 0, 0, kLegendDescent));
        item->setTextColor(m_theme.text);
    }
}

void PlotScene::wrapLegend()
{
    const QFontMetrics metrics(m_theme.font);
    std::vector<int> widths;
    for (const DrawnCurve &drawn : m_curves)
        if (drawn.curve->inLegend && !drawn.curve->name.isEmpty())
            widths.push_back(metrics.horizontalAdvance(drawn.curve->name) + kLegendIconWidth
                + 2 * kLegendPadding);
    const int wrap = columnsThatFit(widths, m_plot.viewport().width());
    if (wrap == m_legendWrap)
        return;
    m_legendWrap = wrap;
    m_plot.legend->setWrap(wrap);
    m_plot.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

void PlotScene::prepare()
{
    wrapLegend();
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
    for (QCPAxis *axis : {m_plot.xAxis, m_plot.yAxis, m_plot.yAxis2})
        updateAxisLabel(axis);
}

void PlotScene::setLegendVisible(bool visible)
{
    m_legendVisible = visible;
    arrange();
}

std::optional<std::size_t> PlotScene::legendEntryAt(const QPointF &position) const
{
    if (!m_plot.legend->visible())
        return std::nullopt;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const QCPPlottableLegendItem *item
            = m_plot.legend->itemWithPlottable(m_curves[i].plottable());
        if (item && item->outerRect().contains(position.toPoint()))
            return i;
    }
    return std::nullopt;
}

void PlotScene::setCurveVisible(std::size_t position, bool visible)
{
    const QString name = m_curves[position].curve->name;
    for (DrawnCurve &drawn : m_curves) { // one entry may stand for several curves
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
    styleLegend();
}

void PlotScene::setTheme(const PlotTheme &theme)
{
    m_theme = theme;
    m_legendWrap = 0; // the font may be wider now
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
    QFont bold = theme.font;
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextColor(theme.text);
    m_plot.legend->setBrush(Qt::NoBrush);
    m_plot.legend->setBorderPen(Qt::NoPen);
    for (DrawnCurve &drawn : m_curves)
        styleCurve(drawn);
    styleDecorations();
    styleLegend();
}

bool PlotScene::hasData() const
{
    return std::any_of(m_curves.begin(), m_curves.end(),
        [](const DrawnCurve &drawn) { return !drawn.x().empty(); });
}

QCPRange PlotScene::dataRange(const QCPAxis *of) const
{
    const bool alongX = of == m_plot.xAxis;
    const bool second = of == m_plot.yAxis2;
    const PlotAxis axis = alongX ? m_content->xAxis
        : second                 ? m_content->yAxis2.value_or(PlotAxis())
                                 : m_content->yAxis;
    bool any = false;
    bool margin = !alongX;
    QCPRange range(0.0, 0.0);
    const auto include = [&](double value) {
        if (!std::isfinite(value) || (axis.logarithmic && !(value > 0.0)))
            return;
        range.lower = any ? std::min(range.lower, value) : value;
        range.upper = any ? std::max(range.upper, value) : value;
        any = true;
    };
    for (const DrawnCurve &drawn : m_curves) {
        if (!drawn.visible || (!alongX && drawn.curve->onSecondAxis != second))
            continue;
        for (const double value : alongX ? drawn.x() : drawn.y())
            include(value);
        if (drawn.bars && !alongX)
            include(0.0);
        margin = margin || hasMargin(*drawn.curve);
    }
    if (any && !alongX && !second)
        for (const PlotLevel &level : m_content->levels)
            include(level.y);
    if (m_content->unitCircle && !second) {
        include(-1.0);
        include(1.0);
    }
    if (!any)
        return axis.logarithmic ? QCPRange(1.0, 10.0) : QCPRange(0.0, 1.0);
    const bool single = !(range.upper > range.lower);
    return widened(range, axis, margin || single ? 0.05 : 0.0);
}

void PlotScene::fitX()
{
    const QCPRange range = dataRange(m_plot.xAxis);
    m_plot.xAxis->setRange(
        m_content->xMin.value_or(range.lower), m_content->xMax.value_or(range.upper));
}

void PlotScene::fitY()
{
    QCPRange range = dataRange(m_plot.yAxis);
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

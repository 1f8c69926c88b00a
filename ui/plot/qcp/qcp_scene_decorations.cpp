// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_scene_decorations.h"

#include "ui/plot/qcp/qcp_damping_grid.h"

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kLabelGap_px = 6;
constexpr int kMarkRows = 4;

} // namespace

SceneDecorations::SceneDecorations(QCustomPlot &plot)
    : m_plot(plot)
{
    m_plot.addLayer(QStringLiteral("decorations"), m_plot.layer(QStringLiteral("main")));
    m_layer = m_plot.layer(QStringLiteral("decorations"));
    m_layer->setMode(QCPLayer::lmBuffered);
}

void SceneDecorations::make(const PlotContent &content)
{
    for (const Decoration &decoration : m_decorations) {
        m_plot.removeItem(decoration.line);
        m_plot.removeItem(decoration.label);
        if (decoration.band)
            m_plot.removeItem(decoration.band);
    }
    m_decorations.clear();
    if (m_unitCircle)
        m_plot.removeItem(m_unitCircle);
    m_unitCircle = nullptr;
    if (content.unitCircle) {
        m_unitCircle = new QCPItemEllipse(&m_plot);
        m_unitCircle->topLeft->setCoords(-1.0, 1.0);
        m_unitCircle->bottomRight->setCoords(1.0, -1.0);
        m_unitCircle->setSelectable(false);
    }
    if (m_dampingGrid)
        m_plot.removeItem(m_dampingGrid);
    m_dampingGrid = content.dampingGridRate_Hz
        ? new DampingGrid(&m_plot, *content.dampingGridRate_Hz)
        : nullptr;
    setGridVisible(m_gridVisible);
    for (const PlotLevel &level : content.levels)
        makeLevel(level);
    for (const PlotMark &mark : content.marks)
        makeMark(mark);
    std::stable_sort(
        m_decorations.begin(), m_decorations.end(), [](const Decoration &a, const Decoration &b) {
            return a.markX.value_or(0.0) < b.markX.value_or(0.0);
        });
    for (const Decoration &decoration : m_decorations)
        decoration.line->setLayer(m_layer);
    for (const Decoration &decoration : m_decorations) // no label under a neighbour's line
        decoration.label->setLayer(m_layer);
}

void SceneDecorations::move(const PlotContent &content)
{
    // The items stay: one more or less would have the whole plot drawn again.
    std::vector<PlotMark> marks = content.marks;
    std::ranges::stable_sort(marks, {}, &PlotMark::x);
    auto mark = marks.begin();
    auto level = content.levels.begin();
    for (Decoration &decoration : m_decorations) {
        if (decoration.markX)
            placeMark(decoration, *mark++);
        else
            placeLevel(decoration, *level++);
    }
    restyle();
    placeLabels();
}

void SceneDecorations::makeMark(const PlotMark &mark)
{
    auto *line = new QCPItemLine(&m_plot);
    for (QCPItemPosition *position : {line->start, line->end}) {
        position->setTypeX(QCPItemPosition::ptPlotCoords);
        position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    auto *label = new PlotLabel(&m_plot);
    label->position->setTypeX(QCPItemPosition::ptPlotCoords);
    label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    label->setPadding(QMargins(3, 1, 1, 0));
    placeMark(
        m_decorations.emplace_back(Decoration{line, label, mark.role, mark.x, 0.0, nullptr}), mark);
}

void SceneDecorations::placeMark(Decoration &decoration, const PlotMark &mark)
{
    decoration.line->start->setCoords(mark.x, 0.0);
    decoration.line->end->setCoords(mark.x, 1.0);
    decoration.label->position->setCoords(mark.x, 0.0);
    decoration.label->setText(mark.label);
    decoration.role = mark.role;
    decoration.markX = mark.x;
}

void SceneDecorations::makeLevel(const PlotLevel &level)
{
    auto *line = new QCPItemLine(&m_plot);
    for (QCPItemPosition *position : {line->start, line->end}) {
        position->setTypeX(QCPItemPosition::ptAxisRectRatio);
        position->setTypeY(QCPItemPosition::ptPlotCoords);
    }
    auto *label = new PlotLabel(&m_plot);
    label->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    label->position->setTypeY(QCPItemPosition::ptPlotCoords);
    label->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
    label->setPadding(QMargins(1, 0, 3, 1));
    placeLevel(m_decorations.emplace_back(
                   Decoration{line, label, level.role, std::nullopt, level.y, makeBand(level)}),
        level);
}

void SceneDecorations::placeLevel(Decoration &decoration, const PlotLevel &level)
{
    decoration.line->start->setCoords(0.0, level.y);
    decoration.line->end->setCoords(1.0, level.y);
    decoration.label->position->setCoords(1.0, level.y);
    decoration.label->setText(level.label);
    decoration.role = level.role;
    decoration.levelY = level.y;
}

QCPItemRect *SceneDecorations::makeBand(const PlotLevel &level)
{
    if (!level.from)
        return nullptr;
    auto *band = new QCPItemRect(&m_plot);
    for (QCPItemPosition *position : {band->topLeft, band->bottomRight}) {
        position->setTypeX(QCPItemPosition::ptAxisRectRatio);
        position->setTypeY(QCPItemPosition::ptPlotCoords);
    }
    band->topLeft->setCoords(0.0, level.y);
    band->bottomRight->setCoords(1.0, *level.from);
    band->setLayer("background");
    band->setSelectable(false);
    return band;
}

void SceneDecorations::setGridVisible(bool visible)
{
    m_gridVisible = visible;
    for (QCPAxis *axis : {m_plot.xAxis, m_plot.yAxis})
        axis->grid()->setVisible(visible && !m_dampingGrid);
    if (m_dampingGrid)
        m_dampingGrid->setVisible(visible);
}

void SceneDecorations::addTexts(std::vector<PlotText> &texts) const
{
    if (m_dampingGrid && m_gridVisible)
        texts.insert(texts.end(), m_dampingGrid->texts().begin(), m_dampingGrid->texts().end());
}

void SceneDecorations::style(const PlotTheme &theme)
{
    m_theme = theme;
    restyle();
}

void SceneDecorations::restyle()
{
    for (const Decoration &decoration : m_decorations) {
        const RoleStyle style = m_theme.style(decoration.role);
        const QPen pen(style.color, 1.0, style.dash == Qt::SolidLine ? Qt::DashLine : style.dash);
        decoration.line->setPen(pen);
        decoration.line->setSelectable(false);
        decoration.label->setSelectable(false);
        decoration.label->setColor(m_theme.text);
        decoration.label->setRim(m_theme.background);
        decoration.label->setFont(m_theme.font);
        decoration.label->setVisible(!decoration.label->text().isEmpty());
        if (decoration.band) {
            decoration.band->setPen(Qt::NoPen);
            decoration.band->setBrush(m_theme.bandFill);
        }
    }
    if (m_dampingGrid)
        m_dampingGrid->setTheme(m_theme);
    if (m_unitCircle)
        m_unitCircle->setPen(QPen(m_theme.axis, 1.0, Qt::DashLine));
}

void SceneDecorations::placeLabels()
{
    std::vector<QRectF> taken = othersLabels();
    staggerMarks(taken);
    for (const Decoration &decoration : m_decorations)
        if (!decoration.markX && !decoration.label->text().isEmpty())
            placeLevelLabel(decoration, taken);
}

/// Of handles and cursors.
std::vector<QRectF> SceneDecorations::othersLabels() const
{
    std::vector<QRectF> taken;
    for (int i = 0; i < m_plot.itemCount(); ++i) {
        const auto *text = qobject_cast<const QCPItemText *>(m_plot.item(i));
        const bool isOwn
            = std::ranges::find(m_decorations, text, &Decoration::label) != m_decorations.end();
        if (text && !isOwn && text->visible() && !text->text().isEmpty())
            taken.push_back(
                QRectF(text->topLeft->pixelPosition(), text->bottomRight->pixelPosition())
                    .marginsRemoved(QMarginsF(text->padding())));
    }
    return taken;
}

/// Labels of marks that lie close go further down, so that they stay readable; one that finds no
/// place is left out, as are those of marks out of view.
void SceneDecorations::staggerMarks(std::vector<QRectF> &taken)
{
    const QFontMetrics metrics(m_theme.font);
    const QRectF rect = m_plot.axisRect()->rect();
    if (!(rect.height() > 0.0))
        return;
    const auto rows = std::max(kMarkRows, static_cast<int>(rect.height() / metrics.height()));
    for (const Decoration &decoration : m_decorations) {
        if (!decoration.markX)
            continue;
        const double left = m_plot.xAxis->coordToPixel(*decoration.markX);
        const double width = metrics.horizontalAdvance(decoration.label->text()) + kLabelGap_px;
        const bool flip = left + width > rect.right() && left - width >= rect.left();
        // Where neither side has room, it stands across its line.
        const bool across = !flip && left + width > rect.right();
        const double begin = flip ? left - width : across ? rect.right() - width : left;
        QRectF place(begin, rect.top(), width, metrics.height());
        const auto isFree = [&](const QRectF &at) {
            return std::ranges::none_of(
                taken, [&](const QRectF &other) { return at.intersects(other); });
        };
        int row = 0;
        while (row < rows && !isFree(place.translated(0.0, row * metrics.height())))
            ++row;
        place.translate(0.0, row * metrics.height());
        decoration.label->setVisible(!decoration.label->text().isEmpty() && row < rows
            && rect.left() <= place.left() && rect.left() <= left && left <= rect.right() + 1.0);
        if (!decoration.label->visible())
            continue;
        decoration.label->setPositionAlignment(
            (flip ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignTop);
        decoration.label->position->setCoords(
            across ? m_plot.xAxis->pixelToCoord(begin) : *decoration.markX,
            (place.top() - rect.top()) / rect.height());
        taken.push_back(place);
    }
}

/// At the right end above its line, else where it neither leaves the axes nor lies on another; left
/// out where there is no such place.
void SceneDecorations::placeLevelLabel(const Decoration &decoration, std::vector<QRectF> &taken)
{
    const QRectF rect = m_plot.axisRect()->rect();
    const QFontMetrics metrics(m_theme.font);
    const QSizeF size(
        metrics.horizontalAdvance(decoration.label->text()) + kLabelGap_px, metrics.height() + 1);
    const double y = m_plot.yAxis->coordToPixel(decoration.levelY);
    const auto isFree = [&](const QRectF &place) {
        return rect.left() <= place.left() && place.right() <= rect.right()
            && rect.top() <= place.top() && place.bottom() <= rect.bottom()
            && std::none_of(taken.begin(), taken.end(),
                [&](const QRectF &other) { return place.intersects(other); });
    };
    decoration.label->setVisible(false);
    for (const double share : {1.0, 0.0, 0.25, 0.5, 0.75}) // of the room beside the label
        for (const bool above : {true, false}) {
            const QRectF place({rect.left() + share * (rect.width() - size.width()),
                                   above ? y - size.height() : y},
                size);
            if (!isFree(place))
                continue;
            const bool right = share == 1.0;
            const double x
                = right ? 1.0 : (place.left() - rect.left()) / std::max(1.0, rect.width());
            decoration.label->setVisible(true);
            decoration.label->position->setCoords(x, decoration.levelY);
            decoration.label->setPositionAlignment((right ? Qt::AlignRight : Qt::AlignLeft)
                | (above ? Qt::AlignBottom : Qt::AlignTop));
            taken.push_back(place);
            return;
        }
}

} // namespace dyncal

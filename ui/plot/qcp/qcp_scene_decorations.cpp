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
    for (const Decoration &decoration : m_decorations) {
        decoration.line->setLayer(m_layer);
        decoration.label->setLayer(m_layer);
    }
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
    auto *label = new QCPItemText(&m_plot);
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
    auto *label = new QCPItemText(&m_plot);
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
    std::vector<QRectF> taken;
    staggerMarks(taken);
    for (const Decoration &decoration : m_decorations)
        if (!decoration.markX && decoration.label->visible())
            placeLevelLabel(decoration, taken);
}

/// Labels of marks that lie close go one row down, so that they stay readable.
void SceneDecorations::staggerMarks(std::vector<QRectF> &taken)
{
    const QFontMetrics metrics(m_theme.font);
    const QRect rect = m_plot.axisRect()->rect();
    const double height = rect.height();
    if (!(height > 0.0))
        return;
    std::vector<double> rowEnds(kMarkRows, -1e9);
    for (const Decoration &decoration : m_decorations) {
        if (!decoration.markX)
            continue;
        const double left = m_plot.xAxis->coordToPixel(*decoration.markX);
        const double width = metrics.horizontalAdvance(decoration.label->text()) + kLabelGap_px;
        const bool flip = left + width > rect.right();
        const double from = flip ? left - width : left;
        const auto row = std::find_if(
            rowEnds.begin(), rowEnds.end(), [from](double end) { return from > end; });
        const auto place = row == rowEnds.end() ? rowEnds.begin() : row;
        *place = from + width;
        const auto top = static_cast<double>((place - rowEnds.begin()) * metrics.height());
        decoration.label->setPositionAlignment(
            (flip ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignTop);
        decoration.label->position->setCoords(*decoration.markX, top / height);
        taken.emplace_back(from, rect.top() + top, width, metrics.height());
    }
}

/// At the right end above its line, else where it neither leaves the axes nor lies on another.
void SceneDecorations::placeLevelLabel(const Decoration &decoration, std::vector<QRectF> &taken)
{
    const QRectF rect = m_plot.axisRect()->rect();
    const QFontMetrics metrics(m_theme.font);
    const QSizeF size(
        metrics.horizontalAdvance(decoration.label->text()) + kLabelGap_px, metrics.height() + 1);
    const double y = m_plot.yAxis->coordToPixel(decoration.levelY);
    const auto rectAt = [&](bool right, bool above) {
        return QRectF(
            {right ? rect.right() - size.width() : rect.left(), above ? y - size.height() : y},
            size);
    };
    const auto isFree = [&](const QRectF &place) {
        return rect.top() <= place.top() && place.bottom() <= rect.bottom()
            && std::none_of(taken.begin(), taken.end(),
                [&](const QRectF &other) { return place.intersects(other); });
    };
    bool right = true;
    bool above = true;
    for (const auto &[tryRight, tryAbove] :
        {std::pair(true, true), {true, false}, {false, true}, {false, false}}) {
        if (!isFree(rectAt(tryRight, tryAbove)))
            continue;
        right = tryRight;
        above = tryAbove;
        break;
    }
    taken.push_back(rectAt(right, above));
    decoration.label->position->setCoords(right ? 1.0 : 0.0, decoration.levelY);
    decoration.label->setPositionAlignment(
        (right ? Qt::AlignRight : Qt::AlignLeft) | (above ? Qt::AlignBottom : Qt::AlignTop));
}

} // namespace dyncal

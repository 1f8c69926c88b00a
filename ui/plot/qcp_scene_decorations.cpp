// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp_scene.h"

#include <algorithm>
#include <cstring>

namespace dyncal {

namespace {

constexpr int kLabelGap_px = 6;
constexpr int kMarkRows = 4;

bool isSame(const PlotAxis &a, const PlotAxis &b)
{
    return a.quantity == b.quantity && a.unit == b.unit && a.logarithmic == b.logarithmic
        && a.integers == b.integers;
}

/// To the bit: a gap (NaN) is the same as a gap.
bool isSame(const std::vector<double> &a, const std::vector<double> &b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool isSame(const PlotCurve &a, const PlotCurve &b)
{
    return a.name == b.name && a.role == b.role && a.style == b.style && a.inLegend == b.inLegend
        && a.record == b.record && a.onSecondAxis == b.onSecondAxis && isSame(a.x, b.x)
        && isSame(a.y, b.y);
}

bool isSameButDecorations(const PlotContent &a, const PlotContent &b)
{
    const bool sameSecond = a.yAxis2.has_value() == b.yAxis2.has_value()
        && (!a.yAxis2 || isSame(*a.yAxis2, *b.yAxis2));
    return a.title == b.title && isSame(a.xAxis, b.xAxis) && isSame(a.yAxis, b.yAxis) && sameSecond
        && a.equalAspect == b.equalAspect && a.unitCircle == b.unitCircle && a.xMin == b.xMin
        && a.xMax == b.xMax && a.yMin == b.yMin && a.yMax == b.yMax && a.growing == b.growing
        && a.marks.size() == b.marks.size() && a.levels.size() == b.levels.size()
        && std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
            [](const PlotCurve &x, const PlotCurve &y) { return isSame(x, y); });
}

} // namespace

void PlotScene::makeDecorations()
{
    for (const Decoration &decoration : m_decorations) {
        m_plot.removeItem(decoration.line);
        m_plot.removeItem(decoration.label);
    }
    m_decorations.clear();
    if (m_unitCircle)
        m_plot.removeItem(m_unitCircle);
    m_unitCircle = nullptr;
    if (m_content->unitCircle) {
        m_unitCircle = new QCPItemEllipse(&m_plot);
        m_unitCircle->topLeft->setCoords(-1.0, 1.0);
        m_unitCircle->bottomRight->setCoords(1.0, -1.0);
        m_unitCircle->setSelectable(false);
    }
    for (const PlotLevel &level : m_content->levels)
        makeLevel(level);
    for (const PlotMark &mark : m_content->marks)
        makeMark(mark);
    std::stable_sort(
        m_decorations.begin(), m_decorations.end(), [](const Decoration &a, const Decoration &b) {
            return a.markX.value_or(0.0) < b.markX.value_or(0.0);
        });
    for (const Decoration &decoration : m_decorations) {
        decoration.line->setLayer(m_decorationLayer);
        decoration.label->setLayer(m_decorationLayer);
    }
}

bool PlotScene::moveDecorations(const std::shared_ptr<const PlotContent> &content)
{
    if (!isSameButDecorations(*m_content, *content))
        return false;
    m_content = content;
    // The items stay: one more or less would have the whole plot drawn again.
    std::vector<PlotMark> marks = content->marks;
    std::ranges::stable_sort(marks, {}, &PlotMark::x);
    auto mark = marks.begin();
    auto level = content->levels.begin();
    for (Decoration &decoration : m_decorations) {
        if (decoration.markX)
            placeMark(decoration, *mark++);
        else
            placeLevel(decoration, *level++);
    }
    styleDecorations();
    staggerMarks();
    return true;
}

void PlotScene::makeMark(const PlotMark &mark)
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
    placeMark(m_decorations.emplace_back(Decoration{line, label, mark.role, mark.x}), mark);
}

void PlotScene::placeMark(Decoration &decoration, const PlotMark &mark)
{
    decoration.line->start->setCoords(mark.x, 0.0);
    decoration.line->end->setCoords(mark.x, 1.0);
    decoration.label->position->setCoords(mark.x, 0.0);
    decoration.label->setText(mark.label);
    decoration.role = mark.role;
    decoration.markX = mark.x;
}

void PlotScene::makeLevel(const PlotLevel &level)
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
    placeLevel(
        m_decorations.emplace_back(Decoration{line, label, level.role, std::nullopt}), level);
}

void PlotScene::placeLevel(Decoration &decoration, const PlotLevel &level)
{
    decoration.line->start->setCoords(0.0, level.y);
    decoration.line->end->setCoords(1.0, level.y);
    decoration.label->position->setCoords(1.0, level.y);
    decoration.label->setText(level.label);
    decoration.role = level.role;
}

void PlotScene::styleDecorations()
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
    }
    if (m_unitCircle)
        m_unitCircle->setPen(QPen(m_theme.axis, 1.0, Qt::DashLine));
}

void PlotScene::staggerMarks()
{
    // Labels of marks that lie close go one row down, so that they stay readable.
    const QFontMetrics metrics(m_theme.font);
    const double height = m_plot.axisRect()->height();
    if (!(height > 0.0))
        return;
    std::vector<double> rowEnds(kMarkRows, -1e9);
    for (const Decoration &decoration : m_decorations) {
        if (!decoration.markX)
            continue;
        const double left = m_plot.xAxis->coordToPixel(*decoration.markX);
        const double width = metrics.horizontalAdvance(decoration.label->text()) + kLabelGap_px;
        const bool flip = left + width > m_plot.axisRect()->right();
        const double from = flip ? left - width : left;
        const auto row = std::find_if(
            rowEnds.begin(), rowEnds.end(), [from](double end) { return from > end; });
        const auto place = row == rowEnds.end() ? rowEnds.begin() : row;
        *place = from + width;
        decoration.label->setPositionAlignment(
            (flip ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignTop);
        decoration.label->position->setCoords(*decoration.markX,
            static_cast<double>((place - rowEnds.begin()) * metrics.height()) / height);
    }
}

} // namespace dyncal

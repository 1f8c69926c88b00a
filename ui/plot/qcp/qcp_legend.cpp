// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_legend.h"

#include "ui/text/broken_text.h"

#include <algorithm>
#include <numeric>

namespace dyncal {

namespace {

constexpr int kLegendIconWidth = 26;
constexpr int kLegendPadding = 4;
constexpr int kLegendGap = 14;
constexpr int kLegendDescent = 2; ///< pixels; without them the tail of a g is cut off

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

bool hasEntry(const DrawnCurve &drawn)
{
    return drawn.curve->inLegend && !drawn.curve->name.isEmpty();
}

} // namespace

SceneLegend::SceneLegend(QCustomPlot &plot, const SceneCurves &curves)
    : m_plot(plot)
    , m_curves(curves)
    , m_row(new QCPLayoutGrid)
{
    m_plot.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    m_plot.legend->setMargins(QMargins(0, 0, 0, 0));
    m_plot.legend->setRowSpacing(0);
    m_plot.legend->setColumnSpacing(kLegendGap);
    m_plot.legend->setIconSize(kLegendIconWidth, 12);
    m_plot.legend->setIconTextPadding(kLegendPadding);
    m_plot.legend->setLayer("legend");
    m_plot.plotLayout()->addElement(1, 0, m_row); // must be in the plot before it takes elements
    m_row->addElement(0, 0, m_plot.legend);
    m_row->expandTo(1, 2);
    m_row->setColumnStretchFactor(0, 0.001);
}

void SceneLegend::make()
{
    m_plot.legend->clearItems();
    for (const DrawnCurve &drawn : m_curves.all())
        if (hasEntry(drawn))
            drawn.plottable()->addToLegend();
    m_wrap = 0;
    restyle();
}

void SceneLegend::style(const PlotTheme &theme)
{
    m_theme = theme;
    m_wrap = 0; // the font may be wider now
    m_plot.legend->setBrush(Qt::NoBrush);
    m_plot.legend->setBorderPen(Qt::NoPen);
    restyle();
}

void SceneLegend::restyle()
{
    for (const DrawnCurve &drawn : m_curves.all()) {
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

void SceneLegend::wrap(bool breaksNames)
{
    const QFontMetrics metrics(m_theme.font);
    const int room = m_plot.viewport().width() - kLegendIconWidth - 2 * kLegendPadding;
    for (const DrawnCurve &drawn : m_curves.all())
        if (breaksNames && hasEntry(drawn))
            drawn.plottable()->setName(brokenText(metrics, drawn.curve->name, room));
    std::vector<int> widths;
    for (const DrawnCurve &drawn : m_curves.all())
        if (hasEntry(drawn))
            widths.push_back(metrics.horizontalAdvance(drawn.curve->name) + kLegendIconWidth
                + 2 * kLegendPadding);
    const int wrap = columnsThatFit(widths, m_plot.viewport().width());
    if (wrap == m_wrap)
        return;
    m_wrap = wrap;
    m_plot.legend->setWrap(wrap);
    m_plot.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

bool SceneLegend::isShown() const
{
    return m_wanted && std::ranges::count_if(m_curves.all(), hasEntry) > 1;
}

std::optional<std::size_t> SceneLegend::entryAt(const QPointF &position) const
{
    if (!m_plot.legend->visible())
        return std::nullopt;
    for (std::size_t i = 0; i < m_curves.all().size(); ++i) {
        const QCPPlottableLegendItem *item
            = m_plot.legend->itemWithPlottable(m_curves.all()[i].plottable());
        if (item && item->outerRect().contains(position.toPoint()))
            return i;
    }
    return std::nullopt;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/plot_tools.h"

#include "ui/session/shared_cursors.h"
#include "ui/stages/frame/cursor_table.h"
#include "ui/stages/frame/go_to_field.h"

namespace dyncal {

PlotTools::PlotTools(QWidget *page)
    : QObject(page)
    , m_page(page)
{
}

void PlotTools::attach(PlotWidget *plot)
{
    connect(plot, &PlotWidget::goToRequested, this, [plot] {
        if (plot->isVisible()) // its menu may outlive its page
            new GoToField(*plot);
    });
    connect(plot, &PlotWidget::cursorTableRequested, this, [this, plot] { showTable(plot); });
}

void PlotTools::share(PlotWidget *plot, SharedCursors *cursors)
{
    connect(plot, &PlotWidget::cursorPlaced, cursors,
        [cursors, plot](int which, double x) { cursors->place(which, x, plot); });
    connect(plot, &PlotWidget::cursorsCleared, cursors, [cursors, plot] { cursors->clear(plot); });
    const auto follow = [plot, cursors](const QObject *source) {
        if (source == plot)
            return;
        const auto &at = cursors->positions();
        if (!at[0] && !at[1])
            plot->followCursor(0, std::nullopt);
        for (std::size_t i = 0; i < at.size(); ++i)
            if (at[i])
                plot->followCursor(static_cast<int>(i), at[i]);
    };
    connect(cursors, &SharedCursors::moved, plot, follow);
    follow(nullptr); // of a plot that is made later
}

void PlotTools::showTable(PlotWidget *plot)
{
    if (!m_table)
        m_table = new CursorTable(m_page);
    m_table->follow(plot);
}

void PlotTools::setTableVisible(bool visible)
{
    if (!m_table || m_table->isVisible() == visible)
        return;
    if (visible && !m_isHiddenWithPage)
        return; // the operator closed it
    m_isHiddenWithPage = !visible;
    m_table->setVisible(visible);
}

} // namespace dyncal

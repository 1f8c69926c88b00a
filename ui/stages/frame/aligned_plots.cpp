// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/aligned_plots.h"

#include "ui/plot/widget/plot_widget.h"

#include <QEvent>
#include <QTimer>

namespace dyncal {

void AlignedPlots::add(PlotWidget *plot)
{
    m_plots.push_back(plot);
    plot->setLeastLeftMargin(m_left_px);
    plot->installEventFilter(this);
    connect(plot, &PlotWidget::replotted, this, [this, plot] {
        if (plot->isVisible() && plot->leftMargin() > m_left_px)
            setMargin(plot->leftMargin());
    });
    connect(plot, &QObject::destroyed, this, [this](QObject *gone) { std::erase(m_plots, gone); });
}

void AlignedPlots::setMargin(int left_px)
{
    m_left_px = left_px;
    for (PlotWidget *plot : m_plots)
        plot->setLeastLeftMargin(left_px);
}

bool AlignedPlots::eventFilter(QObject *watched, QEvent *event)
{
    // Later, when all plots have heard of it.
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        QTimer::singleShot(0, this, [this] { setMargin(0); });
    return QObject::eventFilter(watched, event);
}

} // namespace dyncal

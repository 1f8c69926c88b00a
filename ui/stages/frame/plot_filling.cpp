// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/plot_filling.h"

#include "ui/plot/values/long_curves.h"
#include "ui/text/core_text.h"

#include <utility>

namespace dyncal {

PlotFilling::PlotFilling(PlotWidget *plot)
    : QObject(plot)
    , m_plot(plot)
    , m_jobs(this)
{
}

void PlotFilling::show(PlotMaking making)
{
    if (making.points <= kManyPoints) {
        PlotContent made = making.make();
        showAtOnce(making.finish ? making.finish(std::move(made)) : made);
        return;
    }
    const bool isKnown = !making.from.empty() && making.from == m_making.from;
    m_making = std::move(making);
    if (!isKnown)
        start();
    else if (!isBusy())
        showMade();
}

void PlotFilling::showAtOnce(const PlotContent &content)
{
    m_jobs.cancel();
    m_making = {};
    m_made = {};
    m_plot->setContent(content);
}

void PlotFilling::start()
{
    m_jobs.start<PlotContent>(
        [make = m_making.make](
            const JobControl &) -> Result<PlotContent> { return condensed(make()); },
        [this](Result<PlotContent> made) { deliver(std::move(made)); });
    emit changed();
}

void PlotFilling::deliver(Result<PlotContent> made)
{
    if (made) {
        m_made = std::move(*made);
        showMade();
    } else {
        PlotContent problem;
        problem.title = translated(made.error().message);
        showAtOnce(problem);
    }
    emit changed();
}

void PlotFilling::showMade()
{
    m_plot->setContent(m_making.finish ? m_making.finish(m_made) : m_made);
}

} // namespace dyncal

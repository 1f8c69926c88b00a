// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/widget/plot_widget.h"
#include "ui/session/job_runner.h"

#include <QObject>

#include <functional>
#include <memory>
#include <vector>

namespace dyncal {

/// What a plot is to show, and from what.
struct PlotMaking
{
    /// The results that it is made from: while they are the same, so are the curves.
    std::vector<std::shared_ptr<const void>> from;
    Index points = 0; ///< of all its curves, about
    std::function<PlotContent()> make; ///< holds values only: it may run in a job
    /// What depends on more than the results; quick.
    std::function<PlotContent(PlotContent)> finish = {};
};

/// Fills one plot. Curves of at most kManyPoints points are made at once; more in a job,
/// while the plot goes on showing what it showed and the window answers.
class PlotFilling : public QObject
{
    Q_OBJECT

public:
    explicit PlotFilling(PlotWidget *plot);

    void show(PlotMaking making);
    void showAtOnce(const PlotContent &content); ///< whatever was to come
    bool isBusy() const { return m_jobs.isRunning(); }

signals:
    void changed(); ///< a job has begun or ended

private:
    void start();
    void deliver(Result<PlotContent> made);
    void showMade();

    PlotWidget *m_plot;
    PlotMaking m_making; ///< of the curves that are there or under way; `from` empty: of none
    PlotContent m_made; ///< condensed, before it was finished
    JobRunner m_jobs; ///< last: stops before any member that a delivery uses is destroyed
};

} // namespace dyncal

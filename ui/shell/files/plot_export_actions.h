// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/widget/plot_widget.h"

#include <QPointer>
#include <QTimer>

#include <functional>

namespace dyncal {

class Preferences;
class Prompts;
class Session;
class StagePage;

/// Writes plots as files: one as it is on the screen, or those of all pages. Never over a
/// recording, and all of them never over any file. A plot that is out of date is not written.
class PlotExportActions : public QObject
{
    Q_OBJECT

public:
    PlotExportActions(
        Session &session, Prompts &prompts, Preferences &preferences, QWidget *window);

    void exportPlot(const PlotWidget &plot);
    /// Into a folder, as SVG, numbered in the order of the pages; one page or plot at a turn of the
    /// event loop. A change of the job, of its settings or of the language meanwhile ends it.
    void exportAll(const std::vector<StagePage *> &pages);

signals:
    void idle(const QString &outcome);
    void failed(const dyncal::Error &error);

private:
    bool refuses();
    void writeNext();
    void write(const PlotWidget &plot);
    void stop(const QString &outcome);
    void stopOnChange();

    Session &m_session;
    Prompts &m_prompts;
    Preferences &m_preferences;
    QWidget *m_window;
    QString m_folder;
    std::vector<QPointer<StagePage>> m_pages; ///< still to be drawn, the next one last
    std::vector<QPointer<const PlotWidget>> m_waiting; ///< of the page drawn, the next one last
    int m_written = 0;
    QTimer m_tick;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/plot_export_actions.h"

#include "core/base/writing/atomic_file.h"
#include "core/base/writing/write_problem.h"
#include "core/capture/opening/capture_open.h"
#include "core/capture/source_check.h"
#include "ui/session/capture_edit.h"
#include "ui/session/session.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/stages/frame/prompts.h"
#include "ui/stages/frame/stage_page.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kPause_ms = 20; ///< while long curves are drawn
constexpr QSize kSavedSize(960, 540); ///< of every plot of a set: pages never shown have no size

/// "singularValuePlot" as "singular-value".
QString fileName(const QString &objectName)
{
    QString name = objectName;
    name.replace(QRegularExpression("([a-z])([A-Z])"), "\\1-\\2");
    name.replace('_', '-');
    return name.toLower().remove("-plot").remove("plot-");
}

bool isWritable(const PlotWidget &plot)
{
    return plot.notice().isEmpty() && !plot.content().curves.empty();
}

} // namespace

PlotExportActions::PlotExportActions(
    Session &session, Prompts &prompts, Preferences &preferences, QWidget *window)
    : QObject(window)
    , m_session(session)
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_window(window)
{
    m_tick.setInterval(0);
    connect(&m_tick, &QTimer::timeout, this, &PlotExportActions::writeNext);
    for (auto change : {&Session::recipeChanged, &Session::capturesChanged})
        connect(&session, change, this, &PlotExportActions::stopOnChange);
}

/// What is written belongs to the settings on the screen and to the files that were opened.
bool PlotExportActions::refuses()
{
    QString problem;
    if (m_tick.isActive())
        problem = tr("Plots are still being written; wait until they are.");
    else if (const Result<void> same = checkSources(*m_session.state().captures); !same)
        problem = translated(same.error().message);
    else if (m_session.isComputing())
        problem = tr("The results are still being computed; try again in a moment.");
    if (!problem.isEmpty())
        m_prompts.showProblem(m_window, problem);
    return !problem.isEmpty();
}

void PlotExportActions::exportPlot(const PlotWidget &plot)
{
    if (refuses())
        return;
    if (!isWritable(plot)) {
        m_prompts.showProblem(m_window,
            plot.notice().isEmpty()
                ? tr("There is no curve in this plot.")
                : tr("This plot is not written, because it is not what the settings give: %1")
                      .arg(plot.notice()));
        return;
    }
    const QString proposed
        = QDir(m_preferences.lastFolder()).filePath(fileName(plot.objectName()) + ".svg");
    const QString path = m_prompts.saveFile(m_window, tr("Export plot"),
        tr("Vector image (*.svg);;Image (*.png);;PDF (*.pdf);;Data (*.csv)"), proposed, "svg");
    if (path.isEmpty())
        return;
    const auto bytes = plot.fileBytes(QFileInfo(path).suffix().toLower());
    if (!bytes) {
        m_prompts.showProblem(m_window,
            tr("A plot cannot be written as %1; choose a name that ends in .svg, .png, .pdf or .csv.")
                .arg(shownText(QFileInfo(path).fileName())));
        return;
    }
    const std::string target = path.toStdString();
    const Result<void> written = isRecordingOf(*m_session.state().captures, target)
        ? Result<void>(existsAlready(target))
        : writeFileAtomically(
            target, {bytes->constData(), static_cast<std::size_t>(bytes->size())});
    if (written)
        emit idle(tr("Written: %1").arg(shownText(path)));
    else
        emit failed(written.error());
}

void PlotExportActions::exportAll(const std::vector<StagePage *> &pages)
{
    if (refuses())
        return;
    m_folder = m_prompts.folder(
        m_window, tr("Save all plots into a folder"), m_preferences.lastFolder());
    if (m_folder.isEmpty() || refuses()) // the dialog may have stood open for long
        return;
    m_pages.assign(pages.rbegin(), pages.rend());
    m_written = 0;
    m_tick.start();
}

/// Draws the next page, or writes its next plot.
void PlotExportActions::writeNext()
{
    if (!m_waiting.empty()) {
        const QPointer<const PlotWidget> plot = m_waiting.back();
        m_waiting.pop_back();
        if (plot)
            write(*plot);
    } else if (!m_pages.empty()) {
        const QPointer<StagePage> page = m_pages.back();
        if (!page) // another language builds the pages anew
            return stopOnChange();
        if (!page->isDrawing())
            page->catchUp();
        m_tick.setInterval(page->isDrawing() ? kPause_ms : 0);
        if (page->isDrawing())
            return; // the next tick asks again
        m_pages.pop_back();
        for (const PlotWidget *plot : page->plots())
            if (isWritable(*plot))
                m_waiting.emplace_back(plot);
        std::ranges::reverse(m_waiting);
    } else {
        stop(tr("%n plot(s) written to %1", nullptr, m_written).arg(shownText(m_folder)));
    }
}

void PlotExportActions::write(const PlotWidget &plot)
{
    const QString number = QString("%1").arg(m_written + 1, 2, 10, QLatin1Char('0'));
    const std::string path
        = QDir(m_folder)
              .filePath(QString("%1-%2.svg").arg(number, fileName(plot.objectName())))
              .toStdString();
    const auto bytes = plot.fileBytes("svg", kSavedSize);
    const Result<void> written = bytes
        ? replaceUnchangedFile(
            path, {bytes->constData(), static_cast<std::size_t>(bytes->size())}, std::nullopt)
        : Result<void>(cannotWrite(path));
    if (written) {
        ++m_written;
        return;
    }
    m_tick.stop();
    m_waiting.clear();
    m_pages.clear();
    emit failed(written.error());
}

void PlotExportActions::stop(const QString &outcome)
{
    m_tick.stop();
    m_waiting.clear();
    m_pages.clear();
    emit idle(outcome);
}

void PlotExportActions::stopOnChange()
{
    if (m_tick.isActive())
        stop(tr(
            "Stopped, because the settings changed: %n plot(s) written to %1", nullptr, m_written)
                 .arg(shownText(m_folder)));
}

} // namespace dyncal

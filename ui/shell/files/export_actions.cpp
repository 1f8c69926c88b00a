// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/export_actions.h"

#include "core/base/writing/atomic_file.h"
#include "core/base/writing/write_problem.h"
#include "core/capture/capture_seal.h"
#include "core/capture/opening/capture_open.h"
#include "core/capture/source_check.h"
#include "core/results/model_export.h"
#include "core/results/publication.h"
#include "ui/report/report_logo.h"
#include "ui/session/capture_edit.h"
#include "ui/session/session.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/stages/frame/prompts.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QFileInfo>
#include <QWidget>

namespace dyncal {

ExportActions::ExportActions(Session &session, CurrentUtc currentUtc, Prompts &prompts,
    Preferences &preferences, QWidget *window)
    : QObject(window)
    , m_session(session)
    , m_currentUtc(std::move(currentUtc))
    , m_prompts(prompts)
    , m_preferences(preferences)
    , m_window(window)
    , m_job(this)
{
    connect(&m_job, &ExportJob::progress, this, &ExportActions::progress);
    connect(&m_job, &ExportJob::failed, this, &ExportActions::failed);
    connect(&m_job, &ExportJob::finished, this, [this](bool isWhole) {
        const QString target = shownText(m_target);
        emit idle(isWhole
                ? tr("Written: %1").arg(target)
                : tr("Written: %1 (results.json and recipe.json alone, because of what blocks)")
                      .arg(target));
    });
}

bool ExportActions::refusesRecording(const QString &path)
{
    if (!isRecordingOf(*m_session.state().captures, path.toStdString()))
        return false;
    emit failed(existsAlready(path.toStdString()).value());
    return true;
}

std::optional<Message> ExportActions::whyNoResults(const Session &session)
{
    const auto because = [](const char *sentence) { return Message{sentence, {}}; };
    if (const Result<void> same = checkSources(*session.state().captures); !same)
        return same.error().message;
    if (session.isComputing())
        return because(
            DYNCAL_TEXT("core", "The results are still being computed; try again in a moment."));
    if (!session.isUpToDate())
        return because(DYNCAL_TEXT("core",
            "The results are out of date because the computation was cancelled; press F9 to compute them again."));
    if (!session.results().model)
        return because(DYNCAL_TEXT(
            "core", "There is no model yet: open recordings and clear what blocks the stages."));
    return std::nullopt;
}

bool ExportActions::hasResults()
{
    const std::optional<Message> why = whyNoResults(m_session);
    if (why)
        m_prompts.showProblem(m_window, translated(*why));
    return !why;
}

PipelineOutcome ExportActions::outcome() const
{
    return {m_session.results(), m_session.error(), m_session.failedStage()};
}

/// Also shows what blocks.
bool ExportActions::isBlocked()
{
    const std::optional<Error> obstacle = publicationObstacle(outcome());
    if (obstacle)
        emit failed(*obstacle);
    return obstacle.has_value();
}

bool ExportActions::refuses()
{
    if (m_job.isRunning())
        m_prompts.showProblem(m_window,
            tr("Results are still being written to %1; wait until they are, or press Cancel.")
                .arg(shownText(m_target)));
    return m_job.isRunning();
}

void ExportActions::exportResults()
{
    if (refuses() || !hasResults())
        return;
    const QString folder = m_prompts.folder(
        m_window, tr("Export results into a folder"), m_preferences.lastFolder());
    if (folder.isEmpty())
        return;
    Result<FolderWrite> begun
        = FolderWrite::begin(runFolder(folder.toStdString(), *m_session.state().captures));
    if (!begun) {
        emit failed(begun.error());
        return;
    }
    startExport(folder, ReportParts::CertificateAndPlots,
        [target = std::make_shared<FolderWrite>(std::move(*begun)),
            captures = m_session.state().captures](
            const RunFiles &run, const JobControl &control) -> Result<void> {
            if (const Result<void> same = checkSources(*captures); !same)
                return same;
            const auto written = writeRunFiles(run, *target, control);
            if (!written)
                return tl::unexpected<Error>(written.error());
            return {};
        });
}

void ExportActions::exportCertificate(const QString &proposed)
{
    if (refuses() || !hasResults() || isBlocked())
        return;
    const QString path = m_prompts.saveFile(
        m_window, tr("Export certificate"), tr("PDF documents (*.pdf)"), proposed, "pdf");
    if (path.isEmpty() || refusesRecording(path))
        return;
    startExport(path, ReportParts::Certificate,
        [path = path.toStdString(), captures = m_session.state().captures](
            const RunFiles &run, const JobControl &) {
            const Result<void> same = checkSources(*captures);
            const Result<void> whole = same ? checkStillWhole(*captures) : same;
            return whole ? writeFileAtomically(path, run.drawn.front().bytes) : whole;
        });
}

void ExportActions::exportModel()
{
    if (refuses() || !hasResults() || isBlocked())
        return;
    const QString folder = m_prompts.folder(
        m_window, tr("Export the model into a folder"), m_preferences.lastFolder());
    if (folder.isEmpty())
        return;
    Result<FolderWrite> target
        = FolderWrite::begin(modelFolder(folder.toStdString(), *m_session.state().captures));
    if (target) // asked again: the dialog may have stood open for long
        if (const Result<void> same = checkSources(*m_session.state().captures); !same)
            target = tl::unexpected<Error>(same.error());
    const auto written = target ? writeModelFiles(m_session.results(), modelFormats(), *target)
                                : tl::unexpected<Error>(target.error());
    if (written)
        emit idle(tr("Model written to %1").arg(shownText(folder)));
    else
        emit failed(written.error());
}

void ExportActions::startExport(
    const QString &target, ReportParts parts, const ExportJob::Write &write)
{
    const Result<std::string> created = m_currentUtc();
    if (!created) {
        emit failed(created.error());
        return;
    }
    Result<ChosenTemplate> chosen = drawableTemplate(m_session.recipe().certificate.templateName);
    if (!chosen) {
        emit failed(chosen.error());
        return;
    }
    m_target = target;
    emit busy(tr("Writing %1").arg(shownText(QFileInfo(target).fileName())));
    m_job.start(
        {outcome(), m_session.recipe(), *created, {}, {}, std::move(*chosen)}, parts, write);
}

} // namespace dyncal

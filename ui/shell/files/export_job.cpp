// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/export_job.h"

#include "core/base/free_memory.h"
#include "core/results/publication.h"

namespace dyncal {

namespace {

/// Length of one drawing step: too short to be noticed at the mouse.
constexpr std::chrono::milliseconds kDrawingTime{15};
/// Share of drawing in the whole progress.
constexpr double kDrawingShare = 0.7;
/// Memory that drawing takes at most; checked first, because Qt would end the program where it gets
/// none.
constexpr std::size_t kDrawingBytes = std::size_t(96) << 20U;

Error notEnoughMemory()
{
    return {ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "There is not enough memory to draw the certificate and the plots, and nothing was written; close other programs or raise the memory limit."),
            {}},
        {}, 0};
}

} // namespace

ExportJob::ExportJob(QObject *parent)
    : QObject(parent)
    , m_jobs(this)
{
    m_tick.setInterval(0);
    connect(&m_tick, &QTimer::timeout, this, &ExportJob::drawSome);
}

void ExportJob::start(RunFiles run, ReportParts parts, Write write)
{
    cancel();
    if (!isMemoryLeft(kDrawingBytes)) {
        emit failed(notEnoughMemory());
        return;
    }
    m_run = std::move(run);
    m_write = std::move(write);
    m_drawing = std::make_unique<ReportDrawing>(
        m_run.outcome.results, m_run.recipe, m_run.createdUtc, parts, m_run.chosen);
    m_tick.start();
}

void ExportJob::cancel()
{
    m_tick.stop();
    m_drawing.reset();
    m_write = {}; // also releases the claim on the folder
    m_jobs.cancel();
}

void ExportJob::drawSome()
{
    const bool isDrawn = mayPublish(m_run.outcome);
    if (isDrawn)
        m_drawing->draw(kDrawingTime);
    emit progress(kDrawingShare * m_drawing->fraction());
    if (isDrawn && !m_drawing->isDone())
        return;
    m_tick.stop();
    Result<std::vector<DrawnFile>> drawn = m_drawing->take();
    m_drawing.reset();
    if (drawn) {
        write(std::move(*drawn));
        return;
    }
    m_write = {};
    emit failed(drawn.error());
}

void ExportJob::write(std::vector<DrawnFile> drawn)
{
    m_run.drawn = std::move(drawn);
    // The job owns the run: the results may be large, and are freed with it.
    const auto run = std::make_shared<const RunFiles>(std::exchange(m_run, {}));
    m_jobs.start<bool>(
        [run, write = std::exchange(m_write, {})](const JobControl &control) -> Result<bool> {
            const Result<void> written = write(*run, control);
            if (!written)
                return tl::unexpected<Error>(written.error());
            return mayPublish(run->outcome);
        },
        [this](const Result<bool> &outcome) {
            if (outcome)
                emit finished(*outcome);
            else
                emit failed(outcome.error());
        },
        [this](double done) { emit progress(kDrawingShare + (1.0 - kDrawingShare) * done); });
}

} // namespace dyncal

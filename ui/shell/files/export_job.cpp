// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/export_job.h"

#include "core/results/publication.h"

namespace dyncal {

namespace {

/// Share of drawing in the whole progress.
constexpr double kDrawingShare = 0.7;

} // namespace

ExportJob::ExportJob(QObject *parent)
    : QObject(parent)
    , m_drawing(this)
    , m_jobs(this)
{
    connect(&m_drawing, &DrawingSteps::progress, this,
        [this](double fraction) { emit progress(kDrawingShare * fraction); });
    connect(&m_drawing, &DrawingSteps::drawn, this, &ExportJob::write);
    connect(&m_drawing, &DrawingSteps::failed, this, &ExportJob::giveUp);
}

void ExportJob::start(RunFiles run, ReportParts parts, Write write)
{
    cancel();
    if (const Result<void> memory = DrawingSteps::checkMemory(); !memory) {
        emit failed(memory.error());
        return;
    }
    m_run = std::move(run);
    m_write = std::move(write);
    if (!mayPublish(m_run.outcome)) {
        this->write({});
        return;
    }
    m_drawing.start(std::make_unique<ReportDrawing>(
        m_run.outcome.results, m_run.recipe, m_run.createdUtc, parts, m_run.chosen));
}

void ExportJob::cancel()
{
    m_drawing.cancel();
    m_write = {}; // also releases the claim on the folder
    m_jobs.cancel();
}

void ExportJob::giveUp(const Error &error)
{
    m_write = {};
    emit failed(error);
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

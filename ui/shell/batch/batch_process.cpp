// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/batch/batch_process.h"

#include "ui/text/shown_text.h"

namespace dyncal {

namespace {

constexpr int kMostExitOfEnd = 2; ///< done, with cautions, something blocked: it came to its end
constexpr int kPatience_ms = 10'000;

} // namespace

BatchProcess::BatchProcess(QString program, QObject *parent)
    : QObject(parent)
    , m_program(std::move(program))
{
    m_process.setStandardInputFile(QProcess::nullDevice());
    m_process.setStandardOutputFile(QProcess::nullDevice());
    connect(&m_process, &QProcess::finished, this, &BatchProcess::finish);
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            emit ended(false,
                tr("%1 could not be started; check that it is there and may be executed.")
                    .arg(shownText(m_program)));
    });
}

BatchProcess::~BatchProcess()
{
    m_process.disconnect(this);
    if (!isRunning())
        return;
    m_process.terminate();
    m_process.waitForFinished(kPatience_ms);
}

void BatchProcess::start(const QString &plan, int jobs)
{
    m_isStopped = false;
    m_process.start(m_program,
        {QStringLiteral("batch"), QStringLiteral("run"), plan, QStringLiteral("--jobs"),
            QString::number(jobs)});
}

void BatchProcess::stop()
{
    m_isStopped = true;
    m_process.terminate();
}

void BatchProcess::finish(int exitCode, QProcess::ExitStatus status)
{
    const QString complaint = lastComplaint();
    if (m_isStopped)
        emit ended(true, {});
    else if (status == QProcess::CrashExit)
        emit ended(false,
            tr("The run was ended from outside or crashed; what is complete is kept, run it again."));
    else
        emit ended(false, exitCode <= kMostExitOfEnd ? QString() : complaint);
}

/// What it said last: in a long batch the other lines are the reasons of sensors, which the table
/// shows.
QString BatchProcess::lastComplaint()
{
    const QByteArray said = m_process.readAllStandardError().trimmed();
    return shownText(QString::fromUtf8(said.mid(said.lastIndexOf('\n') + 1)));
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/program/program_call.h"

#include "ui/text/number_locale.h"
#include "ui/text/shown_text.h"

#include <QProcessEnvironment>

#include <unistd.h>

namespace dyncal {

namespace {

constexpr int kMostExitOfEnd = 2; ///< done, with cautions, something blocked: it came to its end
constexpr int kNotStarted = -1;
constexpr int kPatience_ms = 10'000;

} // namespace

QString problemOf(const ProgramAnswer &answer)
{
    if (answer.isStopped)
        return {};
    if (answer.isCrash)
        return ProgramCall::tr(
            "The command was ended from outside or crashed; what is complete is kept, run it again.");
    const bool hasEnded = answer.exitCode >= 0 && answer.exitCode <= kMostExitOfEnd;
    return hasEnded ? QString() : answer.complaint;
}

ProgramCall::ProgramCall(QString program, QObject *parent)
    : QObject(parent)
    , m_program(std::move(program))
{
    m_process.setStandardInputFile(QProcess::nullDevice());
    connect(&m_process, &QProcess::finished, this, &ProgramCall::finish);
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            emit ended({false, false, kNotStarted, {},
                tr("%1 could not be started; check that it is there and may be executed.")
                    .arg(shownText(m_program))});
    });
}

ProgramCall::~ProgramCall()
{
    m_process.disconnect(this);
    if (!isRunning())
        return;
    m_process.terminate();
    m_process.waitForFinished(kPatience_ms);
}

void ProgramCall::start(const QStringList &arguments)
{
    m_isStopped = false;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DYNCAL_LANGUAGE"), numberLanguage());
    m_process.setProcessEnvironment(environment);
    m_process.start(m_program, arguments);
}

void ProgramCall::start(const QStringList &arguments, SecretPipe secret)
{
    if (secret.isGiven())
        m_process.setChildProcessModifier(
            [from = secret.readEnd()] { ::dup2(from, STDIN_FILENO); });
    start(arguments);
    m_process.setChildProcessModifier({});
}

void ProgramCall::stop()
{
    m_isStopped = true;
    m_process.terminate();
}

void ProgramCall::finish(int exitCode, QProcess::ExitStatus status)
{
    emit ended({m_isStopped, status == QProcess::CrashExit, exitCode,
        m_process.readAllStandardOutput(), lastComplaint()});
}

/// What it said last: of a long work the other lines are about its parts.
QString ProgramCall::lastComplaint()
{
    const QByteArray said = m_process.readAllStandardError().trimmed();
    return shownText(QString::fromUtf8(said.mid(said.lastIndexOf('\n') + 1)));
}

} // namespace dyncal

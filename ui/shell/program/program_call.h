// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/program/secret_pipe.h"

#include <QObject>
#include <QProcess>
#include <QStringList>

namespace dyncal {

/// How a call of the program ended.
struct ProgramAnswer
{
    bool isStopped = false; ///< on request
    bool isCrash = false; ///< by a signal, of its own or from outside
    int exitCode = 0;
    QByteArray out; ///< what it printed
    QString complaint; ///< its last sentence on the error output, fit to show
};

/// The sentence of what went wrong; empty where it was stopped or came to its end (exit codes 0 to
/// 2: done, with cautions, something blocked).
QString problemOf(const ProgramAnswer &answer);

/// A command of `dyncal` as a process of its own: the window works with the very program that
/// scripts use, and neither a slow disk nor a lost server can hold the window.
class ProgramCall : public QObject
{
    Q_OBJECT

public:
    /// `program`: path of dyncal.
    explicit ProgramCall(QString program, QObject *parent);
    ~ProgramCall() override; ///< what runs is stopped in good order and awaited

    void setProgram(const QString &program) { m_program = program; }
    /// Its sentences come in the language of the window.
    void start(const QStringList &arguments);
    /// The same with a passphrase or PIN as its standard input, which it reads by `--pin-fd 0`.
    void start(const QStringList &arguments, SecretPipe secret);
    void stop(); ///< as Ctrl-C does: what is complete stays
    bool isStopping() const { return isRunning() && m_isStopped; }
    bool isRunning() const { return m_process.state() != QProcess::NotRunning; }

signals:
    void ended(const dyncal::ProgramAnswer &answer);

private:
    void finish(int exitCode, QProcess::ExitStatus status);
    QString lastComplaint();

    QString m_program;
    QProcess m_process;
    bool m_isStopped = false;
};

} // namespace dyncal

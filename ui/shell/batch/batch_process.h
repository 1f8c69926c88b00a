// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>
#include <QProcess>

namespace dyncal {

/// `dyncal batch run` as a process of its own: the window computes with the very program that a
/// night run uses, and neither can harm the other.
class BatchProcess : public QObject
{
    Q_OBJECT

public:
    /// `program`: path of dyncal.
    BatchProcess(QString program, QObject *parent);
    ~BatchProcess() override; ///< a run is stopped in good order and awaited

    void setProgram(const QString &program) { m_program = program; }
    void start(const QString &plan, int jobs);
    void stop(); ///< sensors that are complete stay, those in work are left
    bool isStopping() const { return isRunning() && m_isStopped; }
    bool isRunning() const { return m_process.state() != QProcess::NotRunning; }

signals:
    /// `problem`: the sentence of what went wrong; empty where it came to its end or was stopped.
    void ended(bool isStopped, const QString &problem);

private:
    void finish(int exitCode, QProcess::ExitStatus status);
    QString lastComplaint();

    QString m_program;
    QProcess m_process;
    bool m_isStopped = false;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QByteArray>
#include <QProcess>
#include <QStringList>

namespace dyncal::testing {

/// What another program answered to a call from a test.
struct ProgramAnswer
{
    bool ran = false; ///< to its end, with exit code 0
    QByteArray out;
    QByteArray err;
};

inline ProgramAnswer answerOf(const QString &program, const QStringList &arguments)
{
    constexpr int kLimit_ms = 120000;
    QProcess process;
    process.start(program, arguments);
    ProgramAnswer answer;
    answer.ran
        = process.waitForStarted() && process.waitForFinished(kLimit_ms) && process.exitCode() == 0;
    answer.out = process.readAllStandardOutput();
    answer.err = process.readAllStandardError();
    return answer;
}

} // namespace dyncal::testing

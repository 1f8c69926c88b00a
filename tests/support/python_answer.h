// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QByteArray>
#include <QProcess>
#include <QStringList>

namespace dyncal::testing {

/// The answer of Debian's own python3 to a call from a test.
struct PythonAnswer
{
    bool ran = false; ///< to its end, with exit code 0
    QByteArray out;
    QByteArray err;
};

inline PythonAnswer python(const QStringList &arguments)
{
    constexpr int kLimit_ms = 120000;
    QProcess process;
    process.start("/usr/bin/python3", arguments);
    PythonAnswer answer;
    answer.ran
        = process.waitForStarted() && process.waitForFinished(kLimit_ms) && process.exitCode() == 0;
    answer.out = process.readAllStandardOutput();
    answer.err = process.readAllStandardError();
    return answer;
}

/// Whether it has the modules that the comparisons need.
inline bool hasNumericalPython()
{
    return python({"-c", "import numpy, scipy"}).ran;
}

} // namespace dyncal::testing

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/file_bytes.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>
#include <QStringList>

#include <sys/resource.h>

#include <cstdint>

using dyncal::testing::bytesOf;
using dyncal::testing::writeBytes;

/// What one call of the program answered.
struct Answer
{
    int exitCode = -1;
    QByteArray out;
    QByteArray err;

    /// Lines of the diagnostics.
    QList<QByteArray> complaints() const
    {
        QList<QByteArray> lines = err.split('\n');
        lines.removeAll(QByteArray());
        return lines;
    }
    QJsonObject json() const { return QJsonDocument::fromJson(out).object(); }
};

/// Bytes of address space that the process may have; 0 = no limit.
inline void limitAddressSpace(QProcess &process, std::uint64_t bytes)
{
    if (bytes == 0)
        return;
    process.setChildProcessModifier([bytes] {
        const rlimit limit{bytes, bytes};
        ::setrlimit(RLIMIT_AS, &limit);
    });
}

/// Calls the built program ($DYNCAL_BINARY) without a display and waits for its end. `extra` are
/// further environment variables ("NAME=value"), `addressSpace` its limit in bytes.
inline Answer runDyncal(
    const QStringList &arguments, const QStringList &extra = {}, std::uint64_t addressSpace = 0)
{
    constexpr int kLongest_ms = 240000;
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "SOURCE_DATE_EPOCH"})
        environment.remove(QLatin1String(name));
    for (const QString &variable : extra)
        environment.insert(variable.section('=', 0, 0), variable.section('=', 1));
    process.setProcessEnvironment(environment);
    limitAddressSpace(process, addressSpace);
    process.start(qEnvironmentVariable("DYNCAL_BINARY"), arguments);
    Answer answer;
    if (process.waitForFinished(kLongest_ms) && process.exitStatus() == QProcess::NormalExit)
        answer.exitCode = process.exitCode();
    answer.out = process.readAllStandardOutput();
    answer.err = process.readAllStandardError();
    return answer;
}

/// Whether a process ignores ("SigIgn") or blocks ("SigBlk") a signal, as the kernel says.
inline bool hasSignalIn(const char *set, qint64 process, int number)
{
    const QByteArray status = bytesOf(QString("/proc/%1/status").arg(process));
    const QByteArray key = QByteArray(set) + ":\t";
    const qsizetype mask = status.indexOf(key);
    return mask >= 0
        && (status.mid(mask + key.size(), 16).toULongLong(nullptr, 16) & (1ULL << (number - 1)))
        != 0;
}

/// Waits until the program waits for the signal on a thread of its own, with all others blocking
/// it: before that its start is ended by it as any program's. False if it ended or a minute passed.
inline bool waitUntilAwaited(const QProcess &process, int number)
{
    constexpr int kLongest_ms = 60000;
    QElapsedTimer waited;
    for (waited.start(); waited.elapsed() < kLongest_ms;)
        if (hasSignalIn("SigBlk", process.processId(), number))
            return true;
    return false;
}

inline QJsonObject fileJson(const QString &path)
{
    return QJsonDocument::fromJson(bytesOf(path)).object();
}

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/system/issued_job.h"

/// Where a secret shows while a process works: arguments and environment of it and of all that it
/// started, and every file below some folders. Looks again and again.
class SecretLook
{
public:
    SecretLook(QByteArray secret, QStringList folders)
        : m_secret(std::move(secret))
        , m_folders(std::move(folders))
    {
    }

    /// Looks until the process has ended, and once more; false if that takes too long.
    bool follow(QProcess &process)
    {
        constexpr int kLongest_ms = 240'000, kPause_ms = 2;
        QElapsedTimer time;
        time.start();
        while (process.state() != QProcess::NotRunning && time.elapsed() < kLongest_ms) {
            look(process.processId());
            process.waitForFinished(kPause_ms);
        }
        lookAtFiles();
        return process.state() == QProcess::NotRunning;
    }

    int looks() const { return m_looks; }
    /// Names of the places, each once.
    QStringList traces() const { return m_traces; }
    /// Whether a command line with these words was seen.
    bool saw(const QByteArray &words) const
    {
        return std::ranges::any_of(
            m_commands, [&](const QByteArray &command) { return command.contains(words); });
    }

private:
    static QByteArray ofProcess(qint64 process, const char *what)
    {
        return bytesOf(QString("/proc/%1/%2").arg(process).arg(QLatin1String(what)));
    }

    /// The process and all below it, as the kernel says now.
    static QList<qint64> family(qint64 process)
    {
        QMultiMap<qint64, qint64> children;
        for (const QString &name : QDir("/proc").entryList(QDir::Dirs)) {
            bool isProcess = false;
            const qint64 one = name.toLongLong(&isProcess);
            if (!isProcess)
                continue;
            const QByteArray stat = ofProcess(one, "stat"); // PID (name) state parent ...
            const QList<QByteArray> rest = stat.mid(stat.lastIndexOf(')') + 2).split(' ');
            children.insert(rest.value(1).toLongLong(), one);
        }
        QList<qint64> all{process};
        for (qsizetype i = 0; i < all.size(); ++i)
            all += children.values(all[i]);
        return all;
    }

    void look(qint64 process)
    {
        ++m_looks;
        for (const qint64 one : family(process)) {
            const QByteArray command = ofProcess(one, "cmdline").replace('\0', ' ');
            note(command, QString("arguments of %1").arg(one));
            note(ofProcess(one, "environ"), QString("environment of %1").arg(one));
            if (!m_commands.contains(command))
                m_commands << command;
        }
        lookAtFiles();
    }
    void lookAtFiles()
    {
        for (const QString &folder : m_folders) {
            const auto files = bytesBelow(folder);
            for (auto file = files.begin(); file != files.end(); ++file)
                note(*file, file.key());
        }
    }
    void note(const QByteArray &bytes, const QString &place)
    {
        if (bytes.contains(m_secret) && !m_traces.contains(place))
            m_traces << place;
    }

    QByteArray m_secret;
    QStringList m_folders;
    int m_looks = 0;
    QStringList m_traces;
    QList<QByteArray> m_commands;
};

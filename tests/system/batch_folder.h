// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/system/quick_recipe.h"
#include "tests/system/short_capture.h"

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QMap>
#include <QProcess>
#include <QTemporaryDir>

/// A batch on disk for the system tests, and the program as it works on it.

inline const QStringList kEpoch{"SOURCE_DATE_EPOCH=1767225600"};

/// Every file below a folder with its time of change and content.
inline QMap<QString, QPair<qint64, QByteArray>> filesBelow(const QString &folder)
{
    QMap<QString, QPair<qint64, QByteArray>> files;
    for (QDirIterator entry(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
         entry.hasNext();) {
        const QFileInfo file = entry.nextFileInfo();
        files[QDir(folder).relativeFilePath(file.filePath())]
            = {file.lastModified().toMSecsSinceEpoch(), bytesOf(file.filePath())};
    }
    return files;
}

inline bool copyFolder(const QString &from, const QString &to)
{
    QDir().mkpath(to);
    for (const QFileInfo &entry :
        QDir(from).entryInfoList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot)) {
        const QString target = to + "/" + entry.fileName();
        if (!(entry.isDir() ? copyFolder(entry.filePath(), target)
                            : QFile::copy(entry.filePath(), target)))
            return false;
    }
    return true;
}

/// A folder of recordings and a plan beside it.
struct BatchFolder
{
    QTemporaryDir folder;
    QString path(const QString &name) const { return folder.filePath(name); }

    /// Copies of the simulated sensors; recordings are only ever replaced as a whole.
    void addSensors(const QString &simulated, int count) const
    {
        for (int i = 1; i <= count; ++i) {
            const QString id = QString("in/SN-%1").arg(i);
            QDir(folder.path()).mkpath(id);
            QFile::copy(simulated + QString("/%1.h5").arg(i), path(id + "/shot.h5"));
        }
    }
    /// With few trials of the Monte Carlo, which takes ten times as long as all else of them.
    Answer plan(const QStringList &more = {}) const
    {
        QStringList words{"batch", "plan", path("in"), "-o", path("night.jsonl")};
        if (!more.contains("--recipe")) {
            writeBytes(path("quick.json"), kQuickRecipe);
            words << "--recipe" << path("quick.json");
        }
        return runDyncal(words + more, kEpoch);
    }
    Answer run(const QStringList &more = {}) const
    {
        return runDyncal(QStringList{"batch", "run", path("night.jsonl")} + more, kEpoch);
    }
    QJsonObject status() const
    {
        return runDyncal({"batch", "status", path("night.jsonl"), "--json"}, kEpoch).json();
    }
    /// The summary as it is now; empty if it cannot be made.
    QByteArray summary(const QStringList &more = {}) const
    {
        runDyncal(
            QStringList{"batch", "merge", path("night.jsonl"), "-o", path("night.csv")} + more,
            kEpoch);
        return bytesOf(path("night.csv"));
    }
    QString results(int i) const { return path(QString("night.out/SN-%1/calibration").arg(i)); }
};

/// Starts a run with two jobs in a session of its own.
inline void start(QProcess &process, const BatchFolder &batch)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("SOURCE_DATE_EPOCH", "1767225600");
    process.setProcessEnvironment(environment);
    process.start(qEnvironmentVariable("DYNCAL_BINARY"),
        {"batch", "run", batch.path("night.jsonl"), "--jobs", "2"});
}

/// The processes that a process has started.
inline QList<qint64> childrenOf(qint64 process)
{
    QList<qint64> children;
    const QByteArray list = bytesOf(QString("/proc/%1/task/%1/children").arg(process));
    for (const QByteArray &word : list.split(' '))
        if (const qint64 child = word.toLongLong())
            children << child;
    return children;
}

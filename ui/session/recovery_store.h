// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "ui/session/project_file.h"

#include <QDateTime>
#include <QString>
#include <QStringList>

#include <map>
#include <memory>
#include <vector>

namespace dyncal {

class FileLock;

/// Unsaved work that a program left behind when it was stopped.
struct RecoveredWork
{
    QString file; ///< a project file with the key "recovery"
    QString project; ///< the project that was being changed; empty = never saved
    QDateTime saved; ///< when the file was written
    QDateTime stopped; ///< last sign of life
    QStringList recordings; ///< base names
    std::string projectSha256; ///< of the project's file then; empty = not known
};

/// A recovery file that cannot be read, and where it was put for somebody to look at.
struct UnreadableWork
{
    QString keptAs;
    Error error;
};

/// The recovery files of one user: one per running program, work-1.dyncal and on, each under a lock
/// that lives as long as its program. A file whose lock is free was left behind by a program that
/// no longer runs; this program takes the lock, and no other one offers the work.
class RecoveryStore
{
public:
    /// Takes a file of its own and all that were left behind. The folder is made if it is missing.
    explicit RecoveryStore(const QString &folder);
    ~RecoveryStore(); ///< releases the locks; files stay
    RecoveryStore(const RecoveryStore &) = delete;
    RecoveryStore &operator=(const RecoveryStore &) = delete;

    /// Where this program may write; fails (Usage) where the folder cannot be used.
    const Result<QString> &file() const { return m_file; }
    /// Newest first.
    const std::vector<RecoveredWork> &leftBehind() const { return m_left; }
    const std::vector<UnreadableWork> &unreadable() const { return m_unreadable; }

    /// Continues with a file left behind as its own; the one used so far is removed.
    void adopt(const QString &file);
    /// Removes a file left behind.
    void discard(const QString &file);

private:
    void take(const QString &file);
    bool lock(const QString &file);
    void forget(const QString &file);

    std::map<QString, std::unique_ptr<FileLock>> m_locks; ///< by file
    Result<QString> m_file = QString();
    std::vector<RecoveredWork> m_left;
    std::vector<UnreadableWork> m_unreadable;
};

/// Writes the job whole or not at all, with the project that it changes. Fails as
/// writeFileAtomically does.
Result<void> writeRecoveryFile(const QString &file, const ProjectState &state,
    const QString &project, const QDateTime &now, const ProjectFileHash &projectSha256 = {});
/// Sets the time of the file, as a sign that its program still runs; the saved time inside stays.
void markAlive(const QString &file, const QDateTime &now);
/// What the file holds; its recordings are not looked at. Fails (FileUnreadable, Usage) where it
/// could not be opened as a project.
Result<RecoveredWork> readRecoveryFile(const QString &file);

} // namespace dyncal

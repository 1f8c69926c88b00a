// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/recovery_store.h"

#include "core/base/writing/atomic_file.h"
#include "ui/session/file_lock.h"
#include "ui/session/project_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>

namespace dyncal {

namespace {

constexpr const char *kName = "work-%1.dyncal";
constexpr const char *kPattern = "work-*.dyncal";
constexpr const char *kLockSuffix = ".lock";
constexpr const char *kUnreadableSuffix = ".unreadable";
constexpr const char *kKey = "recovery"; ///< of the project file
/// More windows than anybody opens; ends the search for a free name.
constexpr int kMostPrograms = 1000;

/// Removes what a program that was stopped while writing left beside the file.
void removeParts(const QString &file)
{
    const QFileInfo info(file);
    const QStringList parts
        = info.dir().entryList({info.fileName() + QStringLiteral(".part-*")}, QDir::Files);
    for (const QString &part : parts)
        QFile::remove(info.dir().filePath(part));
}

/// Renames the file so that the next start does not find it; never replaces another one. Empty if
/// it cannot be renamed.
QString setAside(const QString &file)
{
    for (int i = 1; i <= kMostPrograms; ++i) {
        const QString kept = file + kUnreadableSuffix + QStringLiteral("-%1").arg(i);
        if (!QFileInfo::exists(kept))
            return QFile::rename(file, kept) ? kept : QString();
    }
    return {};
}

} // namespace

RecoveryStore::RecoveryStore(const QString &folder)
{
    const QDir place(folder);
    if (!place.mkpath(QStringLiteral("."))) {
        m_file = fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core", "The folder %1 cannot be made."), {folder.toStdString()}});
        return;
    }
    for (const QString &name : place.entryList({kPattern}, QDir::Files))
        if (lock(place.filePath(name)))
            take(place.filePath(name));
    std::ranges::sort(m_left, std::ranges::greater(), &RecoveredWork::saved);
    const bool usable = QFileInfo(folder).isWritable();
    for (int i = 1; usable && i <= kMostPrograms; ++i) {
        const QString file = place.filePath(QString(kName).arg(i));
        if (m_locks.contains(file) || QFileInfo::exists(file) || !lock(file))
            continue;
        m_file = file;
        return;
    }
    m_file = fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "The folder %1 cannot be written to."), {folder.toStdString()}});
}

RecoveryStore::~RecoveryStore() = default;

bool RecoveryStore::lock(const QString &file)
{
    std::unique_ptr<FileLock> lock = FileLock::take(file + kLockSuffix);
    const bool isOurs = lock != nullptr;
    if (isOurs)
        m_locks[file] = std::move(lock);
    return isOurs;
}

/// The file of a stopped program, locked by this one now.
void RecoveryStore::take(const QString &file)
{
    removeParts(file);
    const Result<RecoveredWork> work = readRecoveryFile(file);
    if (work) {
        m_left.push_back(*work);
        return;
    }
    if (QFileInfo::exists(file)) { // else its program has just ended in good order
        const QString kept = setAside(file);
        m_unreadable.push_back({kept.isEmpty() ? file : kept, work.error()});
    }
    m_locks.erase(file);
}

void RecoveryStore::forget(const QString &file)
{
    std::erase_if(m_left, [&](const RecoveredWork &work) { return work.file == file; });
}

void RecoveryStore::adopt(const QString &file)
{
    if (m_file) {
        QFile::remove(*m_file);
        m_locks.erase(*m_file);
    }
    m_file = file;
    if (!m_locks.contains(file)) // released while the file was being opened
        lock(file);
    forget(file);
}

void RecoveryStore::discard(const QString &file)
{
    QFile::remove(file);
    forget(file);
    m_locks.erase(file);
}

Result<void> writeRecoveryFile(const QString &file, const ProjectState &state,
    const QString &project, const QDateTime &now, const ProjectFileHash &projectSha256)
{
    const QJsonObject about{
        {"project", project.isEmpty() ? QString() : QFileInfo(project).absoluteFilePath()},
        {"project_sha256", QString::fromStdString(projectSha256.value_or(""))},
        {"saved_utc", now.toUTC().toString(Qt::ISODate)}};
    const QByteArray bytes
        = projectBytes(state, QFileInfo(file).absolutePath(), {{QString(kKey), about}});
    const Result<void> written = writeFileAtomically(file.toStdString(), bytes.toStdString());
    if (written)
        markAlive(file, now);
    return written;
}

void markAlive(const QString &file, const QDateTime &now)
{
    QFile handle(file);
    if (handle.open(QIODevice::ReadWrite | QIODevice::ExistingOnly))
        handle.setFileTime(now, QFileDevice::FileModificationTime);
}

Result<RecoveredWork> readRecoveryFile(const QString &file)
{
    const Result<ProjectFile> project = readProjectFile(file);
    if (!project)
        return tl::unexpected(project.error());
    if (const Result<Recipe> recipe = recipeOfProject(project->content); !recipe)
        return tl::unexpected(recipe.error());
    const QJsonObject about = project->content[QLatin1String(kKey)].toObject();
    RecoveredWork work{file, about["project"].toString(),
        QDateTime::fromString(about["saved_utc"].toString(), Qt::ISODate),
        QFileInfo(file).lastModified().toUTC(), {},
        about["project_sha256"].toString().toStdString()};
    for (const auto &capture : project->content["captures"].toArray())
        work.recordings << QFileInfo(capture.toObject()["path"].toString()).fileName();
    if (!work.saved.isValid() || work.recordings.contains(QString()))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "%1 does not hold the work of a stopped program."),
                {file.toStdString()}});
    return work;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/project_hold.h"

#include "ui/session/file_lock.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSysInfo>

#include <algorithm>
#include <array>

#include <sys/stat.h>
#include <unistd.h>

namespace dyncal {

namespace {

constexpr const char *kHoldFormat = "dyncal-hold";
/// Names of people and machines; anything longer is another kind of file.
constexpr qint64 kLongest_bytes = 4096;

/// What a hold file says.
struct HoldText
{
    ProjectHolder holder;
    QByteArray boot; ///< of the machine: its own locks reach all programs since that start
};

QByteArray bytesOf(const HoldText &text)
{
    const QJsonObject json{{"format", kHoldFormat},
        {"name", QString::fromStdString(text.holder.name)},
        {"machine", QString::fromStdString(text.holder.machine)},
        {"since_utc", QString::fromStdString(text.holder.sinceUtc)},
        {"boot", QString::fromLatin1(text.boot)}};
    return QJsonDocument(json).toJson();
}

std::optional<HoldText> parsed(const QByteArray &bytes)
{
    const QJsonObject json = QJsonDocument::fromJson(bytes).object();
    if (json["format"] != QLatin1String(kHoldFormat))
        return std::nullopt;
    return HoldText{
        {json["name"].toString().toStdString(), json["machine"].toString().toStdString(),
            json["since_utc"].toString().toStdString()},
        json["boot"].toString().toLatin1()};
}

std::optional<HoldText> textIn(int file)
{
    QByteArray bytes(kLongest_bytes, '\0');
    const ssize_t got = ::pread(file, bytes.data(), kLongest_bytes, 0);
    return parsed(bytes.first(std::max<ssize_t>(got, 0)));
}

double seconds(const timespec &time)
{
    constexpr double kNano = 1e-9;
    return static_cast<double>(time.tv_sec) + kNano * static_cast<double>(time.tv_nsec);
}

/// Seconds since the file was touched, by the clock that touches it: that of the machine which has
/// the folder. The file keeps its time.
double silence_s(int file)
{
    struct stat before = {};
    struct stat now = {};
    if (::fstat(file, &before) != 0 || ::futimens(file, nullptr) != 0 || ::fstat(file, &now) != 0)
        return kLongestSilence_s;
    const std::array<timespec, 2> times{before.st_atim, before.st_mtim};
    (void)::futimens(file, times.data());
    return seconds(now.st_mtim) - seconds(before.st_mtim);
}

/// A file that could be locked, and still may be held by a machine that our locks do not reach.
bool isLeft(int file)
{
    const std::optional<HoldText> text = textIn(file);
    return !text || text->boot == QSysInfo::bootUniqueId() || silence_s(file) >= kLongestSilence_s;
}

QString beside(const QFileInfo &file)
{
    return QDir(file.absolutePath()).filePath('.' + file.fileName() + QStringLiteral(".held"));
}

} // namespace

ProjectHold::ProjectHold(const QString &file, std::unique_ptr<FileLock> lock)
    : m_file(file)
    , m_lock(std::move(lock))
{
}

ProjectHold::~ProjectHold() = default;

void ProjectHold::beat() const
{
    m_lock->touch();
}

QString holdFile(const QString &project)
{
    const QString target = QFileInfo(project).canonicalFilePath();
    return target.isEmpty() ? writtenHoldFile(project) : beside(QFileInfo(target));
}

QString writtenHoldFile(const QString &project)
{
    const QFileInfo named(project);
    const QString folder = QFileInfo(named.absolutePath()).canonicalFilePath();
    return beside(folder.isEmpty() ? named : QFileInfo(QDir(folder).filePath(named.fileName())));
}

HoldAnswer HoldAnswer::at(const QString &path, const ProjectHolder &who)
{
    if (auto lock = FileLock::take(path, isLeft)) {
        const bool isSaid = lock->write(bytesOf({who, QSysInfo::bootUniqueId()}));
        if (!isSaid) // on a full disk: nobody could be told by whom
            return {};
        return {std::shared_ptr<ProjectHold>(new ProjectHold(path, std::move(lock))), {}};
    }
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return {};
    const std::optional<HoldText> text = parsed(file.read(kLongest_bytes));
    return {{}, text ? text->holder : ProjectHolder()};
}

} // namespace dyncal

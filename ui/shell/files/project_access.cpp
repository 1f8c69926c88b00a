// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/files/project_access.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

namespace dyncal {

namespace {

/// Of an issued folder (docs/registry.md); it lists some ten files.
constexpr const char *kManifestName = "manifest.json";
constexpr const char *kManifestSchema = "dyncal-manifest/";
constexpr qint64 kLongestManifest_bytes = 1 << 20;

/// The certificate that a project was frozen with; 0: none.
qint64 certificateOf(const QFileInfo &project)
{
    QFile file(project.dir().filePath(kManifestName));
    if (!QFileInfo(file).isFile() || !file.open(QIODevice::ReadOnly))
        return 0;
    const QJsonObject manifest
        = QJsonDocument::fromJson(file.read(kLongestManifest_bytes)).object();
    const bool isIts = manifest["schema"].toString().startsWith(kManifestSchema)
        && manifest["files"].toObject().contains(project.fileName());
    return isIts ? manifest["number"].toInteger() : 0;
}

Message isFrozen(const std::string &project, qint64 number)
{
    return {
        DYNCAL_TEXT("core",
            "Project %1 belongs to the issued certificate %2, so it is read-only; save changes under another name and issue them as an amendment."),
        {project, std::to_string(number)}};
}

Message isHeld(const std::string &project, const ProjectHolder &other)
{
    if (other.name.empty())
        return {
            DYNCAL_TEXT("core",
                "Project %1 is open in another program, so it is read-only here; save changes under another name, or open it again once it is closed there."),
            {project}};
    return {
        DYNCAL_TEXT("core",
            "Project %1 is held by %2 on %3 since %4, so it is read-only here; save changes under another name, or open it again once it is closed there."),
        {project, other.name, other.machine, other.sinceUtc}};
}

ProjectAccess accessAt(const QString &place, const QString &name, const HoldRequest &request)
{
    if (request.own && request.own->file() == place)
        return {request.own, {}};
    if (!request.who)
        return {};
    const HoldAnswer answer = HoldAnswer::at(place, *request.who);
    if (answer.other)
        return {{}, isHeld(name.toStdString(), *answer.other)};
    return {answer.hold, {}};
}

} // namespace

ProjectAccess accessTo(const QString &project, const HoldRequest &request)
{
    const QFileInfo file(project);
    const QFileInfo target(file.canonicalFilePath());
    const qint64 number = certificateOf(target.exists() ? target : file);
    if (number > 0)
        return {{}, isFrozen(file.fileName().toStdString(), number)};
    return accessAt(holdFile(project), file.fileName(), request);
}

ProjectAccess accessToSave(const QString &project, const HoldRequest &request)
{
    ProjectAccess access = accessTo(project, request);
    const QString written = writtenHoldFile(project);
    if (access.readOnly || written == holdFile(project))
        return access;
    return accessAt(written, QFileInfo(project).fileName(), request);
}

Result<OpenedProject> openedProject(const QString &path, const QStringList &otherFolders,
    const HoldRequest &request, const JobControl &control)
{
    // Held before it is read: what is read stays as it is.
    ProjectAccess access = accessTo(path, request);
    const Result<ProjectFile> file = readProjectFile(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    Result<ProjectState> state = openProject(*file, control, otherFolders);
    if (!state)
        return tl::unexpected<Error>(state.error());
    return OpenedProject{std::move(*state), file->sha256, std::move(access), olderVersion(*file)};
}

} // namespace dyncal

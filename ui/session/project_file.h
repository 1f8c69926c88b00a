// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "ui/session/project_state.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <optional>
#include <string>

namespace dyncal {

/// Of an error: recordings of a project are not where they were.
inline constexpr const char *kMissingRecordings = "FIL-002";

/// Of a warning: a project of an older version.
inline constexpr const char *kOlderProject = "FIL-003";

/// The version of project files that this program writes. It goes up with the first change that
/// earlier programs cannot read; once for all that is released together.
/// 1: 0.1.0 up to certificates that are exported. 2: certificates that are issued; values of other
/// calibrations (`response.known`).
inline constexpr int kProjectVersion = 2;

/// What is known of a project file: the SHA-256 of its bytes, nullopt if there is none.
using ProjectFileHash = std::optional<std::string>;

/// The hash of the file as it is now; an empty string if something of that name cannot be read.
ProjectFileHash projectFileHash(const QString &path);

/// Writes the job as a project file (JSON: format, version, recipe, checksums, and the recordings
/// by path relative to the project and the SHA-256 that they were taken in with; never the
/// recordings themselves) in the place of the file that has the hash `expected`. Returns the hash
/// of the file written. `moreKeys` are written beside the job. Fails (Usage, finding
/// kChangedMeanwhile) if another file is there, or (FileUnreadable) naming the file and why.
Result<std::string> saveProject(const QString &path, const ProjectState &state,
    const ProjectFileHash &expected, const QJsonObject &moreKeys = {});

/// A project as it was read, all from the same bytes.
struct ProjectFile
{
    QString path;
    QJsonObject content;
    std::string sha256; ///< of the file's bytes
    int version = kProjectVersion;
};

/// Fails when the file is no project or of a newer version.
Result<ProjectFile> readProjectFile(const QString &path);

/// kOlderProject (caution) of a project of an older version: saving it writes it anew. It is of the
/// file, not of the job, and no result depends on it.
std::optional<Finding> olderVersion(const ProjectFile &file);

/// Opens the recordings of a project, so that they can be shown; they are not sealed. Fails when
/// recordings are missing (all are named; finding kMissingRecordings). Sealing finds a recording
/// whose bytes have changed since (CAP-015, which blocks). A project that was changed by others is
/// a caution (PRJ-001). Recordings that are not where they were are taken from the first of
/// `otherFolders` that has one of the name.
Result<ProjectState> openProject(
    const ProjectFile &file, const JobControl &control = {}, const QStringList &otherFolders = {});

/// Reads a project and opens it.
Result<ProjectState> openProject(
    const QString &path, const JobControl &control = {}, const QStringList &otherFolders = {});

/// The bytes of a project file for `folder`; `moreKeys` are ignored when it is opened. Recordings
/// that are not sealed yet are written without a hash.
QByteArray projectBytes(
    const ProjectState &state, const QString &folder, const QJsonObject &moreKeys = {});

/// The bytes of the project of an issued certificate: recordings by name and hash, never by a path.
/// It is opened where they lie beside it.
QByteArray frozenProjectBytes(const ProjectState &state);

Result<Recipe> recipeOfProject(const QJsonObject &project);

} // namespace dyncal

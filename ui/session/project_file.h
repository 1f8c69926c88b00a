// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "ui/session/project_state.h"

#include <QJsonObject>
#include <QString>

namespace dyncal {

/// Writes the job as a project file (JSON: format, version, recipe, and the recordings by path
/// relative to the project and the SHA-256 that they were taken in with; never the recordings
/// themselves). Through a temporary file that replaces the old one when complete. Fails
/// (FileUnreadable) naming the file and why.
Result<void> saveProject(const QString &path, const ProjectState &state);

/// Reads a project and opens its recordings, which can be shown then; they are not sealed. Fails
/// when the file is no project, is of a newer version, or when recordings are missing (all are
/// named). Sealing finds a recording whose bytes have changed since (CAP-015, which blocks).
/// Recordings that are not where they were are taken from `otherFolder`, if that is given, by name.
Result<ProjectState> openProject(
    const QString &path, const JobControl &control = {}, const QString &otherFolder = {});

/// The bytes of a project file for `folder`; `moreKeys` are passed over when it is opened. Of
/// recordings that are not sealed yet it keeps no hash.
QByteArray projectBytes(
    const ProjectState &state, const QString &folder, const QJsonObject &moreKeys = {});

/// A project file as it is written, its recordings not looked at. Fails as openProject does.
Result<QJsonObject> readProjectObject(const QString &path);
Result<Recipe> recipeOfProject(const QJsonObject &project);

} // namespace dyncal

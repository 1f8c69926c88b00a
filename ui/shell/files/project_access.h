// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/project_file.h"
#include "ui/session/project_hold.h"

namespace dyncal {

/// Who opens projects here; nobody is told without a name. `own` is kept where it holds the project
/// that is asked for.
struct HoldRequest
{
    std::optional<ProjectHolder> who;
    std::shared_ptr<ProjectHold> own;
};

/// Whether a project may be saved where it lies.
struct ProjectAccess
{
    std::shared_ptr<ProjectHold> hold; ///< others are told that it is open here
    std::optional<Message> readOnly; ///< why it may not
};

/// Read-only is a project that somebody else has open, and one that belongs to an issued
/// certificate (manifest.json lies beside it).
ProjectAccess accessTo(const QString &project, const HoldRequest &request);

/// Of a project that is about to be saved under this name: nobody else has open what the name leads
/// to, and the hold is on the file that is written.
ProjectAccess accessToSave(const QString &project, const HoldRequest &request);

/// A project as it was opened.
struct OpenedProject
{
    ProjectState state;
    std::string sha256; ///< of the file that was read
    ProjectAccess access;
    std::optional<Finding> older; ///< olderVersion()
};

/// As openProject().
Result<OpenedProject> openedProject(const QString &path, const QStringList &otherFolders,
    const HoldRequest &request, const JobControl &control);

} // namespace dyncal

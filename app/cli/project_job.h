// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/project_file.h"

#include <string>

namespace dyncal {

/// Opens a project and seals its recordings, with progress on stderr, and what is to be said of a
/// project of an older version. Fails as openProject() and
/// sealCaptures() do, and (FileUnreadable) on a name that is not valid UTF-8.
Result<ProjectState> readProjectJob(const std::string &path);

/// The same of a project that was read; nothing is said of its version.
Result<ProjectState> readProjectJob(const ProjectFile &file);

} // namespace dyncal

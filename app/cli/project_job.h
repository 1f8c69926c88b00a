// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/project_state.h"

#include "core/base/result.h"

#include <string>

namespace dyncal {

/// Opens a project and seals its recordings, with progress on stderr. Fails as openProject() and
/// sealCaptures() do, and (FileUnreadable) on a name that is not valid UTF-8.
Result<ProjectState> readProjectJob(const std::string &path);

} // namespace dyncal

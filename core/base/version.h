// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Version of the program ("0.1.0") and the build's id (commit, or "unknown").
const char *versionText();
const char *buildText();

} // namespace dyncal

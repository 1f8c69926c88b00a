// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace dyncal {

/// Puts a completely written temporary file in the place of `path`: flushed to disk, renamed over
/// whatever was there, and the folder flushed, so that after a crash either the old file or the
/// new one is there, whole. Both must lie in the same folder. False if any step failed.
bool moveIntoPlace(const std::string &temporary, const std::string &path);

} // namespace dyncal

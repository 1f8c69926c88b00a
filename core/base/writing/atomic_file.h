// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// Writes a file whole or not at all: a temporary file beside it, flushed, renamed, the folder
/// flushed (core/base/writing/pending_file.h). An existing regular file is replaced and keeps its
/// permissions; a link is replaced itself, never its target; anything else of that name (a folder,
/// a device, a pipe) is refused. On failure what was there before is untouched. Fails (Usage) where
/// the place cannot be written to or another program writes this file now, (Internal) where writing
/// fails, e.g. on a full disk.
Result<void> writeFileAtomically(const std::string &path, std::string_view bytes);

/// The same for a file whose content must still have this SHA-256 (nullopt: there must be no file).
/// Fails (Usage, finding kChangedMeanwhile) if it is not.
Result<void> replaceUnchangedFile(const std::string &path, std::string_view bytes,
    const std::optional<std::string> &expectedSha256);

} // namespace dyncal

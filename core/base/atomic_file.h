// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace dyncal {

/// Writes a file whole or not at all: a temporary file beside it, fsync, rename, fsync of the
/// folder. An existing regular file is replaced; anything else of that name (a folder, a device, a
/// pipe) is refused. On failure the temporary is removed and what was there before is untouched.
/// Fails (Usage) where the place cannot be written to, (Internal) where writing fails, e.g. on a
/// full disk.
Result<void> writeFileAtomically(const std::string &path, std::string_view bytes);

} // namespace dyncal

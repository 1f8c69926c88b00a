// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>
#include <vector>

namespace dyncal {

/// Paths of the files that a folder stands for where recordings are named: all regular files
/// directly in it but hidden ones and those that only accompany others (.tdms_index), in natural
/// order. Whether they can be read is not looked at. Fails with CAP-018 (FileUnreadable) if the
/// folder cannot be listed.
Result<std::vector<std::string>> filesOfFolder(const std::string &folder);

} // namespace dyncal

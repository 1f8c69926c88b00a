// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <sys/types.h>

namespace dyncal {

inline constexpr mode_t kFolderMode = 0777; ///< of a new folder, less the process's umask
inline constexpr mode_t kPermissions = 07777; ///< of a mode, the bits that chmod can set

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace dyncal {

enum class ClaimKind { File, Folder };

/// What a claim file says.
struct ClaimText
{
    std::string temporary; ///< name of the temporary file or folder
    ClaimKind kind = ClaimKind::File;
    std::string target; ///< name in the same folder, or "."
};

} // namespace dyncal

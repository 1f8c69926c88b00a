// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <string>
#include <vector>

namespace dyncal {

/// Where a folder lies.
struct FolderPlace
{
    std::string shown; ///< as given, for messages
    std::string path; ///< without links
    std::string claimFolder; ///< where claim and staging lie: the parent, or the folder itself
    std::string claimTarget; ///< its name there, or "."
    bool exists = false;
    std::vector<std::string> made; ///< parents that were made, the deepest last
};

/// Finds the place and makes the parents. Usage if it is no folder.
Result<FolderPlace> locateFolder(const std::string &folder);

} // namespace dyncal

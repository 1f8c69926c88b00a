// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/scratch_folder.h"

#include <filesystem>
#include <map>
#include <string>

namespace dyncal::testing {

/// Everything below a folder: relative name -> content, "-> target" of a link, "/" of a folder.
using Snapshot = std::map<std::string, std::string>;

inline Snapshot snapshotOf(const std::filesystem::path &folder)
{
    namespace fs = std::filesystem;
    Snapshot seen;
    std::error_code error;
    for (const auto &entry : fs::recursive_directory_iterator(folder, error)) {
        // Not fs::relative: that follows links, and a link would stand under its target's name.
        const std::string name = entry.path().lexically_relative(folder).string();
        if (entry.is_symlink())
            seen[name] = "-> " + fs::read_symlink(entry.path()).string();
        else if (entry.is_directory())
            seen[name] = "/";
        else if (entry.is_regular_file())
            seen[name] = contentOf(entry.path().string());
        else
            seen[name] = "other";
    }
    return seen;
}

/// Temporary files and claims that writers left anywhere below.
inline int straysIn(const std::filesystem::path &folder)
{
    int strays = 0;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
        strays += entry.path().filename().string().starts_with(".dyncal-") ? 1 : 0;
    return strays;
}

} // namespace dyncal::testing

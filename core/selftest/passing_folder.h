// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <filesystem>
#include <string>

namespace dyncal {

/// A folder of its own among the temporary ones, gone with all that is in it at the end.
class PassingFolder
{
public:
    PassingFolder(); ///< throws std::filesystem::filesystem_error where none can be made
    ~PassingFolder();
    PassingFolder(const PassingFolder &) = delete;
    PassingFolder &operator=(const PassingFolder &) = delete;

    std::string file(const std::string &name) const { return (m_path / name).string(); }

private:
    std::filesystem::path m_path;
};

} // namespace dyncal

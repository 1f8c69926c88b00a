// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/passing_folder.h"

#include "core/base/writing/temporary_name.h"

namespace dyncal {

namespace fs = std::filesystem;

PassingFolder::PassingFolder()
    : m_path(fs::temp_directory_path() / newTemporaryName())
{
    if (!fs::create_directory(m_path)) // somebody has that name
        throw fs::filesystem_error("folder", m_path, std::make_error_code(std::errc::file_exists));
    fs::permissions(m_path, fs::perms::owner_all);
}

PassingFolder::~PassingFolder()
{
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
}

} // namespace dyncal

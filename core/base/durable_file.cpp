// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/durable_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace dyncal {
namespace {

bool syncToDisk(const std::string &path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    const bool synced = ::fsync(descriptor) == 0;
    return ::close(descriptor) == 0 && synced;
}

} // namespace

bool moveIntoPlace(const std::string &temporary, const std::string &path)
{
    if (!syncToDisk(temporary))
        return false;
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    return !error && syncToDisk(folder.empty() ? "." : folder.string());
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/reference_source.h"

#include "core/base/content_hash.h"

#include <filesystem>
#include <fstream>
#include <utility>

namespace dyncal {

void loadReference(const std::string &folder, ComparisonSettings &settings)
{
    constexpr std::size_t kLargest = std::size_t(16) << 20U;
    settings.loaded.reset();
    if (settings.source.empty())
        return;
    const std::filesystem::path path = std::filesystem::path(folder) / settings.source;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > kLargest)
        return;
    std::ifstream file(path, std::ios::binary);
    std::string content(static_cast<std::size_t>(size), '\0');
    if (!file.read(content.data(), static_cast<std::streamsize>(size)))
        return;
    const std::string hash = sha256Hex(content);
    settings.loaded
        = std::make_shared<const ReferenceSource>(ReferenceSource{hash, std::move(content)});
}

} // namespace dyncal

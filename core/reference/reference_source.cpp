// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/reference_source.h"

#include "core/base/content_hash.h"

#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

namespace dyncal {
namespace {

constexpr std::string_view kKeptFolder = "sources/";
constexpr std::size_t kKeptDigits = 16; ///< of the hash: enough to tell files apart

} // namespace

std::shared_ptr<const ReferenceSource> sourceAt(
    const std::string &folder, const std::string &source)
{
    constexpr std::size_t kLargest = std::size_t(16) << 20U;
    const std::filesystem::path path = std::filesystem::path(folder) / source;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > kLargest)
        return nullptr;
    std::ifstream file(path, std::ios::binary);
    std::string content(static_cast<std::size_t>(size), '\0');
    if (!file.read(content.data(), static_cast<std::streamsize>(size)))
        return nullptr;
    const std::string hash = sha256Hex(content);
    return std::make_shared<const ReferenceSource>(ReferenceSource{hash, std::move(content)});
}

std::string keptSourceName(const std::string &source, const std::string &sha256)
{
    return std::string(kKeptFolder) + sha256.substr(0, kKeptDigits) + "-"
        + std::filesystem::path(source).filename().string();
}

bool isKeptSourceName(const std::string &name)
{
    if (!name.starts_with(kKeptFolder))
        return false;
    const std::string file = name.substr(kKeptFolder.size());
    return file.size() > kKeptDigits + 1 && file.find('/') == std::string::npos
        && file.find_first_not_of("0123456789abcdef") == kKeptDigits && file[kKeptDigits] == '-';
}

} // namespace dyncal

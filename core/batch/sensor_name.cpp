// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/sensor_name.h"

#include "core/base/content_hash.h"

namespace dyncal {
namespace {

constexpr std::size_t kLongestName = 150; // file systems allow 255 bytes, some with less
constexpr std::size_t kHashDigits = 32;
constexpr std::string_view kSpecial = "+%\\:*?\"'`$<>|~ ";

bool isKept(char c, bool isFirst)
{
    const auto byte = static_cast<unsigned char>(c);
    return byte > 0x20 && byte != 0x7f && kSpecial.find(c) == std::string_view::npos
        && !(isFirst && (c == '.' || c == '-'));
}

std::string escapedByte(char c)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    return {'%', kDigits[byte / 16], kDigits[byte % 16]};
}

/// Whether the byte continues a character of UTF-8.
bool isContinued(char c)
{
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

std::string shortened(std::string name, std::string_view id)
{
    std::size_t end = kLongestName - kHashDigits - 1;
    while (end > 0 && isContinued(name[end]))
        --end;
    name.resize(end);
    return name.append("~").append(sha256Hex(id), 0, kHashDigits);
}

} // namespace

std::string sensorFolderName(std::string_view id)
{
    std::string name;
    for (const char c : id) {
        if (c == '/')
            name += '+';
        else
            name += isKept(c, name.empty()) ? std::string(1, c) : escapedByte(c);
    }
    return name.size() <= kLongestName ? name : shortened(std::move(name), id);
}

} // namespace dyncal

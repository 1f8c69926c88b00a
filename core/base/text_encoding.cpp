// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/text_encoding.h"

#include <array>
#include <cstdint>

namespace dyncal {
namespace {

void appendUtf8(std::string &text, std::uint32_t code)
{
    const auto byte = [&](std::uint32_t value) { text += static_cast<char>(value); };
    if (code < 0x80) {
        byte(code);
    } else if (code < 0x800) {
        byte(0xC0 | code >> 6);
        byte(0x80 | (code & 0x3F));
    } else {
        byte(0xE0 | code >> 12);
        byte(0x80 | (code >> 6 & 0x3F));
        byte(0x80 | (code & 0x3F));
    }
}

std::uint32_t byteAt(std::string_view text, std::size_t i)
{
    return static_cast<unsigned char>(text[i]);
}

/// Length of the UTF-8 sequence that starts here, 0 if there is none.
std::size_t sequenceLength(std::string_view text)
{
    const std::uint32_t lead = byteAt(text, 0);
    const std::size_t length = lead < 0x80 ? 1
        : lead >= 0xC2 && lead < 0xE0      ? 2
        : lead >= 0xE0 && lead < 0xF0      ? 3
        : lead >= 0xF0 && lead < 0xF5      ? 4
                                           : 0;
    if (length > text.size())
        return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byteAt(text, i) & 0xC0) != 0x80)
            return 0;
    }
    return length;
}

/// Windows-1252 differs from Latin-1 in 0x80..0x9F only.
std::uint32_t windows1252(std::uint32_t byte)
{
    static constexpr std::array<std::uint16_t, 32> kUpper{0x20AC, 0x81, 0x201A, 0x192, 0x201E,
        0x2026, 0x2020, 0x2021, 0x2C6, 0x2030, 0x160, 0x2039, 0x152, 0x8D, 0x17D, 0x8F, 0x90,
        0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0x2DC, 0x2122, 0x161, 0x203A, 0x153,
        0x9D, 0x17E, 0x178};
    return byte >= 0x80 && byte < 0xA0 ? kUpper[byte - 0x80] : byte;
}

} // namespace

ByteOrder byteOrderOf(std::string_view bytes)
{
    if (bytes.starts_with("\xFF\xFE"))
        return ByteOrder::LittleEndian;
    if (bytes.starts_with("\xFE\xFF"))
        return ByteOrder::BigEndian;
    if (bytes.size() < 4 || (bytes[0] == '\0') == (bytes[1] == '\0')
        || (bytes[0] == '\0') != (bytes[2] == '\0') || (bytes[1] == '\0') != (bytes[3] == '\0'))
        return ByteOrder::None;
    return bytes[1] == '\0' ? ByteOrder::LittleEndian : ByteOrder::BigEndian;
}

std::string fromUtf16(std::string_view bytes, bool bigEndian)
{
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
        bytes.remove_prefix(2);
    std::string text;
    text.reserve(bytes.size() / 2);
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        const std::uint32_t first = byteAt(bytes, i);
        const std::uint32_t second = byteAt(bytes, i + 1);
        appendUtf8(text, bigEndian ? first << 8 | second : second << 8 | first);
    }
    return text;
}

bool isUtf8(std::string_view text)
{
    while (!text.empty()) {
        const std::size_t length = sequenceLength(text);
        if (length == 0)
            return false;
        text.remove_prefix(length);
    }
    return true;
}

std::string utf8Text(std::string_view text)
{
    if (isUtf8(text))
        return std::string(text);
    std::string converted;
    for (std::size_t i = 0; i < text.size(); ++i)
        appendUtf8(converted, windows1252(byteAt(text, i)));
    return converted;
}

} // namespace dyncal

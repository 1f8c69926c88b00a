// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text_bytes.h"

#include "core/capture/formats/large_pages.h"
#include "core/capture/formats/text_source.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <new>
#include <span>
#include <system_error>

namespace dyncal {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t(8) << 30;
constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

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

enum class ByteOrder { None, LittleEndian, BigEndian };

/// UTF-16 is known by its mark, or by two ASCII characters at the beginning.
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

/// Numbers and headers are in the basic plane; a lone half of a pair becomes three odd bytes.
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

/// Windows-1252 differs from Latin-1 in 0x80..0x9F only.
std::uint32_t windows1252(std::uint32_t byte)
{
    static constexpr std::array<std::uint16_t, 32> kUpper{0x20AC, 0x81, 0x201A, 0x192, 0x201E,
        0x2026, 0x2020, 0x2021, 0x2C6, 0x2030, 0x160, 0x2039, 0x152, 0x8D, 0x17D, 0x8F, 0x90,
        0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0x2DC, 0x2122, 0x161, 0x203A, 0x153,
        0x9D, 0x17E, 0x178};
    return byte >= 0x80 && byte < 0xA0 ? kUpper[byte - 0x80] : byte;
}

tl::unexpected<Error> tooLarge(const std::string &path, std::uintmax_t size)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 has %2 bytes, which is too large for a text; export a shorter part, or as "
             "HDF5 "
             "capture."),
            {path, std::to_string(size)}},
        "CAP-018");
}

} // namespace

tl::unexpected<Error> unreadableText(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core", "%1 cannot be read; check that it exists and may be opened."), {path}},
        "CAP-018");
}

FileText::FileText(std::size_t size)
{
    const std::size_t bytes = (size / kLargePage + 1) * kLargePage;
    m_bytes.reset(static_cast<char *>(std::aligned_alloc(kLargePage, bytes)));
    if (!m_bytes)
        throw std::bad_alloc();
    preferLargePages(m_bytes.get(), bytes);
    m_text = {m_bytes.get(), size};
}

Result<FileText> readTextFile(const std::string &path)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    if (error || !file)
        return unreadableText(path);
    if (size > kLargestFile)
        return tooLarge(path, size);
    FileText text(size);
    file.read(text.data(), static_cast<std::streamsize>(size));
    if (!file || static_cast<std::uintmax_t>(file.gcount()) != size)
        return unreadableText(path);
    const ByteOrder order = byteOrderOf(text.view());
    if (order == ByteOrder::None) {
        text.skip(text.view().starts_with(kUtf8Mark) ? kUtf8Mark.size() : 0);
        return text;
    }
    const std::string converted = fromUtf16(text.view(), order == ByteOrder::BigEndian);
    FileText utf8(converted.size());
    converted.copy(utf8.data(), converted.size());
    return utf8;
}

Result<TextSource> openText(const std::string &path)
{
    const auto file = SampleFile::open(path);
    std::array<char, 4> head{};
    const std::size_t count = file ? std::min<std::size_t>(head.size(), (*file)->size()) : 0;
    if (!file || !(*file)->read(0, count, std::as_writable_bytes(std::span(head)).data()))
        return unreadableText(path);
    if ((*file)->size() > kLargestFile)
        return tooLarge(path, (*file)->size());
    const std::string_view begin(head.data(), count);
    if (byteOrderOf(begin) == ByteOrder::None)
        return TextSource(*file, begin.starts_with(kUtf8Mark) ? kUtf8Mark.size() : 0);
    return readTextFile(path).map([](FileText text) { return TextSource(std::move(text)); });
}

Result<TextHead> readTextHead(const std::string &path, std::size_t bytes)
{
    std::ifstream file(path, std::ios::binary);
    std::string head(bytes, '\0');
    file.read(head.data(), static_cast<std::streamsize>(bytes));
    if (!file.is_open() || file.bad() || (!file.eof() && file.fail()))
        return unreadableText(path);
    head.resize(static_cast<std::size_t>(file.gcount()));
    TextHead result;
    result.whole = file.eof() || file.peek() == std::ifstream::traits_type::eof();
    const bool utf16 = byteOrderOf(head) != ByteOrder::None;
    result.text = textOfBytes(std::move(head));
    const std::size_t lastEnd = result.text.find_last_of("\r\n");
    if (!result.whole && lastEnd != std::string::npos)
        result.text.resize(lastEnd + 1);
    result.encoding = utf16 ? "UTF-16" : isUtf8(result.text) ? "UTF-8" : "Windows-1252";
    return result;
}

std::string textOfBytes(std::string bytes)
{
    const ByteOrder order = byteOrderOf(bytes);
    if (order != ByteOrder::None)
        return fromUtf16(bytes, order == ByteOrder::BigEndian);
    if (bytes.starts_with(kUtf8Mark))
        bytes.erase(0, kUtf8Mark.size());
    return bytes;
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

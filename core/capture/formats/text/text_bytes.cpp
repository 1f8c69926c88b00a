// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/text_bytes.h"

#include "core/base/text_encoding.h"
#include "core/capture/formats/bytes/large_pages.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <new>
#include <system_error>

namespace dyncal {
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t(8) << 30;

} // namespace

tl::unexpected<Error> unreadableText(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core", "%1 cannot be read; check that it exists and may be opened."), {path}},
        "CAP-018");
}

Result<void> checkTextSize(const std::string &path, std::uint64_t bytes)
{
    if (bytes <= kLargestFile)
        return {};
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 has %2 bytes, which is too large for a text; export a shorter part, or as HDF5 capture."),
            {path, std::to_string(bytes)}},
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
    if (const Result<void> fits = checkTextSize(path, size); !fits)
        return tl::unexpected(fits.error());
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

} // namespace dyncal

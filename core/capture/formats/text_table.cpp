// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>

namespace dyncal {
namespace {

constexpr std::string_view kBlanks = " \t";

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

/// Numbers and headers are in the basic plane; a lone half of a pair becomes three odd bytes.
std::string fromUtf16(std::string_view bytes, bool bigEndian)
{
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

/// from_chars on the whole text, with the way values that are too small or written "+1" go.
CellKind readPlainNumber(const char *begin, const char *end, double &value)
{
    if (begin != end && *begin == '+')
        ++begin;
    const auto read = std::from_chars(begin, end, value);
    if (read.ptr != end || read.ec == std::errc::invalid_argument)
        return CellKind::Unreadable;
    if (read.ec == std::errc::result_out_of_range) {
        const void *exponent = std::memchr(begin, '-', static_cast<std::size_t>(end - begin));
        if (exponent == nullptr || exponent == begin)
            return CellKind::Unreadable; // too large: that is no measured value
        value = 0.0;
    }
    return CellKind::Number;
}

tl::unexpected<Error> cannotRead(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core", "%1 cannot be read; check that it exists and may be opened."), {path}},
        "CAP-018");
}

} // namespace

Result<std::string> readTextFile(const std::string &path)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    std::string text;
    if (!error && file) {
        text.resize(size);
        file.read(text.data(), static_cast<std::streamsize>(size));
    }
    if (error || !file || static_cast<std::uintmax_t>(file.gcount()) != size)
        return cannotRead(path);
    return textOfBytes(std::move(text));
}

Result<TextHead> readTextHead(const std::string &path, std::size_t bytes)
{
    std::ifstream file(path, std::ios::binary);
    std::string head(bytes, '\0');
    file.read(head.data(), static_cast<std::streamsize>(bytes));
    if (!file.is_open() || file.bad() || (!file.eof() && file.fail()))
        return cannotRead(path);
    head.resize(static_cast<std::size_t>(file.gcount()));
    TextHead result;
    result.whole = file.eof() || file.peek() == std::ifstream::traits_type::eof();
    const bool utf16 = head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF");
    result.text = textOfBytes(std::move(head));
    const std::size_t lastEnd = result.text.find_last_of("\r\n");
    if (!result.whole && lastEnd != std::string::npos)
        result.text.resize(lastEnd + 1);
    result.encoding = utf16 ? "UTF-16" : isUtf8(result.text) ? "UTF-8" : "Windows-1252";
    return result;
}

std::string textOfBytes(std::string bytes)
{
    if (bytes.starts_with("\xEF\xBB\xBF"))
        bytes.erase(0, 3);
    else if (bytes.starts_with("\xFF\xFE"))
        return fromUtf16(std::string_view(bytes).substr(2), false);
    else if (bytes.starts_with("\xFE\xFF"))
        return fromUtf16(std::string_view(bytes).substr(2), true);
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

std::string lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && kBlanks.find(text.front()) != std::string_view::npos)
        text.remove_prefix(1);
    while (!text.empty() && kBlanks.find(text.back()) != std::string_view::npos)
        text.remove_suffix(1);
    return text;
}

bool LineCursor::next(std::string_view &line)
{
    if (m_rest.empty())
        return false;
    ++m_number;
    std::size_t end = 0;
    while (end < m_rest.size() && m_rest[end] != '\n' && m_rest[end] != '\r')
        ++end;
    m_terminated = end < m_rest.size();
    line = m_rest.substr(0, end);
    if (!m_terminated) {
        m_rest = {};
        return true;
    }
    const bool pair = m_rest.substr(end).starts_with("\r\n");
    m_rest.remove_prefix(end + (pair ? 2 : 1));
    return true;
}

CellCursor::CellCursor(std::string_view line, char separator)
    : m_rest(separator == kBlankSeparator ? trimmed(line) : line)
    , m_separator(separator)
    , m_more(separator != kBlankSeparator || !m_rest.empty())
{
}

bool CellCursor::next(std::string_view &cell)
{
    if (!m_more)
        return false;
    const bool blanks = m_separator == kBlankSeparator;
    const std::size_t end = blanks ? m_rest.find_first_of(kBlanks) : m_rest.find(m_separator);
    cell = trimmed(m_rest.substr(0, end));
    m_more = end != std::string_view::npos;
    if (m_more)
        m_rest.remove_prefix(end + 1);
    if (blanks)
        m_rest = trimmed(m_rest);
    return true;
}

std::vector<std::string_view> cellsOf(std::string_view line, char separator)
{
    std::vector<std::string_view> cells;
    CellCursor cursor(line, separator);
    for (std::string_view cell; cursor.next(cell);)
        cells.push_back(cell);
    return cells;
}

bool isBlankRow(std::string_view line, char separator)
{
    return std::all_of(line.begin(), line.end(),
        [separator](char c) { return c == ' ' || c == '\t' || c == '\f' || c == separator; });
}

CellKind readCell(std::string_view cell, char decimal, double &value)
{
    if (cell.empty())
        return CellKind::Empty;
    const std::size_t mark = decimal == '.' ? std::string_view::npos : cell.find(decimal);
    if (decimal != '.' && cell.find('.') != std::string_view::npos)
        return CellKind::Unreadable;
    if (mark == std::string_view::npos)
        return readPlainNumber(cell.data(), cell.data() + cell.size(), value);
    std::array<char, 64> buffer;
    const bool digitBehind
        = mark + 1 < cell.size() && cell[mark + 1] >= '0' && cell[mark + 1] <= '9';
    if (cell.size() > buffer.size() || !digitBehind)
        return CellKind::Unreadable; // "1," is a list of one, not a number
    cell.copy(buffer.data(), cell.size());
    buffer[mark] = '.';
    return readPlainNumber(buffer.data(), buffer.data() + cell.size(), value);
}

void SampleColumn::addValue(double value)
{
    if (m_pendingEmpty > 0)
        m_values.insert(m_values.end(), static_cast<std::size_t>(m_pendingEmpty),
            std::numeric_limits<double>::quiet_NaN());
    m_pendingEmpty = 0;
    m_values.push_back(value);
}

tl::unexpected<Error> unreadableCell(
    const std::string &path, Index line, Index column, std::string_view cell)
{
    constexpr std::size_t kShown = 40;
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1, line %2, column %3: \"%4\" is no number; correct the cell, or set decimal, "
             "separator or skip_rows in the recipe's import section."),
            {path, std::to_string(line), std::to_string(column), utf8Text(cell.substr(0, kShown))}},
        "CAP-018");
}

tl::unexpected<Error> noRowsOfNumbers(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 holds no rows of numbers that fit together; check separator, decimal and "
             "skip_rows in the recipe's import section."),
            {path}},
        "CAP-001");
}

} // namespace dyncal

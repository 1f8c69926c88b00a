// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/text_table.h"

#include "core/base/ascii_text.h"
#include "core/base/text_encoding.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <limits>

namespace dyncal {
namespace {

constexpr std::string_view kBlanks = " \t";

const char *firstOf(char c, const char *begin, const char *end)
{
    const void *found = std::memchr(begin, c, static_cast<std::size_t>(end - begin));
    return found != nullptr ? static_cast<const char *>(found) : end;
}

/// Whether a number that no double can hold is too small for it, not too large: its first digit
/// that is not zero stands behind the mark once the exponent has moved it.
bool isTooSmall(std::string_view number)
{
    constexpr double kBeyondAll = 1e300;
    const std::size_t end = std::min(number.find_first_of("eE"), number.size());
    const std::size_t mark = std::min(number.find('.'), end);
    const auto places
        = static_cast<double>(mark) - static_cast<double>(number.find_first_of("123456789"));
    number.remove_prefix(std::min(end + 1, number.size()));
    double exponent = number.starts_with('-') ? -kBeyondAll : kBeyondAll;
    if (number.empty())
        exponent = 0.0;
    else if (number.starts_with('+'))
        number.remove_prefix(1);
    std::from_chars(number.data(), number.data() + number.size(), exponent);
    return places + exponent < 0.0;
}

/// from_chars on the whole text; also accepts "+1" and values too small for a double (0).
CellKind readPlainNumber(const char *begin, const char *end, double &value)
{
    const bool plus = begin != end && *begin == '+';
    if (plus && (++begin == end || *begin == '-'))
        return CellKind::Unreadable;
    const auto read = std::from_chars(begin, end, value);
    if (read.ptr != end || read.ec == std::errc::invalid_argument)
        return CellKind::Unreadable;
    if (read.ec == std::errc::result_out_of_range) {
        if (!isTooSmall({begin, static_cast<std::size_t>(end - begin)}))
            return CellKind::Unreadable; // too large: that is no measured value
        value = *begin == '-' ? -0.0 : 0.0;
    }
    return CellKind::Number;
}

} // namespace

bool LineCursor::next(std::string_view &line)
{
    if (m_rest.empty())
        return false;
    ++m_number;
    const char *const begin = m_rest.data();
    const char *const end = begin + m_rest.size();
    if (m_lineFeed == nullptr || m_lineFeed < begin)
        m_lineFeed = firstOf('\n', begin, end);
    const char *const lineEnd = firstOf('\r', begin, m_lineFeed);
    m_terminated = lineEnd != end;
    line = {begin, static_cast<std::size_t>(lineEnd - begin)};
    const bool pair = m_lineFeed - lineEnd == 1 && m_lineFeed != end;
    m_rest.remove_prefix(line.size() + (m_terminated ? 1 : 0) + (pair ? 1 : 0));
    return true;
}

void LineCursor::take(const char *behind, Index lines)
{
    m_rest.remove_prefix(static_cast<std::size_t>(behind - m_rest.data()));
    m_terminated = true;
    m_number += lines;
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
    if (nextQuoted(cell))
        return true;
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

/// A quoted cell ends with its closing quote; any other cell just contains quotes.
bool CellCursor::nextQuoted(std::string_view &cell)
{
    const std::string_view blanks = m_separator == '\t' ? " " : kBlanks;
    const std::size_t open = m_rest.find_first_not_of(blanks);
    if (open == std::string_view::npos || m_rest[open] != '"')
        return false;
    std::size_t close = m_rest.find('"', open + 1);
    while (close != std::string_view::npos && m_rest.substr(close + 1).starts_with('"'))
        close = m_rest.find('"', close + 2);
    if (close == std::string_view::npos)
        return false;
    const std::string_view behind = m_rest.substr(close + 1);
    const std::size_t next = behind.find_first_not_of(blanks);
    const bool last = next == std::string_view::npos;
    const bool ends
        = last || (m_separator == kBlankSeparator ? next > 0 : behind[next] == m_separator);
    if (!ends)
        return false;
    cell = trimmed(m_rest.substr(open + 1, close - open - 1));
    m_more = !last;
    if (m_more)
        m_rest = behind.substr(m_separator == kBlankSeparator ? next : next + 1);
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

Index cellCount(std::string_view line, char separator)
{
    Index count = 0;
    CellCursor cursor(line, separator);
    for (std::string_view cell; cursor.next(cell);)
        ++count;
    return count;
}

bool isCommentLine(std::string_view line)
{
    line = trimmed(line);
    return line.starts_with('#') || line.starts_with('%');
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
    constexpr std::size_t kLongest = 1200; // longer than any double printed in full
    std::array<char, kLongest> buffer;
    const bool digitBehind
        = mark + 1 < cell.size() && cell[mark + 1] >= '0' && cell[mark + 1] <= '9';
    if (cell.size() > buffer.size() || !digitBehind)
        return CellKind::Unreadable; // "1," is a list of one, not a number
    cell.copy(buffer.data(), cell.size());
    buffer[mark] = '.';
    return readPlainNumber(buffer.data(), buffer.data() + cell.size(), value);
}

void SampleColumn::addValueAt(Index row, double value)
{
    if (row > size()) {
        const std::size_t rows = static_cast<std::size_t>(row);
        if (rows > 2 * m_values.capacity())
            m_values.reserve(rows + 1); // else push_back would double it
        m_values.resize(rows, std::numeric_limits<double>::quiet_NaN());
        m_hasGaps = true;
    }
    m_values.push_back(value);
}

tl::unexpected<Error> unreadableCell(
    const std::string &path, Index line, Index column, std::string_view cell)
{
    constexpr std::size_t kShown = 40;
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1, line %2, column %3: \"%4\" is no number; correct the cell, or set decimal, separator or skip_rows in the recipe's import section."),
            {path, std::to_string(line), std::to_string(column), utf8Text(cell.substr(0, kShown))}},
        "CAP-018");
}

tl::unexpected<Error> noRowsOfNumbers(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 holds no rows of numbers that fit together; check separator, decimal and skip_rows in the recipe's import section."),
            {path}},
        "CAP-001");
}

} // namespace dyncal

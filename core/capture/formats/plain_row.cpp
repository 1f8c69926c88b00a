// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/plain_row.h"

#include "core/capture/formats/text_table.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace dyncal {
namespace {

constexpr std::size_t kLongestLine = 64 * 1024; ///< no row of a real table is longer

const char *behindBlanks(const char *at, const char *end, char separator)
{
    while (at != end && (*at == ' ' || (*at == '\t' && separator != '\t')))
        ++at;
    return at;
}

bool startsNumber(char c)
{
    return (c >= '0' && c <= '9') || c == '-' || c == '.';
}

/// Reads one number; null if there is none or it is out of range.
const char *behindNumber(const char *at, const char *end, double &value)
{
    if (at != end && *at == '+')
        ++at;
    if (at == end || !startsNumber(*at))
        return nullptr;
    const auto read = std::from_chars(at, end, value);
    return read.ec == std::errc() ? read.ptr : nullptr;
}

} // namespace

bool PlainRowReader::usePoints(std::string_view line)
{
    if (line.empty() || std::memchr(line.data(), '.', line.size()) != nullptr)
        return false;
    m_scratch.assign(line);
    for (std::size_t at = 0; (at = m_scratch.find(m_decimal, at)) != std::string::npos; ++at) {
        const bool digitBehind
            = at + 1 < m_scratch.size() && m_scratch[at + 1] >= '0' && m_scratch[at + 1] <= '9';
        if (!digitBehind)
            return false; // "1," is no number
        m_scratch[at] = '.';
    }
    return true;
}

bool PlainRowReader::read(std::string_view line, std::span<double> row)
{
    if (line.size() > kLongestLine || (m_decimal != '.' && !usePoints(line)))
        return false;
    if (m_decimal != '.')
        line = m_scratch;
    const char *at = line.data();
    const char *const end = at + line.size();
    const bool byBlanks = m_separator == kBlankSeparator;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const char *const number = behindBlanks(at, end, m_separator);
        if (i > 0 && byBlanks && number == at)
            return false; // "1.5-2.5" is one cell
        at = behindNumber(number, end, row[i]);
        if (at == nullptr)
            return false;
        if (byBlanks || i + 1 == row.size())
            continue;
        at = behindBlanks(at, end, m_separator);
        if (at == end || *at != m_separator)
            return false;
        ++at;
    }
    at = behindBlanks(at, end, m_separator);
    while (at != end && *at == m_separator)
        at = behindBlanks(at + 1, end, m_separator);
    return at == end;
}

} // namespace dyncal

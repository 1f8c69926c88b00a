// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <span>
#include <string>
#include <string_view>

namespace dyncal {

/// The fast way through a table: rows that are nothing but numbers, as nearly all are. It reads
/// what CellCursor and readCell would read, several times as fast, or says that it cannot.
class PlainRowReader
{
public:
    PlainRowReader(char separator, char decimal)
        : m_separator(separator)
        , m_decimal(decimal)
    {
    }

    /// Fills `row` if the line has exactly as many cells, or empty ones behind, and all are plain
    /// numbers. On false nothing is known of the line, and `row` holds anything.
    bool read(std::string_view line, std::span<double> row);

private:
    bool usePoints(std::string_view line);

    char m_separator;
    char m_decimal;
    std::string m_scratch; ///< the line with decimal points
};

} // namespace dyncal

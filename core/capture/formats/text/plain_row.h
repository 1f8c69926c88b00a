// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace dyncal {

/// The fast way through a table: rows that are nothing but numbers, as nearly all are. It reads
/// what LineCursor, CellCursor and readCell would read, many times as fast, or says that it cannot.
class PlainRowReader
{
public:
    PlainRowReader(char separator, char decimal)
        : m_separator(separator)
        , m_decimal(decimal)
    {
    }

    /// Fills `row` if the text begins with a line of exactly as many numbers (empty cells behind
    /// them do not matter) and a line end; returns what stands behind that. Null otherwise, and
    /// `row` then holds anything.
    const char *read(std::string_view text, std::span<double> row) const;

    /// Reads such lines one behind the other, at most `most`: number i of row k to
    /// columns[i * most + k]. Returns how many; the text then begins behind them.
    std::size_t readRows(
        std::string_view &text, std::size_t numbers, double *columns, std::size_t most) const;

private:
    struct Target
    {
        double *first;
        std::size_t count;
        std::size_t distance; ///< from one to the next
    };

    const char *behindRow(const char *at, const char *end, const Target &row) const;
    const char *behindLine(const char *at, const char *end, const Target &row) const;

    char m_separator;
    char m_decimal;
};

} // namespace dyncal

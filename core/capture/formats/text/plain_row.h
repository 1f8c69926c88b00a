// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace dyncal {

/// The fast way through a table: rows that hold only numbers, as nearly all do. It gives the same
/// values as LineCursor, CellCursor and readCell, many times as fast, or reports that it cannot.
class PlainRowReader
{
public:
    PlainRowReader(char separator, char decimal)
        : m_separator(separator)
        , m_decimal(decimal)
    {
    }

    /// Fills `row` if the text begins with a line of exactly as many numbers (empty cells after
    /// them do not matter) and a line end; returns the place after that. Null otherwise; `row` is
    /// then undefined.
    const char *read(std::string_view text, std::span<double> row) const;

    /// Reads such lines, at most `most`: number i of row k goes to columns[i * most + k]. Returns
    /// how many; the text then begins after them.
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

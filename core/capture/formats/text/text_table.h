// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

// What readers of text files share: lines to cells to numbers, without any locale and without a
// string per cell.

/// Lines of a text that may end in LF, CR LF or CR.
class LineCursor
{
public:
    /// `before`: lines that stand before the text.
    explicit LineCursor(std::string_view text, Index before = 0)
        : m_rest(text)
        , m_number(before)
    {
    }

    /// The next line without its end; false at the end of the text.
    bool next(std::string_view &line);

    /// The text after the line just read.
    std::string_view rest() const { return m_rest; }

    /// Skips lines of rest() that were read elsewhere; `behind` is the end of the last one.
    void take(const char *behind, Index lines);

    Index number() const { return m_number; } ///< of the line just read, from 1
    bool terminated() const { return m_terminated; } ///< whether that line had an end

private:
    std::string_view m_rest;
    const char *m_lineFeed = nullptr; ///< the next one, or the end of the text
    Index m_number = 0;
    bool m_terminated = true;
};

/// Stands for "any run of blanks and tabs" where a separator is asked for.
constexpr char kBlankSeparator = ' ';

/// Cells of one line. A cell in double quotes is what stands between them, separators included.
class CellCursor
{
public:
    CellCursor(std::string_view line, char separator);

    /// The next cell, trimmed; false after the last one.
    bool next(std::string_view &cell);

private:
    bool nextQuoted(std::string_view &cell);

    std::string_view m_rest;
    char m_separator;
    bool m_more;
};

std::vector<std::string_view> cellsOf(std::string_view line, char separator);

/// Number of cells, without a list of them: a damaged file may be one line.
Index cellCount(std::string_view line, char separator);

/// Whether a line begins with "#" or "%".
bool isCommentLine(std::string_view line);

/// Whether a line holds nothing but blanks and separators.
bool isBlankRow(std::string_view line, char separator);

enum class CellKind { Number, Empty, Unreadable };

/// Reads a cell as a number with this decimal mark. "nan" is a number that is NaN.
CellKind readCell(std::string_view cell, char decimal, double &value);

/// Values of one channel, row by row. Rows without a value are invalid samples, except at the end,
/// where they are none.
class SampleColumn
{
public:
    /// `row` counts from 0 and must be at least size().
    void addValueAt(Index row, double value);

    Index size() const { return static_cast<Index>(m_values.size()); }
    const std::vector<double> &values() const { return m_values; }
    bool hasGaps() const { return m_hasGaps; }
    std::vector<double> take() { return std::move(m_values); }
    void reserve(Index rows) { m_values.reserve(static_cast<std::size_t>(rows)); }

private:
    std::vector<double> m_values;
    bool m_hasGaps = false;
};

/// "12,3x" in column 2 of line 17 is no number: CAP-018, naming all of it.
tl::unexpected<Error> unreadableCell(
    const std::string &path, Index line, Index column, std::string_view cell);

/// There is no table in the file: CAP-001.
tl::unexpected<Error> noRowsOfNumbers(const std::string &path);

} // namespace dyncal

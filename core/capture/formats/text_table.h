// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

// What readers of text files share: bytes to lines to cells to numbers, without any locale and
// without a string per cell.

/// The whole file as UTF-8 or single-byte text: a byte order mark is removed, UTF-16 is converted.
/// Fails (CAP-018) if it cannot be read.
Result<std::string> readTextFile(const std::string &path);

/// The same for bytes that are there already.
std::string textOfBytes(std::string bytes);

/// The beginning of a text file.
struct TextHead
{
    std::string text; ///< whole lines, unless the file is shorter or the first line longer
    std::string encoding; ///< "UTF-8", "UTF-16" or "Windows-1252"
    bool whole = false; ///< this is all of the file
};

/// At most `bytes` of the file. Fails as readTextFile.
Result<TextHead> readTextHead(const std::string &path, std::size_t bytes);

/// UTF-8 of a name or unit: left alone if it is valid UTF-8, otherwise taken as Windows-1252.
std::string utf8Text(std::string_view text);

/// ASCII letters only; everything else stays.
std::string lowerCase(std::string text);

std::string_view trimmed(std::string_view text);

/// Lines of a text that may end in LF, CR LF or CR.
class LineCursor
{
public:
    explicit LineCursor(std::string_view text)
        : m_rest(text)
    {
    }

    /// The next line without its end; false at the end of the text.
    bool next(std::string_view &line);

    Index number() const { return m_number; } ///< of the line just read, from 1
    bool terminated() const { return m_terminated; } ///< whether that line had an end

private:
    std::string_view m_rest;
    Index m_number = 0;
    bool m_terminated = true;
};

/// Stands for "any run of blanks and tabs" where a separator is asked for.
constexpr char kBlankSeparator = ' ';

/// Cells of one line.
class CellCursor
{
public:
    CellCursor(std::string_view line, char separator);

    /// The next cell, trimmed; false after the last one.
    bool next(std::string_view &cell);

private:
    std::string_view m_rest;
    char m_separator;
    bool m_more;
};

std::vector<std::string_view> cellsOf(std::string_view line, char separator);

/// Whether a line holds nothing but blanks and separators.
bool isBlankRow(std::string_view line, char separator);

enum class CellKind { Number, Empty, Unreadable };

/// Reads a cell as a number with this decimal mark. "nan" is a number that is NaN.
CellKind readCell(std::string_view cell, char decimal, double &value);

/// Grows by one value per row; empty cells at the end are no samples, empty cells before a later
/// value are invalid ones.
class SampleColumn
{
public:
    void addValue(double value);
    void addEmpty() { ++m_pendingEmpty; }

    Index size() const { return static_cast<Index>(m_values.size()); }
    const std::vector<double> &values() const { return m_values; }
    std::vector<double> take() { return std::move(m_values); }
    void reserve(std::size_t rows) { m_values.reserve(rows); }

private:
    std::vector<double> m_values;
    Index m_pendingEmpty = 0;
};

/// "12,3x" in column 2 of line 17 is no number: CAP-018, naming all of it.
tl::unexpected<Error> unreadableCell(
    const std::string &path, Index line, Index column, std::string_view cell);

/// There is no table in the file: CAP-001.
tl::unexpected<Error> noRowsOfNumbers(const std::string &path);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/table_parser.h"

#include "core/capture/formats/plain_row.h"
#include "core/capture/formats/table_end.h"
#include "core/capture/formats/text_table.h"

#include <algorithm>
#include <limits>

namespace dyncal {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Rows of a text to columns of numbers.
class TableParser
{
public:
    TableParser(const std::string &path, std::string_view text, const TextDialect &dialect)
        : m_path(path)
        , m_text(text)
        , m_dialect(dialect)
        , m_row(static_cast<std::size_t>(dialect.columns))
        , m_plain(dialect.separator, dialect.decimal)
    {
        m_table.columns.resize(m_row.size());
        for (std::vector<double> &column : m_table.columns)
            column.reserve(mostRows());
    }

    Result<TableColumns> parse(const JobControl &control)
    {
        constexpr Index kRowsPerCheck = 1 << 16;
        LineCursor lines(m_text);
        for (std::string_view line; lines.next(line);) {
            if (lines.number() <= m_dialect.headerLines())
                continue;
            if (lines.number() % kRowsPerCheck == 0) {
                if (control.stopRequested())
                    return fail(ErrorKind::Cancelled,
                        {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
                control.report(static_cast<double>(line.data() - m_text.data())
                    / static_cast<double>(m_text.size()));
            }
            if (!lines.terminated() && isCut(line, lines.number()))
                break;
            if (const Result<void> row = addLine(line, lines.number()); !row)
                return tl::unexpected(row.error());
        }
        control.report(1.0);
        return std::move(m_table);
    }

private:
    /// A line end and a separator each stand for at most one value, so a table can never have more
    /// rows than this, whatever the file is.
    std::size_t mostRows() const
    {
        const auto lineFeeds = std::count(m_text.begin(), m_text.end(), '\n');
        const auto ends
            = lineFeeds > 0 ? lineFeeds : std::count(m_text.begin(), m_text.end(), '\r');
        return std::min(static_cast<std::size_t>(ends) + 1, m_text.size() / m_row.size() + 1);
    }

    Result<void> addLine(std::string_view line, Index number)
    {
        if (m_commentLine == 0 && m_blankRows == 0 && m_plain.read(line, m_row)) {
            append();
            return {};
        }
        if (isBlankRow(line, m_dialect.separator)) {
            ++m_blankRows;
            return {};
        }
        if (isCommentLine(line)) {
            m_commentLine = m_commentLine == 0 ? number : m_commentLine;
            return {};
        }
        if (m_commentLine > 0)
            return commentWithin();
        if (const Result<void> filled = fillBlankRows(number); !filled)
            return filled;
        return addRow(line, number);
    }

    /// Blank lines at the end of a file mean nothing; within the data each is a sample that is
    /// missing, or else all behind it would move in time.
    Result<void> fillBlankRows(Index number)
    {
        const std::size_t values = static_cast<std::size_t>(m_blankRows) * m_row.size();
        if (values > m_text.size())
            return damaged(DYNCAL_TEXT("core",
                               "%1, line %2 follows %3 blank lines; the file is damaged, or it "
                               "holds two tables."),
                {std::to_string(number), std::to_string(m_blankRows)});
        std::fill(m_row.begin(), m_row.end(), kNan);
        for (; m_blankRows > 0; --m_blankRows)
            append();
        return {};
    }

    Result<void> addRow(std::string_view line, Index number)
    {
        std::size_t count = 0;
        CellCursor cursor(line, m_dialect.separator);
        for (std::string_view cell; cursor.next(cell); ++count) {
            double value = kNan;
            const CellKind kind = readCell(cell, m_dialect.decimal, value);
            const bool extra = count >= m_row.size();
            if (extra && kind != CellKind::Empty)
                return wrongLength(number, cellCount(line, m_dialect.separator));
            if (kind == CellKind::Unreadable)
                return unreadableCell(m_path, number, static_cast<Index>(count) + 1, cell);
            if (!extra)
                m_row[count] = value;
        }
        if (count < m_row.size())
            return wrongLength(number, static_cast<Index>(count));
        append();
        return {};
    }

    void append()
    {
        for (std::size_t i = 0; i < m_row.size(); ++i)
            m_table.columns[i].push_back(m_row[i]);
    }

    tl::unexpected<Error> damaged(const char *sentence, std::vector<std::string> more) const
    {
        more.insert(more.begin(), m_path);
        return fail(ErrorKind::FileUnreadable, {sentence, std::move(more)}, "CAP-018");
    }

    tl::unexpected<Error> wrongLength(Index number, Index found) const
    {
        return damaged(
            DYNCAL_TEXT("core",
                "%1, line %2 has %3 cells, the lines before have %4; correct the line, or set "
                "separator and decimal in the recipe's import section."),
            {std::to_string(number), std::to_string(found), std::to_string(m_row.size())});
    }

    /// Whatever the comment says, rows before and behind it need not follow each other in time.
    tl::unexpected<Error> commentWithin() const
    {
        return damaged(DYNCAL_TEXT("core",
                           "%1, line %2 is a comment within the data; take it out if the rows "
                           "around it follow each other, else save them as two files."),
            {std::to_string(m_commentLine)});
    }

    bool isCut(std::string_view line, Index number)
    {
        if (isBlankRow(line, m_dialect.separator) || isCommentLine(line)
            || m_table.columns.front().empty())
            return false;
        const RowEnd end = lastRowEnd(m_text, line, m_dialect);
        if (end != RowEnd::Whole)
            m_table.findings.push_back(unfinishedLine(m_path, number, end));
        return end == RowEnd::Cut;
    }

    const std::string &m_path;
    std::string_view m_text;
    const TextDialect &m_dialect;
    std::vector<double> m_row;
    PlainRowReader m_plain;
    TableColumns m_table;
    Index m_blankRows = 0;
    Index m_commentLine = 0; ///< the first one behind the data
};

} // namespace

Result<TableColumns> parseTable(const std::string &path, std::string_view text,
    const TextDialect &dialect, const JobControl &control)
{
    return TableParser(path, text, dialect).parse(control);
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/table_parser.h"

#include "core/capture/formats/large_pages.h"
#include "core/capture/formats/plain_row.h"
#include "core/capture/formats/plain_rows_ahead.h"
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
        , m_lines(text)
        , m_row(static_cast<std::size_t>(dialect.columns))
        , m_plain(dialect.separator, dialect.decimal)
    {
        m_table.columns.resize(m_row.size());
    }

    Result<TableColumns> parse(const JobControl &control)
    {
        LineCursor &lines = m_lines;
        std::string_view line;
        while (lines.number() < m_dialect.headerLines() && lines.next(line)) { }
        PlainRowsAhead ahead(m_plain, lines.rest(), m_row.size(), control.stop);
        for (;;) {
            if (const Result<void> going = pause(control); !going)
                return tl::unexpected(going.error());
            const bool plain = m_commentLine == 0 && m_blankRows == 0;
            takeRowsAhead(ahead, plain);
            if (const char *behind = plain ? m_plain.read(lines.rest(), m_row) : nullptr) {
                append();
                lines.take(behind, 1);
                continue;
            }
            if (!lines.next(line) || (!lines.terminated() && isCut(line, lines.number())))
                break;
            if (const Result<void> added = addLine(line, lines.number()); !added)
                return tl::unexpected(added.error());
        }
        control.report(1.0);
        return std::move(m_table);
    }

private:
    /// Takes over what another thread read from here on, if these lines can be plain rows here.
    void takeRowsAhead(PlainRowsAhead &ahead, bool plain)
    {
        while (ahead.nextBegin() != nullptr && ahead.nextBegin() == m_lines.rest().data()) {
            if (!plain)
                return ahead.skip();
            PlainRows part = ahead.take();
            const std::size_t rows
                = m_table.columns[0].size() + static_cast<std::size_t>(part.rows());
            if (rows > m_table.columns[0].capacity())
                makeRoom(static_cast<std::size_t>(part.rows()));
            for (std::size_t i = 0; i < part.columns.size(); ++i) {
                const std::vector<double> values = std::move(part.columns[i]);
                m_table.columns[i].insert(m_table.columns[i].end(), values.begin(), values.end());
            }
            m_lines.take(part.behind, part.rows());
        }
    }

    void append()
    {
        if (m_table.columns[0].size() == m_table.columns[0].capacity())
            makeRoom(1);
        for (std::size_t i = 0; i < m_row.size(); ++i)
            m_table.columns[i].push_back(m_row[i]);
    }

    /// For as many rows as the text will have if all are as long as those so far, and some more:
    /// doubling would hold up to three times the values at the end.
    void makeRoom(std::size_t more)
    {
        constexpr std::size_t kFirstRows = 1024;
        constexpr double kSpare = 1.02;
        const std::size_t rows = m_table.columns[0].size();
        const auto done = static_cast<double>(m_text.size() - m_lines.rest().size() + 1);
        const double all = static_cast<double>(rows) * static_cast<double>(m_text.size()) / done;
        const std::size_t room = rows + kFirstRows
            + (rows < kFirstRows ? 0 : static_cast<std::size_t>(all * kSpare) - rows);
        const std::size_t most = rows + m_text.size() / m_row.size() + 1; // a cell takes a byte
        for (std::vector<double> &column : m_table.columns) {
            column.reserve(std::max(std::min(room, most), rows + more));
            preferLargePages(column.data() + rows, (column.capacity() - rows) * sizeof(double));
        }
    }

    Result<void> pause(const JobControl &control) const
    {
        constexpr Index kRowsPerCheck = 1 << 16;
        if (m_lines.number() % kRowsPerCheck != 0)
            return {};
        if (control.stopRequested())
            return fail(
                ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
        control.report(
            1.0 - static_cast<double>(m_lines.rest().size()) / static_cast<double>(m_text.size()));
        return {};
    }

    Result<void> addLine(std::string_view line, Index number)
    {
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
        if (isBlankRow(line, m_dialect.separator) || isCommentLine(line))
            return false;
        const RowEnd end = m_table.columns.front().empty() ? RowEnd::Unclear
                                                           : lastRowEnd(m_text, line, m_dialect);
        if (end != RowEnd::Whole)
            m_table.findings.push_back(unfinishedLine(m_path, number, end));
        return end == RowEnd::Cut;
    }

    const std::string &m_path;
    std::string_view m_text;
    const TextDialect &m_dialect;
    LineCursor m_lines;
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

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/table_parser.h"

#include "core/capture/formats/bytes/large_pages.h"
#include "core/capture/formats/text/plain_row.h"
#include "core/capture/formats/text/plain_rows_ahead.h"
#include "core/capture/formats/text/table_end.h"
#include "core/capture/formats/text/text_bytes.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_source.h"
#include "core/capture/formats/text/text_table.h"

#include <algorithm>
#include <limits>

namespace dyncal {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Rows of a text to columns of numbers.
class TableParser
{
public:
    TableParser(const std::string &path, const TextSource &text, const TextDialect &dialect,
        double maxExpansion)
        : m_path(path)
        , m_text(text)
        , m_budget(text.size(), maxExpansion)
        , m_dialect(dialect)
        , m_blocks(text)
        , m_lines({})
        , m_row(static_cast<std::size_t>(dialect.columns))
        , m_plain(dialect.separator, dialect.decimal)
    {
        m_table.columns.resize(m_row.size());
    }

    Result<TableColumns> parse(const JobControl &control)
    {
        // The text itself is in memory too.
        if (const std::uint64_t bytes = m_row.size() * kBytesOfChannel + m_text.size();
            !m_budget.take(bytes))
            return m_budget.exceededBy(
                m_path, Expanding::Columns, std::to_string(m_row.size()), bytes);
        std::string_view line;
        while (m_lines.number() < m_dialect.headerLines() && nextBlock(m_text.size())
            && m_lines.next(line)) { }
        const std::uint64_t begin = position();
        PlainRowsAhead ahead(m_plain, m_text, begin, m_row.size());
        m_blocks.moveTo(begin);
        m_lines = LineCursor({}, m_lines.number());
        for (;;) {
            const bool plain = m_commentLine == 0 && m_blankRows == 0;
            if (const Result<void> going = pause(control); !going)
                return tl::unexpected(going.error());
            if (m_lines.rest().empty()) {
                if (takeAhead(ahead, plain)) {
                    if (m_refused > 0)
                        return tooLarge();
                    continue;
                }
                if (!nextBlock(ahead.nextBegin().value_or(m_text.size())))
                    break;
            }
            if (const char *behind = plain ? m_plain.read(m_lines.rest(), m_row) : nullptr) {
                if (!append())
                    return tooLarge();
                m_lines.take(behind, 1);
                continue;
            }
            m_lines.next(line);
            if (!m_lines.terminated() && isCut(line, m_lines.number()))
                break;
            if (const Result<void> added = addLine(line, m_lines.number()); !added)
                return tl::unexpected(added.error());
        }
        if (m_blocks.failed())
            return unreadableText(m_path);
        control.report(1.0);
        return std::move(m_table);
    }

private:
    /// Where in the text the next line begins.
    std::uint64_t position() const { return m_blocks.position() - m_lines.rest().size(); }

    /// Whether there is a line before `end`.
    bool nextBlock(std::uint64_t end)
    {
        if (m_lines.rest().empty())
            m_lines = LineCursor(m_blocks.next(end), m_lines.number());
        return !m_lines.rest().empty();
    }

    /// Takes the next rows that were read ahead; skips them unless `plain`. False if nothing is
    /// read ahead from here on.
    bool takeAhead(PlainRowsAhead &ahead, bool plain)
    {
        if (ahead.nextBegin() != position())
            return false;
        if (plain)
            append(ahead.take());
        else
            ahead.skip();
        return true;
    }

    void append(const PlainRowsAhead::Taken &part)
    {
        const auto more = static_cast<std::size_t>(part.rows.rows());
        if (m_table.columns[0].size() + more > m_table.columns[0].capacity() && !makeRoom(more))
            return;
        for (std::size_t i = 0; i < m_table.columns.size(); ++i) {
            const std::span<const double> values = part.rows.column(i);
            m_table.columns[i].insert(m_table.columns[i].end(), values.begin(), values.end());
        }
        m_blocks.moveTo(part.behind);
        m_lines = LineCursor({}, m_lines.number() + part.rows.rows());
    }

    /// False if there is no room for the row.
    bool append()
    {
        if (m_table.columns[0].size() == m_table.columns[0].capacity() && !makeRoom(1))
            return false;
        for (std::size_t i = 0; i < m_row.size(); ++i)
            m_table.columns[i].push_back(m_row[i]);
        return true;
    }

    tl::unexpected<Error> tooLarge() const
    {
        return m_budget.exceededBy(
            m_path, Expanding::RowsUpTo, std::to_string(m_lines.number()), m_refused);
    }

    /// Room for the rows expected from the length of those so far, and some more: doubling could
    /// take three times the memory of the values. False if the budget is used up.
    bool makeRoom(std::size_t more)
    {
        constexpr std::size_t kFirstRows = 1024;
        constexpr double kSpare = 1.02;
        const std::size_t rows = m_table.columns[0].size();
        const auto done = static_cast<double>(position() + 1);
        const double all = static_cast<double>(rows) * static_cast<double>(m_text.size()) / done;
        const std::size_t room = rows + kFirstRows
            + (rows < kFirstRows ? 0 : static_cast<std::size_t>(all * kSpare) - rows);
        const std::size_t most = rows + m_text.size() / m_row.size() + 1; // a cell takes a byte
        const std::size_t wanted = std::max(std::min(room, most), rows + more);
        const std::size_t before = m_table.columns[0].capacity();
        const std::uint64_t bytes = (wanted - before) * m_row.size() * sizeof(double);
        if (!m_budget.take(bytes)) {
            m_refused = m_budget.taken() + bytes;
            return false;
        }
        for (std::vector<double> &column : m_table.columns) {
            column.reserve(wanted);
            preferLargePages(column.data() + rows, (column.capacity() - rows) * sizeof(double));
        }
        return true;
    }

    Result<void> pause(const JobControl &control) const
    {
        constexpr Index kLinesPerCheck = 1 << 16; // within a block, which may be all of the text
        if (!m_lines.rest().empty() && m_lines.number() % kLinesPerCheck != 0)
            return {};
        if (control.stopRequested())
            return fail(
                ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
        control.report(static_cast<double>(position()) / static_cast<double>(m_text.size()));
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

    /// Blank lines at the end of a file mean nothing; within the data each is a missing sample,
    /// else all samples after it would move in time.
    Result<void> fillBlankRows(Index number)
    {
        const std::size_t values = static_cast<std::size_t>(m_blankRows) * m_row.size();
        if (values > m_text.size())
            return damaged(
                DYNCAL_TEXT("core",
                    "%1, line %2 follows %3 blank lines; the file is damaged, or it holds two tables."),
                {std::to_string(number), std::to_string(m_blankRows)});
        std::fill(m_row.begin(), m_row.end(), kNan);
        for (; m_blankRows > 0; --m_blankRows) {
            if (!append())
                return tooLarge();
        }
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
        if (!append())
            return tooLarge();
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
                "%1, line %2 has %3 cells, the lines before have %4; correct the line, or set separator and decimal in the recipe's import section."),
            {std::to_string(number), std::to_string(found), std::to_string(m_row.size())});
    }

    /// Rows before and after a comment need not follow each other in time.
    tl::unexpected<Error> commentWithin() const
    {
        return damaged(
            DYNCAL_TEXT("core",
                "%1, line %2 is a comment within the data; take it out if the rows around it follow each other, else save them as two files."),
            {std::to_string(m_commentLine)});
    }

    bool isCut(std::string_view line, Index number)
    {
        if (isBlankRow(line, m_dialect.separator) || isCommentLine(line))
            return false;
        const RowEnd end = m_table.columns.front().empty() ? RowEnd::Unclear : endOfLastRow(line);
        if (end != RowEnd::Whole)
            m_table.findings.push_back(unfinishedLine(m_path, number, end));
        return end == RowEnd::Cut;
    }

    /// Compared with the rows just above.
    RowEnd endOfLastRow(std::string_view line) const
    {
        constexpr std::uint64_t kBytesAbove = 8192; // more than lastRowEnd() needs
        std::vector<char> buffer;
        const std::uint64_t wanted = line.size() + kBytesAbove;
        const std::uint64_t begin = m_text.size() > wanted ? m_text.size() - wanted : 0;
        const auto end = m_text.read(begin, m_text.size(), buffer);
        if (!end)
            return RowEnd::Unclear; // reported when the file is sealed
        return lastRowEnd(*end, end->substr(end->size() - line.size()), m_dialect);
    }

    const std::string &m_path;
    const TextSource &m_text;
    ExpansionBudget m_budget;
    std::uint64_t m_refused = 0; ///< bytes that the budget does not have
    const TextDialect &m_dialect;
    LineBlocks m_blocks;
    LineCursor m_lines;
    std::vector<double> m_row;
    PlainRowReader m_plain;
    TableColumns m_table;
    Index m_blankRows = 0;
    Index m_commentLine = 0; ///< the first one after the data
};

} // namespace

Result<TableColumns> parseTable(const std::string &path, const TextSource &text,
    const TextDialect &dialect, const JobControl &control, double maxExpansion)
{
    return TableParser(path, text, dialect, maxExpansion).parse(control);
}

} // namespace dyncal

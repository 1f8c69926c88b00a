// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/delimited_text.h"

#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "core/capture/file_kind.h"
#include "core/capture/formats/table_end.h"
#include "core/capture/formats/text_dialect.h"
#include "core/capture/formats/text_table.h"
#include "core/capture/formats/text_time.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>

namespace dyncal {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

tl::unexpected<Error> damaged(
    const std::string &path, const char *sentence, std::vector<std::string> more)
{
    more.insert(more.begin(), path);
    return fail(ErrorKind::FileUnreadable, {sentence, std::move(more)}, "CAP-018");
}

/// Rows of a text to columns of numbers.
class TableParser
{
public:
    TableParser(const std::string &path, const TextDialect &dialect)
        : m_path(path)
        , m_dialect(dialect)
        , m_columns(static_cast<std::size_t>(dialect.columns))
    {
    }

    Result<void> parse(std::string_view text, const JobControl &control)
    {
        constexpr Index kRowsPerCheck = 1 << 16;
        LineCursor lines(text);
        for (std::string_view line; lines.next(line);) {
            if (lines.number() <= m_dialect.headerLines())
                continue;
            if (lines.number() % kRowsPerCheck == 0) {
                if (control.stopRequested())
                    return fail(ErrorKind::Cancelled,
                        {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
                control.report(static_cast<double>(line.data() - text.data())
                    / static_cast<double>(text.size()));
            }
            if (!lines.terminated() && isCut(text, line, lines.number()))
                break;
            if (const Result<void> row = addRow(line, lines.number()); !row)
                return row;
        }
        control.report(1.0);
        return {};
    }

    std::vector<std::vector<double>> &columns() { return m_columns; }
    const Findings &findings() const { return m_findings; }

private:
    /// Blank lines at the end of a file mean nothing; within the data each is a sample that is
    /// missing, or else all behind it would move in time.
    Result<void> addRow(std::string_view line, Index number)
    {
        if (isBlankRow(line, m_dialect.separator)) {
            ++m_blankRows;
            return {};
        }
        for (; m_blankRows > 0; --m_blankRows) {
            for (std::vector<double> &column : m_columns)
                column.push_back(kNan);
        }
        std::size_t count = 0;
        CellCursor cursor(line, m_dialect.separator);
        for (std::string_view cell; cursor.next(cell); ++count) {
            double value = kNan;
            const CellKind kind = readCell(cell, m_dialect.decimal, value);
            const bool extra = count >= m_columns.size();
            if (kind == CellKind::Unreadable || (extra && kind == CellKind::Number))
                return extra ? wrongLength(number, cellsOf(line, m_dialect.separator).size())
                             : unreadableCell(m_path, number, static_cast<Index>(count) + 1, cell);
            if (!extra)
                m_columns[count].push_back(value);
        }
        return count < m_columns.size() ? wrongLength(number, count) : Result<void>();
    }

    Result<void> wrongLength(Index number, std::size_t found) const
    {
        return damaged(m_path,
            DYNCAL_TEXT("core",
                "%1, line %2 has %3 cells, the lines before have %4; correct the line, or set "
                "separator and decimal in the recipe's import section."),
            {std::to_string(number), std::to_string(found), std::to_string(m_columns.size())});
    }

    bool isCut(std::string_view text, std::string_view line, Index number)
    {
        const RowEnd end = lastRowEnd(text, line, m_dialect);
        if (end == RowEnd::Whole || isBlankRow(line, m_dialect.separator)
            || m_columns.front().empty())
            return false;
        m_findings.push_back(unfinishedLine(m_path, number, end));
        return end == RowEnd::Cut;
    }

    const std::string &m_path;
    const TextDialect &m_dialect;
    std::vector<std::vector<double>> m_columns;
    Findings m_findings;
    Index m_blankRows = 0;
};

/// A first row with one bad cell must not pass for a header: its other cells are measured values.
Result<void> checkHeader(const std::string &path, const TextDialect &dialect)
{
    if (dialect.header.empty())
        return {};
    const auto cells = cellsOf(dialect.header.back(), dialect.separator);
    Index numbers = 0;
    std::size_t bad = cells.size();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        double value = 0.0;
        const CellKind kind = readCell(cells[i], dialect.decimal, value);
        const bool measured = cells[i].find_first_of(".,eE") != std::string_view::npos;
        numbers += kind == CellKind::Number && measured ? 1 : 0;
        bad = kind == CellKind::Unreadable ? std::min(bad, i) : bad;
    }
    if (numbers == 0 || bad == cells.size() || static_cast<Index>(cells.size()) < dialect.columns)
        return {};
    return unreadableCell(path, dialect.headerLines(), static_cast<Index>(bad) + 1, cells[bad]);
}

Result<void> checkColumns(const std::string &path, const ImportSettings &settings, Index columns)
{
    for (const auto &[role, column] : settings.columns) {
        if (column < 0 || column >= columns)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "%1 has no column %2 for %3; it has the columns 0 to %4. Change columns in "
                     "the recipe's import section."),
                    {path, std::to_string(column), role, std::to_string(columns - 1)}});
    }
    return {};
}

/// What each column becomes: a role, or nothing if it is not wanted.
std::vector<std::optional<ChannelRole>> rolesOf(
    const ImportSettings &settings, Index columns, std::optional<Index> timeColumn)
{
    const bool onlyNamed = std::any_of(settings.columns.begin(), settings.columns.end(),
        [](const auto &entry) { return entry.first != "time"; });
    std::vector<std::optional<ChannelRole>> roles(static_cast<std::size_t>(columns));
    if (!onlyNamed)
        std::fill(roles.begin(), roles.end(), ChannelRole::Other);
    for (const auto &[role, column] : settings.columns)
        roles[static_cast<std::size_t>(column)] = channelRoleFromName(role);
    if (timeColumn)
        roles[static_cast<std::size_t>(*timeColumn)].reset();
    return roles;
}

Channel channelOf(const ColumnTitle &title, ChannelRole role, std::vector<double> values)
{
    Channel channel;
    channel.name = title.name;
    channel.role = role;
    channel.unit = title.unit.empty() ? "1" : title.unit;
    channel.samples = RawSamples(std::move(values));
    channel.sha256 = sha256OfSamples(channel.samples);
    return channel;
}

Finding ambiguousDecimal(const std::string &path, const TextDialect &dialect)
{
    return {"CAP-019", Severity::Caution, 0, {}, {},
        {DYNCAL_TEXT("core",
             "%1: \"%2\" can be read in two ways; the comma was taken as %3. Set decimal and "
             "separator in the recipe's import section to be certain."),
            {path, dialect.ambiguous, dialect.decimal == ',' ? "decimal mark" : "separator"}},
        {}, {}};
}

} // namespace

int recogniseDelimitedText(const std::string &path, std::string_view head)
{
    constexpr std::array<std::string_view, 6> kExtensions{
        ".csv", ".tsv", ".txt", ".dat", ".asc", ".prn"};
    const std::string text = textOfBytes(std::string(head));
    if (!isPlainText(text) || !dialectOf(text, {}))
        return 0;
    const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
    const bool known
        = std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
    return known ? 60 : 40;
}

Result<CaptureSet> readDelimitedText(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const Result<std::string> text = readTextFile(path);
    if (!text)
        return tl::unexpected(text.error());
    const std::optional<TextDialect> dialect = dialectOf(*text, settings);
    if (!dialect)
        return noRowsOfNumbers(path);
    if (const auto checked = checkColumns(path, settings, dialect->columns); !checked)
        return tl::unexpected(checked.error());
    if (const auto checked = checkHeader(path, *dialect); !checked && !settings.skipRows)
        return tl::unexpected(checked.error());
    TableParser parser(path, *dialect);
    if (const Result<void> parsed = parser.parse(*text, control); !parsed)
        return tl::unexpected(parsed.error());

    const std::vector<ColumnTitle> titles = columnTitles(*dialect);
    const Result<TextTime> time = timeOfTable(path, settings, *dialect, titles, parser.columns());
    if (!time)
        return tl::unexpected(time.error());
    const auto roles = rolesOf(settings, dialect->columns, time->column);
    CaptureSet set;
    set.findings = parser.findings();
    set.findings.insert(set.findings.end(), time->findings.begin(), time->findings.end());
    if (!dialect->ambiguous.empty())
        set.findings.push_back(ambiguousDecimal(path, *dialect));
    Shot shot;
    shot.label = std::filesystem::path(path).stem().string();
    for (std::size_t i = 0; i < roles.size(); ++i) {
        if (!roles[i])
            continue;
        Channel channel = channelOf(titles[i], *roles[i], std::move(parser.columns()[i]));
        channel.sampleRate_Hz = time->sampleRate_Hz;
        channel.t0_s = time->first_s;
        shot.channels.push_back(std::move(channel));
    }
    if (shot.channels.empty())
        return damaged(
            path, DYNCAL_TEXT("core", "%1 has a column of times but no column of samples."), {});
    set.shots.push_back(std::move(shot));
    return set;
}

} // namespace dyncal

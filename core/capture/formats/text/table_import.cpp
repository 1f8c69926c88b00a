// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/table_import.h"

#include "core/base/number_text.h"
#include "core/capture/formats/bytes/counted_header.h"
#include "core/capture/formats/text/column_titles.h"
#include "core/capture/formats/text/shot_columns.h"
#include "core/capture/formats/text/table_parser.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_source.h"
#include "core/capture/formats/text/text_table.h"

#include <algorithm>

namespace dyncal {
namespace {

tl::unexpected<Error> damaged(
    const char *id, const std::string &path, const char *sentence, std::vector<std::string> more)
{
    more.insert(more.begin(), path);
    return fail(ErrorKind::FileUnreadable, {sentence, std::move(more)}, id);
}

/// A first row with one bad cell must not count as header: its other cells are measured values.
Result<void> checkHeader(const std::string &path, const TextDialect &dialect)
{
    if (dialect.header.empty())
        return {};
    std::vector<std::string_view> cells = cellsOf(dialect.header.back(), dialect.separator);
    if (static_cast<Index>(cells.size()) < dialect.columns)
        return {};
    cells.resize(static_cast<std::size_t>(dialect.columns)); // settings may follow
    Index numbers = 0;
    std::size_t bad = cells.size();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        double value = 0.0;
        const CellKind kind = readCell(cells[i], dialect.decimal, value);
        const bool measured = cells[i].find_first_of(".,eE") != std::string_view::npos;
        numbers += kind == CellKind::Number && measured ? 1 : 0;
        bad = kind == CellKind::Unreadable ? std::min(bad, i) : bad;
    }
    if (numbers == 0 || bad == cells.size())
        return {};
    return unreadableCell(path, dialect.headerLines(), static_cast<Index>(bad) + 1, cells[bad]);
}

/// Header "t,p" above rows "0,1,1,5": a comma that separates cells and marks decimals, too.
Result<void> checkCommas(const std::string &path, const TextDialect &dialect, std::string_view text)
{
    constexpr Index kRowsLookedAt = 64;
    if (dialect.separator != ',' || dialect.header.empty()
        || cellCount(dialect.header.back(), ',') * 2 != dialect.columns || dialect.columns < 4)
        return {};
    LineCursor lines(text);
    for (std::string_view line;
         lines.next(line) && lines.number() <= dialect.headerLines() + kRowsLookedAt;) {
        if (lines.number() > dialect.headerLines() && line.find('.') != std::string_view::npos)
            return {};
    }
    return damaged("CAP-019", path,
        DYNCAL_TEXT("core",
            "%1: the header names %2 columns but the rows have %3 cells, so the comma seems to be both separator and decimal mark; export with another separator, or state separator and decimal in the recipe's import section."),
        {std::to_string(dialect.columns / 2), std::to_string(dialect.columns)});
}

/// Header lines that are rows of numbers like the data; the data may have begun there.
Findings findingsOfHeader(const std::string &path, const TextDialect &dialect)
{
    Findings findings;
    for (std::size_t i = 0; i < dialect.header.size(); ++i) {
        double value = 0.0;
        const auto cells = cellsOf(dialect.header[i], dialect.separator);
        const bool row = dialect.columns > 1 && static_cast<Index>(cells.size()) == dialect.columns
            && std::all_of(cells.begin(), cells.end(), [&](std::string_view cell) {
                   return readCell(cell, dialect.decimal, value) == CellKind::Number;
               });
        if (!row)
            continue;
        findings.push_back({.id = "CAP-018",
            .severity = Severity::Caution,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: line %2 is a row of %3 numbers like the data, but other text follows it; it was taken as header. Set skip_rows in the recipe's import section to be certain."),
                {path, std::to_string(i + 1), std::to_string(dialect.columns)}}});
        break;
    }
    if (const std::optional<Index> names = namesThatDoNotFit(dialect))
        findings.push_back({.id = "CAP-018",
            .severity = Severity::Info,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: line %2 has %3 cells above %4 columns, so the columns are numbered, not named."),
                {path, std::to_string(dialect.headerLines()), std::to_string(*names),
                    std::to_string(dialect.columns)}}});
    return findings;
}

Result<void> checkColumns(const std::string &path, const ImportSettings &settings, Index columns)
{
    for (const auto &[role, column] : settings.columns) {
        if (column < 0 || column >= columns)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "%1 has no column %2 for %3; it has the columns 0 to %4. Change columns in the recipe's import section."),
                    {path, std::to_string(column), role, std::to_string(columns - 1)}});
    }
    return {};
}

Finding ambiguousDecimal(const std::string &path, const TextDialect &dialect)
{
    return {.id = "CAP-019",
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "%1: \"%2\" can be read in two ways; the comma was taken as %3. Set decimal and separator in the recipe's import section to be certain."),
            {path, dialect.ambiguous, dialect.decimal == ',' ? "decimal mark" : "separator"}}};
}

/// Takes a header of bare numbers off the only column, and the rate from it.
Result<void> takeCountedHeader(const TextPart &part, ImportedTable &table)
{
    const std::string &path = part.path;
    std::vector<double> &column = table.columns[0];
    const std::optional<CountedHeader> header = countedHeader(column);
    if (!header)
        return {};
    const double rate_Hz = 1.0 / header->interval_s;
    const std::string declared = std::to_string(header->declared);
    const std::string rate = numberWithUnit(rate_Hz, "Hz", 7);
    if (!header->complete && part.whole)
        return damaged("CAP-018", path,
            DYNCAL_TEXT("core",
                "%1 begins like a header of %2 samples at %3, but has %4 lines, so it is likely an incomplete copy. Copy it again, or set skip_rows in the recipe's import section."),
            {declared, rate, std::to_string(column.size())});
    column.erase(column.begin(), column.begin() + header->lines);
    table.countedHeaderLines = header->lines;
    table.time.sampleRate_Hz = rate_Hz;
    table.findings.push_back({.id = "CAP-003",
        .severity = Severity::Info,
        .message
        = {DYNCAL_TEXT("core",
               "%1: the first %2 lines were taken as header, as they count the %3 lines behind: the sample rate is %4."),
            {path, std::to_string(header->lines), declared, rate}}});
    return {};
}

/// All that is checked before the rows are read.
Result<void> checkBefore(const std::string &path, const ImportSettings &settings,
    const TextDialect &dialect, std::string_view text)
{
    if (const auto checked = checkColumns(path, settings, dialect.columns); !checked)
        return checked;
    if (const auto checked = checkShotColumns(path, settings); !checked)
        return checked;
    if (settings.skipRows)
        return {};
    if (const auto checked = checkHeader(path, dialect); !checked)
        return checked;
    return settings.separator == "auto" ? checkCommas(path, dialect, text) : Result<void>();
}

void append(Findings &all, const Findings &more)
{
    all.insert(all.end(), more.begin(), more.end());
}

} // namespace

Result<ImportedTable> importTable(const TextPart &part, const TextDialect &dialect,
    const ImportSettings &settings, const JobControl &control)
{
    if (const auto checked = checkBefore(part.path, settings, dialect, part.text); !checked)
        return tl::unexpected(checked.error());
    const TextSource here(part.text);
    Result<TableColumns> parsed = parseTable(
        part.path, part.all != nullptr ? *part.all : here, dialect, control, settings.maxExpansion);
    if (!parsed)
        return tl::unexpected(parsed.error());
    ImportedTable table;
    table.titles = columnTitles(dialect);
    table.columns = std::move(parsed->columns);
    Result<TextTime> time = timeOfTable(part.path, settings, dialect, table.titles, table.columns);
    if (!time)
        return tl::unexpected(time.error());
    table.time = std::move(*time);
    if (!settings.skipRows)
        append(table.findings, findingsOfHeader(part.path, dialect));
    append(table.findings, table.time.findings);
    append(table.findings, parsed->findings);
    if (!dialect.ambiguous.empty())
        table.findings.push_back(ambiguousDecimal(part.path, dialect));
    if (!settings.skipRows && dialect.columns == 1 && dialect.header.empty()) {
        if (const auto taken = takeCountedHeader(part, table); !taken)
            return tl::unexpected(taken.error());
    }
    return table;
}

} // namespace dyncal

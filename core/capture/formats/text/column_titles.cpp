// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/column_titles.h"

#include "core/base/ascii_text.h"
#include "core/base/text_encoding.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_table.h"
#include "core/capture/formats/text/time_words.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

constexpr auto kUnits = std::to_array<std::string_view>({"s", "ms", "us", "\u00B5s", "\u03BCs",
    "ns", "sec", "second", "seconds", "v", "mv", "uv", "\u00B5v", "volt", "volts", "pa", "kpa",
    "mpa", "hpa", "bar", "mbar", "psi", "g", "kg_n", "m/s^2", "m/s\u00B2", "n", "kn", "c", "pc",
    "k", "a", "ma", "hz", "khz", "mhz", "ghz", "counts", "count", "codes", "sequence", "1"});

std::vector<std::string_view> cellsWithoutTail(
    std::string_view line, char separator, std::size_t columns)
{
    std::vector<std::string_view> cells = cellsOf(line, separator);
    while (cells.size() > columns && cells.back().empty())
        cells.pop_back();
    for (std::string_view &cell : cells) {
        if (separator == kBlankSeparator && (cell.ends_with(',') || cell.ends_with(';')))
            cell.remove_suffix(1); // "# time(s), acceleration(g)" above columns split by blanks
    }
    return cells;
}

/// "time (s)" is one title in a table split by blanks, too.
std::vector<std::string_view> withUnitsJoined(const std::vector<std::string_view> &cells)
{
    std::vector<std::string_view> joined;
    for (const std::string_view cell : cells) {
        if (joined.empty() || !(cell.starts_with('(') || cell.starts_with('[')))
            joined.push_back(cell);
        else
            joined.back() = {joined.back().data(),
                static_cast<std::size_t>(cell.data() + cell.size() - joined.back().data())};
    }
    return joined;
}

/// Cells of a header line, one per column, or none. Headers of tables split by blanks often use
/// another separator ("# time (s),<tab>acceleration (g)").
std::vector<std::string_view> titleCells(std::string_view line, const TextDialect &dialect)
{
    line = trimmed(line);
    const bool comment = line.starts_with('#') || line.starts_with('%');
    if (comment)
        line = trimmed(line.substr(1));
    const auto columns = static_cast<std::size_t>(dialect.columns);
    for (const char separator : {dialect.separator, ',', ';', '\t', kBlankSeparator}) {
        std::vector<std::string_view> cells = cellsWithoutTail(line, separator, columns);
        if (cells.size() != columns && separator == kBlankSeparator)
            cells = withUnitsJoined(cells);
        if (cells.size() == columns)
            return cells;
        if (!comment && dialect.separator != kBlankSeparator)
            break;
    }
    return {};
}

/// "[V]" or "(V)" or "V" -> "V".
std::string_view bareUnit(std::string_view text)
{
    const bool brackets = text.size() > 2
        && ((text.front() == '[' && text.back() == ']')
            || (text.front() == '(' && text.back() == ')'));
    return brackets ? trimmed(text.substr(1, text.size() - 2)) : text;
}

bool isUnit(std::string_view text)
{
    const bool bracketed = bareUnit(text).size() != text.size();
    const std::string word = lowerCase(utf8Text(text));
    return bracketed || std::find(kUnits.begin(), kUnits.end(), word) != kUnits.end();
}

ColumnTitle titleOf(std::string_view text)
{
    for (const std::string_view brackets : {"()", "[]"}) {
        const std::size_t open = text.rfind(brackets[0]);
        const bool unit = open != std::string_view::npos
            && text.find('=', open) == std::string_view::npos; // "(k=1)" is no unit
        if (unit && open > 0 && text.back() == brackets[1])
            return {utf8Text(trimmed(text.substr(0, open))), utf8Text(bareUnit(text.substr(open)))};
    }
    const std::size_t slash = text.rfind('/');
    if (slash != std::string_view::npos && slash > 0 && isUnit(trimmed(text.substr(slash + 1)))
        && text.substr(slash + 1) != "1")
        return {
            utf8Text(trimmed(text.substr(0, slash))), utf8Text(trimmed(text.substr(slash + 1)))};
    return {utf8Text(text), {}};
}

/// Rigol's "X,CH1,Start,Increment" names two columns that no row has.
bool namesIncrement(std::string_view line, const TextDialect &dialect)
{
    const std::vector<std::string_view> cells = cellsOf(line, dialect.separator);
    return std::any_of(cells.begin() + std::min(dialect.columns, static_cast<Index>(cells.size())),
        cells.end(),
        [](std::string_view cell) { return lowerCase(std::string(cell)) == "increment"; });
}

/// Header lines that name columns and give units; both may be empty.
struct TitleRows
{
    std::vector<std::string_view> names;
    std::vector<std::string_view> units;
};

TitleRows titleRowsOf(const TextDialect &dialect)
{
    TitleRows rows;
    const auto line = [&](std::size_t fromEnd) {
        return dialect.header.size() > fromEnd ? dialect.header[dialect.header.size() - 1 - fromEnd]
                                               : std::string_view();
    };
    const auto columns = static_cast<std::size_t>(dialect.columns);
    if (namesIncrement(line(1), dialect)) {
        rows.names = cellsOf(line(1), dialect.separator);
        rows.units = cellsOf(line(0), dialect.separator);
        rows.names.resize(columns);
        rows.units.resize(columns);
        return rows;
    }
    rows.names = titleCells(line(0), dialect);
    const bool unitRow = !rows.names.empty()
        && std::all_of(rows.names.begin(), rows.names.end(),
            [](std::string_view cell) { return cell.empty() || isUnit(cell); });
    if (std::vector<std::string_view> above = titleCells(line(1), dialect);
        unitRow && !above.empty()) {
        rows.units = std::move(rows.names);
        rows.names = std::move(above);
    }
    return rows;
}

/// Where the names do not fit the columns, the first one may still say that it is the time.
ColumnTitle timeTitleOf(const TextDialect &dialect)
{
    for (auto line = dialect.header.rbegin(); line != dialect.header.rend(); ++line) {
        std::vector<std::string_view> cells = cellsOf(*line, dialect.separator);
        if (dialect.separator == kBlankSeparator)
            cells = withUnitsJoined(cells);
        if (cells.size() > 1 && isTimeTitle(titleOf(cells[0])))
            return titleOf(cells[0]);
    }
    return {};
}

} // namespace

std::vector<ColumnTitle> columnTitles(const TextDialect &dialect)
{
    std::vector<ColumnTitle> titles(static_cast<std::size_t>(dialect.columns));
    const TitleRows rows = titleRowsOf(dialect);
    for (std::size_t i = 0; i < rows.names.size(); ++i) {
        titles[i] = titleOf(rows.names[i]);
        if (!rows.units.empty())
            titles[i].unit = utf8Text(bareUnit(rows.units[i]));
    }
    if (rows.names.empty())
        titles[0] = timeTitleOf(dialect);
    for (std::size_t i = 0; i < titles.size(); ++i) {
        const auto before = titles.begin() + static_cast<std::ptrdiff_t>(i);
        const bool taken = std::any_of(titles.begin(), before,
            [&](const ColumnTitle &title) { return title.name == titles[i].name; });
        const std::string place = "column " + std::to_string(i + 1);
        if (titles[i].name.empty())
            titles[i].name = place;
        else if (taken)
            titles[i].name.append(", ").append(place);
    }
    return titles;
}

std::optional<Index> namesThatDoNotFit(const TextDialect &dialect)
{
    if (dialect.header.empty() || dialect.separator == kBlankSeparator
        || !titleRowsOf(dialect).names.empty())
        return std::nullopt;
    const Index names = cellCount(dialect.header.back(), dialect.separator);
    return names > 1 ? std::optional(names) : std::nullopt;
}

} // namespace dyncal

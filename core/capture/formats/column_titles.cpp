// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text_dialect.h"
#include "core/capture/formats/text_table.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

constexpr auto kUnits = std::to_array<std::string_view>({"s", "ms", "us", "\u00B5s", "\u03BCs",
    "ns", "sec", "second", "seconds", "v", "mv", "uv", "\u00B5v", "volt", "volts", "pa", "kpa",
    "mpa", "hpa", "bar", "mbar", "psi", "g", "kg_n", "m/s^2", "m/s\u00B2", "n", "kn", "c", "pc",
    "k", "a", "ma", "hz", "khz", "mhz", "ghz", "counts", "count", "codes", "1"});

std::string_view withoutQuotes(std::string_view text)
{
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        text = trimmed(text.substr(1, text.size() - 2));
    return text;
}

std::vector<std::string_view> cellsWithoutTail(
    std::string_view line, char separator, std::size_t columns)
{
    std::vector<std::string_view> cells = cellsOf(line, separator);
    while (cells.size() > columns && cells.back().empty())
        cells.pop_back();
    for (std::string_view &cell : cells) {
        if (separator == kBlankSeparator && (cell.ends_with(',') || cell.ends_with(';')))
            cell.remove_suffix(1); // "# time(s), acceleration(g)" above columns split by blanks
        cell = withoutQuotes(cell);
    }
    return cells;
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
        if (open != std::string_view::npos && open > 0 && text.back() == brackets[1])
            return {utf8Text(trimmed(text.substr(0, open))), utf8Text(bareUnit(text.substr(open)))};
    }
    const std::size_t slash = text.rfind('/');
    if (slash != std::string_view::npos && slash > 0 && isUnit(trimmed(text.substr(slash + 1)))
        && text.substr(slash + 1) != "1")
        return {
            utf8Text(trimmed(text.substr(0, slash))), utf8Text(trimmed(text.substr(slash + 1)))};
    return {utf8Text(text), {}};
}

} // namespace

std::vector<ColumnTitle> columnTitles(const TextDialect &dialect)
{
    std::vector<ColumnTitle> titles(static_cast<std::size_t>(dialect.columns));
    std::vector<std::string_view> names;
    std::vector<std::string_view> units;
    if (!dialect.header.empty())
        names = titleCells(dialect.header.back(), dialect);
    const bool unitRow = !names.empty() && dialect.header.size() > 1
        && std::all_of(names.begin(), names.end(),
            [](std::string_view cell) { return cell.empty() || isUnit(cell); });
    if (unitRow) {
        const std::vector<std::string_view> above
            = titleCells(dialect.header[dialect.header.size() - 2], dialect);
        if (!above.empty()) {
            units = std::move(names);
            names = above;
        }
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        titles[i] = titleOf(names[i]);
        if (!units.empty())
            titles[i].unit = utf8Text(bareUnit(units[i]));
    }
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

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/text_dialect.h"

#include "core/base/ascii_text.h"
#include "core/capture/formats/text/text_table.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {
namespace {

constexpr std::array kSeparators{'\t', ';', '|', ',', kBlankSeparator};
constexpr std::size_t kRowsToStart = 3; ///< alike rows that make a table
constexpr std::size_t kSampleBytes = 256 * 1024; ///< enough rows to tell the dialects apart

/// What one line is under one dialect.
struct Row
{
    Index cells = 0; ///< all of them
    Index used = 0; ///< up to the last one that is not empty
    bool numeric = false; ///< nothing but numbers and empty cells
};

/// One dialect tried on the first lines.
struct Trial
{
    char separator;
    char decimal;
    std::size_t start = 0;
    Index columns = 0;
    Index rows = 0; ///< that fit
};

std::vector<std::string_view> firstLines(std::string_view text)
{
    std::vector<std::string_view> lines;
    LineCursor cursor(text);
    std::size_t bytes = 0;
    for (std::string_view line; bytes < kSampleBytes && cursor.next(line);) {
        if (line.size() > kSampleBytes)
            break; // no row of a table
        lines.push_back(line);
        bytes += line.size() + 1;
    }
    return lines;
}

Row rowOf(std::string_view line, char separator, char decimal)
{
    Row row;
    Index numbers = 0;
    bool readable = true;
    CellCursor cursor(line, separator);
    for (std::string_view cell; cursor.next(cell);) {
        ++row.cells;
        double value = 0.0;
        const CellKind kind = readCell(cell, decimal, value);
        readable = readable && kind != CellKind::Unreadable;
        numbers += kind == CellKind::Number ? 1 : 0;
        if (kind != CellKind::Empty)
            row.used = row.cells;
    }
    row.numeric = readable && numbers > 0;
    return row;
}

/// Further cells of the longer row must be empty: some programs end some rows with a separator.
bool alike(const Row &a, const Row &b)
{
    return std::max(a.used, b.used) <= std::min(a.cells, b.cells);
}

bool tableStartsAt(const std::vector<Row> &rows, std::size_t start)
{
    const std::size_t end = std::min(start + kRowsToStart, rows.size());
    for (std::size_t i = start; i < end; ++i) {
        const bool blankAtEnd = i > start && rows[i].used == 0;
        if (!blankAtEnd && (!rows[i].numeric || !alike(rows[i], rows[start])))
            return i + 1 == rows.size() && i > start; // the last line may be cut
    }
    return start < rows.size();
}

/// Counts the rows that fit from the first row of numbers on, or from where the operator says.
Trial tried(const std::vector<std::string_view> &lines, char separator, char decimal,
    const std::optional<Index> &skipRows)
{
    std::vector<Row> rows;
    rows.reserve(lines.size());
    for (const std::string_view line : lines)
        rows.push_back(rowOf(line, separator, decimal));
    Trial trial{separator, decimal};
    trial.start = skipRows ? static_cast<std::size_t>(*skipRows) : 0;
    while (!skipRows && trial.start < rows.size() && !tableStartsAt(rows, trial.start))
        ++trial.start;
    for (std::size_t i = trial.start; i < rows.size(); ++i) {
        const bool fits = rows[i].numeric && alike(rows[i], rows[trial.start]);
        trial.rows += fits ? 1 : 0;
        trial.columns = fits ? std::max(trial.columns, rows[i].used) : trial.columns;
    }
    return trial;
}

std::vector<char> separatorsToTry(const std::string &setting)
{
    if (setting == "auto")
        return {kSeparators.begin(), kSeparators.end()};
    if (setting == "tab")
        return {'\t'};
    if (setting == "space" || setting.empty())
        return {kBlankSeparator};
    return {setting.front()};
}

std::vector<char> decimalsToTry(const std::string &setting)
{
    if (setting == "." || setting == ",")
        return {setting.front()};
    return {'.', ','};
}

/// "1,234" or "12,500,000" may be thousands or decimals; "0,123" is a decimal.
bool looksGrouped(std::string_view cell)
{
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    if (!cell.empty() && (cell.front() == '-' || cell.front() == '+'))
        cell.remove_prefix(1);
    const std::size_t mark = cell.find(',');
    if (mark == std::string_view::npos || mark == 0 || mark > 3 || cell.front() == '0')
        return false;
    cell.remove_prefix(mark + 1);
    return cell.size() == 3 && std::all_of(cell.begin(), cell.end(), isDigit);
}

/// The first cell with a comma if all such cells look like thousands; else empty.
std::string groupedCell(std::string_view text, const TextDialect &dialect)
{
    std::string_view first;
    LineCursor lines(text);
    for (std::string_view line; lines.next(line);) {
        if (lines.number() <= dialect.headerLines())
            continue;
        CellCursor cells(line, dialect.separator);
        for (std::string_view cell; cells.next(cell);) {
            if (cell.find(',') == std::string_view::npos)
                continue;
            if (!looksGrouped(cell))
                return {};
            first = first.empty() ? cell : first;
        }
    }
    return std::string(first);
}

/// Rows like "12,34" are two columns or one number. More often than not it is one number, unless
/// the header has two cells or the part before the comma counts up.
class PairOrNumber
{
public:
    PairOrNumber(const std::vector<std::string_view> &lines, const Trial &number)
        : m_lines(lines)
        , m_start(number.start)
    {
    }

    bool isPair()
    {
        std::size_t title = m_start; // behind it
        while (title > 0 && isBlankRow(m_lines[title - 1], ','))
            --title;
        if (title > 0) {
            const bool pair = cellCount(m_lines[title - 1], ',') == 2;
            m_certain = pair || !firstPartCountsUp(); // a note has no second name either
            return pair;
        }
        m_certain = anyLeadingZero();
        return !m_certain && firstPartCountsUp();
    }

    bool isCertain() const { return m_certain; }

private:
    template <typename Visit>
    void forPairs(Visit visit) const
    {
        for (std::size_t i = m_start; i < m_lines.size(); ++i) {
            const std::vector<std::string_view> cells = cellsOf(m_lines[i], ',');
            if (cells.size() == 2)
                visit(cells[0], cells[1]);
        }
    }

    bool anyLeadingZero() const
    {
        bool any = false;
        forPairs([&](std::string_view, std::string_view second) {
            any = any || (second.size() > 1 && second[0] == '0');
        });
        return any;
    }

    bool firstPartCountsUp() const
    {
        std::vector<double> values;
        forPairs([&](std::string_view first, std::string_view) {
            double value = 0.0;
            if (readCell(first, '.', value) == CellKind::Number)
                values.push_back(value);
        });
        for (std::size_t i = 2; i < values.size(); ++i) {
            if (values[i] - values[i - 1] != values[1] - values[0])
                return false;
        }
        return values.size() >= kRowsToStart && values[1] > values[0];
    }

    const std::vector<std::string_view> &m_lines;
    std::size_t m_start;
    bool m_certain = false;
};

} // namespace

std::optional<TextDialect> dialectOf(std::string_view text, const ImportSettings &settings)
{
    const std::vector<std::string_view> lines = firstLines(text);
    // In quotes the separator may be the decimal mark, too.
    const bool quoted = std::any_of(lines.begin(), lines.end(),
        [](std::string_view line) { return line.find('"') != std::string_view::npos; });
    std::vector<Trial> trials;
    for (const char separator : separatorsToTry(settings.separator)) {
        for (const char decimal : decimalsToTry(settings.decimal)) {
            if (separator != decimal || quoted)
                trials.push_back(tried(lines, separator, decimal, settings.skipRows));
        }
    }
    const auto best = std::max_element(trials.begin(), trials.end(),
        [](const Trial &a, const Trial &b) { return a.rows < b.rows; });
    if (best == trials.end() || best->rows == 0)
        return std::nullopt;
    const auto pairs = std::find_if(trials.begin(), trials.end(), [&](const Trial &trial) {
        return trial.separator == ',' && trial.rows == best->rows && trial.columns == 2;
    });
    const Trial *chosen = &*best;
    TextDialect dialect;
    if (best->decimal == ',' && best->columns == 1 && pairs != trials.end()) {
        PairOrNumber question(lines, *best);
        chosen = question.isPair() ? &*pairs : chosen;
        if (!question.isCertain())
            dialect.ambiguous = std::string(trimmed(lines[best->start]));
    }
    dialect.separator = chosen->separator;
    dialect.decimal = chosen->decimal;
    dialect.columns = chosen->columns;
    dialect.header.assign(
        lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(chosen->start));
    if (dialect.decimal == ',' && settings.decimal == "auto" && dialect.ambiguous.empty())
        dialect.ambiguous = groupedCell(text, dialect);
    return dialect;
}

} // namespace dyncal

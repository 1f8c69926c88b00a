// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/table_end.h"

#include "core/base/ascii_text.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/text_table.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

/// How a number is written: digits behind the mark and in the exponent, -1 without one.
struct Shape
{
    Index size = 0;
    Index decimals = -1;
    Index exponentDigits = -1;
};

Shape shapeOf(std::string_view cell, char decimal)
{
    Shape shape{static_cast<Index>(cell.size())};
    const std::size_t exponent = std::min(cell.find_first_of("eE"), cell.size());
    const std::size_t mark = cell.find(decimal);
    if (exponent < cell.size()) {
        const std::size_t digits = cell.find_first_of("0123456789", exponent);
        shape.exponentDigits = static_cast<Index>(cell.size() - std::min(digits, cell.size()));
    }
    if (mark < exponent)
        shape.decimals = static_cast<Index>(exponent - mark - 1);
    return shape;
}

/// Shapes of that column in the last rows before the end.
std::vector<Shape> shapesAbove(std::string_view text, const TextDialect &dialect)
{
    constexpr std::size_t kBytes = 4096;
    const bool fromWithin = text.size() > kBytes;
    std::vector<Shape> shapes;
    LineCursor lines(fromWithin ? text.substr(text.size() - kBytes) : text);
    for (std::string_view line; lines.next(line);) {
        const Index skipped = fromWithin ? 1 : dialect.headerLines();
        if (lines.number() <= skipped)
            continue;
        const std::vector<std::string_view> cells = cellsOf(line, dialect.separator);
        const auto column = static_cast<std::size_t>(dialect.columns) - 1;
        double value = 0.0; // the header may be here, too, and "nan"
        if (column < cells.size()
            && readCell(cells[column], dialect.decimal, value) == CellKind::Number
            && std::isfinite(value))
            shapes.push_back(shapeOf(cells[column], dialect.decimal));
    }
    return shapes;
}

/// Whether a number has all digits that numbers in this column have.
RowEnd compared(const Shape &last, const std::vector<Shape> &above)
{
    const auto range = [&](Index Shape::*part) {
        const auto less = [part](const Shape &a, const Shape &b) { return a.*part < b.*part; };
        const auto [low, high] = std::minmax_element(above.begin(), above.end(), less);
        return std::pair((*low).*part, (*high).*part);
    };
    const auto decimals = range(&Shape::decimals);
    const auto exponent = range(&Shape::exponentDigits);
    const bool fixed = decimals.first == decimals.second && exponent.first == exponent.second
        && (decimals.second > 0 || exponent.second > 0);
    if (fixed && last.decimals == decimals.first && last.exponentDigits == exponent.first)
        return RowEnd::Whole;
    if (fixed) // a number with more digits than those above may be cut, too
        return last.decimals < decimals.first || last.exponentDigits < exponent.first
            ? RowEnd::Cut
            : RowEnd::Unclear;
    const bool exponentCut
        = last.exponentDigits >= 0 && last.exponentDigits < std::max<Index>(1, exponent.second);
    return last.size < range(&Shape::size).first || exponentCut ? RowEnd::Cut : RowEnd::Unclear;
}

} // namespace

RowEnd lastRowEnd(std::string_view text, std::string_view line, const TextDialect &dialect)
{
    const std::vector<std::string_view> cells = cellsOf(line, dialect.separator);
    const auto columns = static_cast<std::size_t>(dialect.columns);
    const bool quoteIsOpen = std::any_of(
        cells.begin(), cells.end(), [](std::string_view cell) { return cell.starts_with('"'); });
    if (quoteIsOpen)
        return RowEnd::Cut; // a quoted cell was cut: "-2 of "-2,5"
    if (cells.size() > columns)
        return RowEnd::Whole; // a separator follows the last number
    double value = 0.0;
    if (cells.size() < columns
        || readCell(cells.back(), dialect.decimal, value) != CellKind::Number)
        return RowEnd::Cut;
    if (trimmed(line).ends_with('"'))
        return RowEnd::Whole; // a quote closes the last number
    const std::vector<Shape> above
        = shapesAbove(text.substr(0, text.size() - line.size()), dialect);
    return above.empty() ? RowEnd::Unclear
                         : compared(shapeOf(cells.back(), dialect.decimal), above);
}

Finding unfinishedLine(const std::string &path, Index line, RowEnd end)
{
    const bool cut = end == RowEnd::Cut;
    return {.id = "CAP-018",
        .severity = cut ? Severity::Caution : Severity::Info,
        .message
        = {cut ? DYNCAL_TEXT("core",
               "%1 ends within line %2, so it is likely an incomplete copy; that line was left out.")
               : DYNCAL_TEXT("core",
                   "%1 ends without a line end; if the copy is incomplete, the last number in line %2 may lack digits."),
            {path, std::to_string(line)}}};
}

} // namespace dyncal

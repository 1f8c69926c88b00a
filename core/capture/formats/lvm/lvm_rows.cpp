// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/lvm/lvm_rows.h"

#include "core/base/text_encoding.h"
#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/formats/text/plain_row.h"

#include <algorithm>
#include <limits>

namespace dyncal {
namespace {

constexpr std::size_t kComments = 10; ///< different ones kept of a comment column
constexpr Index kCarefulRows = 64; ///< at the beginning: how the X cells are printed
constexpr Index kCarefulEvery = 1024; ///< and now and then

} // namespace

LvmRows::LvmRows(const LvmSegment &segment, const LvmFileHeader &file, ExpansionBudget &budget)
    : m_file(file)
    , m_columns(segment.channels.back().column + 1)
    , m_decimal(file.decimal)
    , m_values(segment.channels.size())
    , m_budget(budget)
{
    if (file.xColumns != LvmXColumns::None)
        m_x.resize(file.xColumns == LvmXColumns::One ? 1 : segment.channels.size());
}

bool LvmRows::isX(Index column) const
{
    return stride() == 2 ? column % 2 == 0 : column == 0;
}

bool LvmRows::isEmpty() const
{
    return std::all_of(m_values.begin(), m_values.end(),
        [](const SampleColumn &column) { return column.size() == 0; });
}

void LvmRows::reserve(Index rows)
{
    for (std::vector<SampleColumn> *columns : {&m_values, &m_x}) {
        for (SampleColumn &column : *columns) {
            if (column.size() == m_rows)
                column.reserve(rows);
        }
    }
}

const char *LvmRows::addPlain(std::string_view rest)
{
    if (m_plainCells == 0 || m_rows < kCarefulRows || m_rows % kCarefulEvery == 0 || !m_decimal)
        return nullptr;
    const bool noX = m_file.xColumns == LvmXColumns::None;
    if (noX && !rest.starts_with(m_file.separator))
        return nullptr;
    const Index first = noX ? 1 : 0;
    m_row.resize(static_cast<std::size_t>(m_plainCells - first));
    const PlainRowReader reader(m_file.separator, *m_decimal);
    const char *const behind = reader.read(rest.substr(static_cast<std::size_t>(first)), m_row);
    if (behind == nullptr)
        return nullptr;
    for (Index column = first; column < m_plainCells; ++column) {
        SampleColumn &target = isX(column)
            ? m_x[static_cast<std::size_t>(column / 2)]
            : m_values[static_cast<std::size_t>((column - 1) / stride())];
        if (!store(target, m_row[static_cast<std::size_t>(column - first)]))
            return nullptr;
    }
    ++m_rows;
    return behind;
}

Result<void> LvmRows::add(const std::string &path, std::string_view line, Index number)
{
    CellCursor cells(line, m_file.separator);
    Index column = 0;
    Index numbers = 0;
    bool plain = true;
    for (std::string_view cell; column < m_columns && cells.next(cell); ++column) {
        const CellKind kind = addCell(column, cell);
        if (m_refused > 0)
            return m_budget.exceededBy(
                path, Expanding::RowsUpTo, std::to_string(number), m_refused);
        if (kind == CellKind::Unreadable)
            return unreadableCell(path, number, column + 1, cell);
        const bool counts = kind == CellKind::Number || (column == 0 && m_x.empty());
        plain = plain && (!counts || numbers == column);
        numbers += counts ? 1 : 0;
    }
    m_plainCells = plain && numbers > 1 ? numbers : 0;
    ++m_rows;
    return addTail(path, cells, number);
}

CellKind LvmRows::addCell(Index column, std::string_view cell)
{
    if (!isX(column))
        return addValue((column - 1) / stride(), cell);
    if (m_x.empty())
        return CellKind::Empty;
    return addX(column / 2, cell);
}

CellKind LvmRows::addValue(Index channel, std::string_view cell)
{
    if (!m_decimal && cell.find_first_of(".,") != std::string_view::npos)
        m_decimal = cell.find(',') != std::string_view::npos ? ',' : '.';
    double value = 0.0;
    const CellKind kind = readCell(cell, m_decimal.value_or('.'), value);
    const bool stored
        = kind != CellKind::Number || store(m_values[static_cast<std::size_t>(channel)], value);
    return stored ? kind : CellKind::Unreadable;
}

/// A cell that is no number becomes NaN, which the user of the axis notices.
CellKind LvmRows::addX(Index index, std::string_view cell)
{
    if (cell.empty())
        return CellKind::Empty;
    double value = 0.0;
    char decimal = m_decimal.value_or('.');
    if (!m_decimal && cell.find(',') != std::string_view::npos)
        decimal = ',';
    const bool number = readCell(cell, decimal, value) == CellKind::Number;
    if (number)
        m_xResolution = std::max(m_xResolution, printedResolution(cell, decimal));
    else
        value = std::numeric_limits<double>::quiet_NaN();
    return store(m_x[static_cast<std::size_t>(index)], value) ? CellKind::Number
                                                              : CellKind::Unreadable;
}

/// False if there is no room for all the empty cells that this value claims before it.
bool LvmRows::store(SampleColumn &column, double value)
{
    constexpr std::uint64_t kBytesOfCell = 2 * sizeof(double); // columns grow by doubling
    const Index gap = m_rows - column.size();
    if (gap > 0) {
        const std::uint64_t bytes = static_cast<std::uint64_t>(gap) * kBytesOfCell;
        m_refused = m_budget.take(bytes) ? 0 : m_budget.taken() + bytes;
    }
    if (m_refused > 0)
        return false;
    column.addValueAt(m_rows, value);
    return true;
}

/// A comment may follow the values; it may contain separators.
Result<void> LvmRows::addTail(const std::string &path, CellCursor &cells, Index number)
{
    std::string_view comment;
    if (!cells.next(comment))
        return {};
    double value = 0.0;
    const bool numeric = readCell(comment, m_decimal.value_or('.'), value) != CellKind::Unreadable;
    Index more = 0;
    for (std::string_view cell; numeric && cells.next(cell);)
        more += cell.empty() ? 0 : 1;
    if (more > 0)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1, line %2 has %3 cells more than the header has columns; the file is damaged."),
                {path, std::to_string(number), std::to_string(more)}},
            "CAP-018");
    addComment(comment);
    return {};
}

void LvmRows::addComment(std::string_view comment)
{
    constexpr std::size_t kLongest = 1000;
    if (comment.empty() || m_comments.size() == kComments)
        return;
    std::string text = utf8Text(comment.substr(0, kLongest));
    if (std::find(m_comments.begin(), m_comments.end(), text) == m_comments.end())
        m_comments.push_back(std::move(text));
}

} // namespace dyncal

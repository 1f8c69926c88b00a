// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/formats/bytes/expansion_budget.h"
#include "core/capture/formats/lvm/lvm_header.h"
#include "core/capture/formats/text/text_table.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// The rows of one segment of an LVM file as they are read.
class LvmRows
{
public:
    /// The budget (of all segments) limits the invalid samples that stand for cells missing in the
    /// file.
    LvmRows(const LvmSegment &segment, const LvmFileHeader &file, ExpansionBudget &budget);

    /// Reads the next line of `rest` if it is plain; returns the place after it, or null.
    const char *addPlain(std::string_view rest);

    /// Reads any line. Fails with CAP-018 on a cell that is no number or a line that is too long.
    Result<void> add(const std::string &path, std::string_view line, Index number);

    Index size() const { return m_rows; }

    /// Makes room for so many rows in all columns that have reached the last ones.
    void reserve(Index rows);

    const std::vector<SampleColumn> &values() const { return m_values; } ///< one per channel
    std::vector<SampleColumn> takeValues() { return std::move(m_values); }
    const std::vector<SampleColumn> &x() const { return m_x; } ///< one per X column
    double xResolution() const { return m_xResolution; } ///< of the coarsest X cell looked at
    const std::vector<std::string> &comments() const { return m_comments; } ///< different ones
    std::optional<char> decimal() const { return m_decimal; } ///< as stated, or as the cells show
    bool isEmpty() const;

private:
    Index stride() const { return m_file.xColumns == LvmXColumns::Multi ? 2 : 1; }
    bool isX(Index column) const;
    CellKind addCell(Index column, std::string_view cell);
    CellKind addValue(Index channel, std::string_view cell);
    CellKind addX(Index index, std::string_view cell);
    bool store(SampleColumn &column, double value);
    Result<void> addTail(const std::string &path, CellCursor &cells, Index number);
    void addComment(std::string_view comment);

    const LvmFileHeader &m_file;
    Index m_columns; ///< X and Y
    std::optional<char> m_decimal;
    std::vector<SampleColumn> m_values;
    std::vector<SampleColumn> m_x;
    double m_xResolution = 0.0;
    std::vector<std::string> m_comments;
    std::vector<double> m_row;
    Index m_rows = 0;
    Index m_plainCells
        = 0; ///< leading numbers of the last line that add() read; 0: it was not plain
    ExpansionBudget &m_budget;
    std::uint64_t m_refused = 0; ///< bytes beyond the budget
};

} // namespace dyncal

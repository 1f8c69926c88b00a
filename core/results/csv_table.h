// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// Numbers in columns as CSV: comma, '.' as decimal mark, LF, one header line of names with the
/// unit in them, numbers as the shortest text that reads back the same. Values that are not finite,
/// and those missing in a shorter column, are empty cells.
class CsvTable
{
public:
    void add(std::string name, const Eigen::Ref<const Eigen::VectorXd> &values);
    bool isEmpty() const { return m_columns.empty(); }
    std::string text() const;

private:
    std::vector<std::string> m_names;
    std::vector<Eigen::VectorXd> m_columns;
};

/// A header cell: as spreadsheetText(), quoted where it holds a comma, a semicolon or a quote (RFC
/// 4180).
std::string csvCell(std::string_view text);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/csv_table.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

void CsvTable::add(std::string name, const Eigen::Ref<const Eigen::VectorXd> &values)
{
    m_names.push_back(std::move(name));
    m_columns.emplace_back(values);
}

std::string CsvTable::text() const
{
    std::string text;
    for (const std::string &name : m_names)
        text.append(&name == &m_names.front() ? "" : ",").append(csvCell(name));
    text += '\n';
    Index rows = 0;
    for (const Eigen::VectorXd &column : m_columns)
        rows = std::max(rows, column.size());
    for (Index row = 0; row < rows; ++row) {
        for (std::size_t i = 0; i < m_columns.size(); ++i) {
            if (i > 0)
                text += ',';
            if (row < m_columns[i].size() && std::isfinite(m_columns[i][row]))
                text += numberText(m_columns[i][row]);
        }
        text += '\n';
    }
    return text;
}

std::string csvCell(std::string_view text)
{
    const std::string shown = spreadsheetText(text);
    if (shown.find_first_of(",;\"") == std::string::npos)
        return shown;
    std::string cell(1, '"');
    for (const char c : shown) {
        if (c == '"')
            cell += '"';
        cell += c;
    }
    cell += '"';
    return cell;
}

} // namespace dyncal

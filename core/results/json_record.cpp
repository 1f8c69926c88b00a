// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/json_record.h"

#include <cmath>

namespace dyncal {

void JsonRecord::number(
    const std::string &key, std::optional<double> value, const std::string &reason)
{
    if (value && std::isfinite(*value))
        m_json[key] = *value;
    else
        missing(key, reason);
}

void JsonRecord::text(const std::string &key, const std::string &value, const std::string &reason)
{
    if (!value.empty())
        m_json[key] = value;
    else
        missing(key, reason);
}

void JsonRecord::numbers(const std::string &key, const Eigen::Ref<const Eigen::VectorXd> &values,
    const std::string &reason)
{
    if (values.size() == 0) {
        missing(key, reason);
        return;
    }
    Json list = Json::array();
    for (const double value : values)
        list.push_back(finiteOrNull(value));
    m_json[key] = std::move(list);
    if (!values.allFinite())
        m_json[key + "_reason"] = reason;
}

void JsonRecord::missing(const std::string &key, const std::string &reason)
{
    m_json[key] = nullptr;
    m_json[key + "_reason"] = reason;
}

nlohmann::json finiteOrNull(double value)
{
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json rowsOf(const Eigen::MatrixXd &matrix)
{
    nlohmann::json rows = nlohmann::json::array();
    for (Index i = 0; i < matrix.rows(); ++i) {
        nlohmann::json row = nlohmann::json::array();
        for (Index j = 0; j < matrix.cols(); ++j)
            row.push_back(finiteOrNull(matrix(i, j)));
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace dyncal

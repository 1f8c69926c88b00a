// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace dyncal {

/// A JSON object of results in which nothing is omitted silently: a value that is missing or not
/// finite becomes null with "<key>_reason" beside it. Internal to core/results.
class JsonRecord
{
public:
    using Json = nlohmann::json;

    void set(const std::string &key, Json value) { m_json[key] = std::move(value); }
    /// The number, or null and the reason if there is none or it is not finite.
    void number(const std::string &key, std::optional<double> value, const std::string &reason);
    /// The text, or null and the reason if it is empty.
    void text(const std::string &key, const std::string &value, const std::string &reason);
    /// A list of numbers; null and the reason if it is empty. Single values that are not finite
    /// become null, with the reason beside the list.
    void numbers(const std::string &key, const Eigen::Ref<const Eigen::VectorXd> &values,
        const std::string &reason);
    void missing(const std::string &key, const std::string &reason);

    Json take() { return std::move(m_json); }

private:
    Json m_json = Json::object();
};

/// The number, or null where it is not finite.
nlohmann::json finiteOrNull(double value);
/// A matrix as list of its rows.
nlohmann::json rowsOf(const Eigen::MatrixXd &matrix);

} // namespace dyncal

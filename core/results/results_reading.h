// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <string>

namespace dyncal {

// A results.json read back: what it says as values, whatever it may lack.

inline constexpr const char *kResultsSchema = "dyncal-results/1";

/// The text of a results.json; `name` is that of the file, for sentences. Fails (Usage) on
/// malformed JSON (parseStrictJson) and on another schema; of a later one the sentence says that.
Result<nlohmann::json> parseResults(const std::string &text, const std::string &name);

/// The value at `key`; null where there is none.
const nlohmann::json &valueAt(const nlohmann::json &object, const std::string &key);
/// The number, or NaN.
double numberAt(const nlohmann::json &object, const std::string &key);
/// A list of numbers, NaN where one is none; empty where it is no list.
Eigen::VectorXd numbersAt(const nlohmann::json &object, const std::string &key);
/// The text, or "".
std::string textAt(const nlohmann::json &object, const std::string &key);

} // namespace dyncal

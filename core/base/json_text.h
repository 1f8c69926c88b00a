// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace dyncal {

/// JSON as every file and answer of the program has it: indented by two, valid UTF-8 whatever the
/// texts hold, and nothing in it that acts on a terminal (presentableJson). Ends with a line break.
std::string jsonText(const nlohmann::json &json);

/// The same on one line, for files with a value on each. Ends with a line break.
std::string jsonLine(const nlohmann::json &json);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace dyncal {

/// Internal to core/project: the JSON library is not part of any public header.
using Json = nlohmann::json;

inline constexpr Index kDeepestJson = 16;

/// Reads the whole of `text` as one JSON value. Fails (Usage) on malformed text with line and
/// column, on a key that stands twice in one object (the library would silently keep the last), on
/// nesting deeper than kDeepestJson and on anything after the value. `what` names the text in
/// sentences ("The recipe").
Result<Json> parseStrictJson(const std::string &text, const std::string &what);

/// Fails as parseStrictJson, without the value.
Result<void> checkStrictJson(const std::string &text, const std::string &what);

} // namespace dyncal

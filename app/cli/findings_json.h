// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"

#include <nlohmann/json.hpp>

namespace dyncal {

/// Findings as `dyncal info` and `dyncal check` print them (docs/command-line.md); what a finding
/// does not have is null.
nlohmann::json findingsJson(const Findings &findings);

/// Null for an empty text.
nlohmann::json textOrNull(const std::string &text);

} // namespace dyncal

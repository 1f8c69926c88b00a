// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/calibration_results.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// The version of each stage's method by the stage's name in results.json ("monte_carlo" -> 1): two
/// programs with equal versions give equal numbers (docs/accuracy.md).
using MethodVersions = std::map<std::string, int>;

MethodVersions methodVersions();

/// The name of a stage as results.json has it: "Monte Carlo" -> "monte_carlo".
std::string methodKey(std::string name);

/// The stage whose name has this key; empty if there is none.
std::optional<StageId> stageOfMethod(std::string_view key);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <array>
#include <optional>
#include <string>

namespace dyncal {

/// For every stage the hash of all it is computed from: the recordings and the recipe sections of
/// the stage and of those it follows (`Stage::follows`). Equal keys mean equal
/// results: the one table behind caching, stale marks and instant undo.
std::array<std::string, kStageCount> stageKeys(const CaptureSet &captures, const Recipe &recipe);

/// The first stage that reads different sections of two recipes: the first whose key can differ.
/// Empty when none does (texts of the certificate, acknowledgements).
std::optional<StageId> firstDifferentStage(const Recipe &before, const Recipe &after);

} // namespace dyncal

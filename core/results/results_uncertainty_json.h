// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/results/json_record.h"
#include "core/results/results_context.h"

#include <string>

namespace dyncal {

/// Of S(f) at most have their budgets: each has some twenty lines.
inline constexpr Index kMostBudgetRows = 200;

/// Keys of a section `response` that hold complete uncertainties. `ofRows`: those of `response`;
/// null where there are none, for the reason `whyMissing`.
void addRowUncertainty(JsonRecord &section, const ResponseResult &response,
    const RowUncertainty *ofRows, const std::string &whyMissing);

/// Section `characteristics`.
void addCharacteristics(JsonRecord &root, const ResultsContext &context);

/// Section `budget`.
void addBudget(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

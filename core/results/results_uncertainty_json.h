// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/json_record.h"
#include "core/results/results_context.h"

#include <string>

namespace dyncal {

/// Keys of a section `response` that hold complete uncertainties. `report`: null where there is
/// none, for the reason `whyMissing`.
void addRowUncertainty(JsonRecord &section, const ResponseResult &response,
    const UncertaintyReport *report, const std::string &whyMissing);

/// Section `characteristics`.
void addCharacteristics(JsonRecord &root, const ResultsContext &context);

/// Sections `budget` and `gum_validated_by_monte_carlo`.
void addBudget(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/json_record.h"
#include "core/results/results_context.h"

namespace dyncal {

/// Keys of section `response` that hold complete uncertainties.
void addRowUncertainty(JsonRecord &section, const ResultsContext &context);

/// Section `characteristics`.
void addCharacteristics(JsonRecord &root, const ResultsContext &context);

/// Sections `budget` and `gum_validated_by_monte_carlo`.
void addBudget(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

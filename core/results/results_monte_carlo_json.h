// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// Sections `monte_carlo` and `gum_validated_by_monte_carlo`.
void addChainMonteCarlo(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// The evidence of all orders: keys of the section "realization".
void addOrderEvidence(JsonRecord &section, const ResultsContext &context);

} // namespace dyncal

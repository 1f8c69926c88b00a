// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/json_record.h"
#include "core/results/results_context.h"

namespace dyncal {

/// Section "conformity" of results.json: null where the recipe has no certificate.decision.
void addConformity(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

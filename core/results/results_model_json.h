// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// The section "model" of results.json.
void addModel(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

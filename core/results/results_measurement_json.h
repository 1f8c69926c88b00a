// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// The sections "inputs" and "shots" of results.json.
void addInputs(JsonRecord &root, const ResultsContext &context);
void addShots(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// The sections "response" and "bands" of results.json.
void addResponse(JsonRecord &root, const ResultsContext &context);
void addBands(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

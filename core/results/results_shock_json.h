// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// The section "shock" of results.json.
void addShock(JsonRecord &root, const ResultsContext &context);
/// Resonances of the tube beside those of the spectrum; part of the section "spectrum".
void addCandidates(JsonRecord &section, const ResultsContext &context);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// Adds `sensitivity`: the mean over the shots with its uncertainty, per level, and whether the
/// shots agree. Internal to core/results, as is the next.
void addSensitivitySummary(JsonRecord &root, const ResultsContext &context);

/// Adds `drift`: per shot, from the level at the onset to the settle band; empty without one.
void addDrift(JsonRecord &root, const ResultsContext &context);

/// Top-level "echo": the echoes found, and where the records end because of them.
void addEchoes(JsonRecord &root, const ResultsContext &context);

/// Adds sensitivity, its u and k to the entry of a shot (number from 1).
void addShotSensitivity(JsonRecord &record, Index shot, const ResultsContext &context);

} // namespace dyncal

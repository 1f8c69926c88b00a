// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/results_context.h"

namespace dyncal {

/// The sections "spectrum", "pca", "input" and "realization" of results.json.
void addSpectrum(JsonRecord &root, const ResultsContext &context);
void addComponents(JsonRecord &root, const ResultsContext &context);
void addModelInput(JsonRecord &root, const ResultsContext &context);
void addRealization(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

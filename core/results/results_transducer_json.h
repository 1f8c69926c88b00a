// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/results/json_record.h"
#include "core/results/results_context.h"

namespace dyncal {

/// Section `comparison` of results.json: the response against a reference transducer, and how it
/// agrees with that against the step.
void addTransducerComparison(JsonRecord &root, const ResultsContext &context);

/// Key "chain": the response of amplifier and converter that is divided out of S(f).
void addChain(JsonRecord &root, const ResultsContext &context);

} // namespace dyncal

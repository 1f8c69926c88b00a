// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <string>

namespace dyncal {

/// results.json, schema "dyncal-results/1": UTF-8, sorted keys, two-space indent, LF, shortest
/// round-trip numbers; never NaN or Infinity (null with "<key>_reason" beside it). `createdUtc` is
/// ISO 8601 with Z. A run that was blocked still gives every section, null where nothing is.
std::string resultsJson(
    const PipelineOutcome &outcome, const Recipe &recipe, const std::string &createdUtc);

/// Findings of all stages and the error that stopped the run, if that is one of the catalogue and
/// not among them already: the list of results.json.
Findings allFindings(const PipelineOutcome &outcome);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <string>

namespace dyncal {

/// results.json, schema "dyncal-results/1": UTF-8, sorted keys, two-space indent, LF, shortest
/// round-trip numbers; never NaN or Infinity (null with "<key>_reason" beside it). `createdUtc` is
/// ISO 8601 with Z. A blocked run still has every section, with null for missing values.
std::string resultsJson(
    const PipelineOutcome &outcome, const Recipe &recipe, const std::string &createdUtc);

/// The list of results.json: findings of all stages and the error that stopped the run, if that has
/// an id of the catalogue and is not among them already.
Findings allFindings(const PipelineOutcome &outcome);

} // namespace dyncal

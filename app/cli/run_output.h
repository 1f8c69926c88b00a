// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <string>
#include <vector>

namespace dyncal {

/// Makes the folder (Usage if it cannot be made).
Result<void> makeFolder(const std::string &folder);

/// Writes what `dyncal run` promises into an existing folder: csv/*.csv, certificate.pdf and
/// plots/*.svg (only of a run that came to its end), recipe.json, and results.json last, so that a
/// folder with results.json is complete. What an earlier run left there goes first: no certificate
/// of other data stays beside new results. Returns the paths to show, results.json first.
Result<std::vector<std::string>> writeRun(const PipelineOutcome &outcome, const Recipe &recipe,
    const std::string &createdUtc, const std::string &folder);

} // namespace dyncal

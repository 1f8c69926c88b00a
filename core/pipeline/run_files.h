// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <string>
#include <vector>

namespace dyncal {

/// A document drawn in memory: "certificate.pdf", "plots/01-raw-dut.svg".
struct DrawnFile
{
    std::string name; ///< relative to the folder of the run, '/' between its parts
    std::string bytes;
};

/// What a run leaves on disk.
struct RunFiles
{
    PipelineOutcome outcome;
    Recipe recipe;
    std::string createdUtc; ///< ISO 8601 with Z
    std::vector<DrawnFile> drawn; ///< none of a run that did not come to its end
};

/// Makes the folder (Usage if it cannot be made).
Result<void> makeFolder(const std::string &folder);

/// Writes what `dyncal run` promises into an existing folder: recipe.json, csv/*.csv, model/*, the
/// drawn documents, and results.json last, so that a folder with results.json is complete. What an
/// earlier run left there goes first: no certificate of other data stays beside new results.
/// Returns the paths to show, results.json first. Asked to stop between two files it leaves a
/// folder without results.json (Cancelled).
Result<std::vector<std::string>> writeRunFiles(
    const RunFiles &run, const std::string &folder, const JobControl &control = {});

} // namespace dyncal

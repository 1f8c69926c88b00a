// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/writing/folder_write.h"
#include "core/pipeline/pipeline.h"
#include "core/project/template_choice.h"

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
    std::vector<DrawnFile> drawn; ///< none of a run that may not be published
    std::string record = {}; ///< of a batch: what kBatchRecord is to hold; empty: none is written
    ChosenTemplate chosen = {}; ///< of the certificate; its file is kept as the recipe's tables are
};

/// Name of the file by which a batch knows what it has computed.
inline constexpr const char *kBatchRecord = "batch.json";

/// The folder of a run: what it writes there, and that it may hold no recording of `set`. Nothing
/// is put there if the recordings are not whole when it is to be (checkStillWhole). `settings`:
/// paths of the recipe and profile that were given.
FolderRequest runFolder(
    const std::string &folder, const CaptureSet &set, std::vector<std::string> settings = {});

/// Writes what `dyncal run` promises as one transaction: recipe.json, csv/*.csv, model/*, the drawn
/// documents, results.json, and written.json, which lists them with their hashes. A run that may
/// not be published (publication.h) writes recipe.json, results.json and written.json only. Files
/// of an earlier run are removed in the same step, so that no certificate of other data stays
/// beside new results. Returns the paths to show, results.json first. Fails as FolderWrite::commit;
/// the folder is then unchanged.
Result<std::vector<std::string>> writeRunFiles(
    const RunFiles &run, FolderWrite &folder, const JobControl &control = {});

/// The folder of an exported model; recordings as for runFolder.
FolderRequest modelFolder(
    const std::string &folder, const CaptureSet &set, std::vector<std::string> settings = {});

/// Writes the model in the given formats (modelFormats) as one transaction; returns the paths.
/// Files of an earlier export are removed, whatever their format: two models never lie side by
/// side. Fails as FolderWrite::commit, and with MOD-001 (DataBlocked) if the model diverges.
Result<std::vector<std::string>> writeModelFiles(const CalibrationResults &results,
    const std::vector<std::string> &formats, FolderWrite &folder, const JobControl &control = {});

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/base/writing/folder_write.h"
#include "core/capture/capture_set.h"
#include "core/correction/calibrated_response.h"
#include "core/correction/record_pressure.h"

#include <string>
#include <vector>

namespace dyncal {

/// The pressure behind the DUT's channel of one shot.
struct ShotPressure
{
    Index shot = 0; ///< from 1
    std::string channel;
    RecordPressure record;
};

/// A results.json and what it says.
struct CalibrationSource
{
    CalibratedResponse says;
    std::string path; ///< as given; "" of one that is no file
    std::string file; ///< its base name
    std::string sha256;
    std::string text;
};

/// A correction as it leaves the program.
struct CorrectionOutcome
{
    CalibrationSource calibration;
    std::vector<InputFile> recordings;
    CorrectionFilter filter;
    std::vector<ShotPressure> shots;
    bool isBoundStated = false; ///< by the customer, not from the recording
};

/// What the recordings of the shots told while they were corrected (COR-001).
Findings findingsOf(const CorrectionOutcome &outcome);

/// The folder of a correction: what it writes there, and that it may hold no recording of `set`.
/// `others`: paths of recipe, profile and results that were given.
FolderRequest correctionFolder(
    const std::string &folder, const CaptureSet &set, std::vector<std::string> others);

/// Writes, as one transaction, correction.json (schema "dyncal-correction/1"), pressure_shot_N.csv
/// of every shot, the filter as filter.json, filter.csv, filter_errors.csv, filter.mat and
/// filter.py, and the results.json that it was made from as calibration.json: with it and the
/// recordings the correction can be repeated. An earlier correction there is replaced. Returns the
/// paths. Fails as FolderWrite::commit.
Result<std::vector<std::string>> writeCorrection(
    const CorrectionOutcome &outcome, FolderWrite &folder, const JobControl &control = {});

} // namespace dyncal

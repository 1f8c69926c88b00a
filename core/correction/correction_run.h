// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/correction/correction_files.h"

#include <string>

namespace dyncal {

/// The results.json at `path`, or in the folder there, with its hash. Fails (FileUnreadable) where
/// it cannot be read, and as calibratedResponse().
Result<CalibrationSource> calibrationAt(const std::string &path);

/// The same of a text that is no file: `name` is the name it would have.
Result<CalibrationSource> calibrationOf(std::string text, const std::string &name);

/// False where a finding of the recordings (prepareCaptures) blocks, or the record of a DUT left
/// the range of its converter (CAP-007): then no pressure follows from it.
bool areCorrectable(const Findings &findings, const CaptureSet &set);

/// Filter and pressure of the DUT of every included shot of sealed recordings, prepared by their
/// import settings (prepareCaptures); the filter is for the rate of the first of them. Fails as
/// designCorrection() and recordPressure(), and (DataBlocked, CAP-002) where a shot has no channel
/// of the DUT, (Cancelled) when asked to stop.
Result<CorrectionOutcome> correctRecordings(const CalibrationSource &calibration,
    const CaptureSet &set, const CorrectionSettings &filter, const RecordOptions &options = {},
    const JobControl &control = {});

} // namespace dyncal

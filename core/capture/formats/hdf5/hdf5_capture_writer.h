// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"

#include <map>
#include <string>
#include <vector>

namespace dyncal {

/// True parameters of one simulated shot, written to /truth/shot_NNN as attributes. No analysis
/// reads them.
using ShotTruth = std::map<std::string, double>;

/// Where a capture goes.
struct CaptureTarget
{
    std::string path;
    bool replace = false; ///< an existing regular file; else the name must be free
};

/// Writes a capture: chunks of 1 Mi samples, no filters, sha256 per channel, through a temporary
/// file that gets its name when complete (PendingFile; every HDF5 return code is checked and all
/// samples are read back). Recordings that did not stay whole meanwhile
/// are CAP-015 (checkStillWhole). `createdUtc` ISO 8601 with Z. The same input gives the same
/// bytes.
Result<void> writeHdf5Capture(const CaptureSet &set, const CaptureTarget &target,
    const std::string &createdUtc, const std::string &title,
    const std::vector<ShotTruth> &truth = {}, const JobControl &control = {});

} // namespace dyncal

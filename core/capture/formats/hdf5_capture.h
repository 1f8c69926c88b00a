// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/import_settings.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

struct Hdf5File;

/// How sure it is that the file is a capture in our HDF5 layout (docs/method/captures.md), 0..100.
int recogniseHdf5Capture(const std::string &path, std::string_view head);

/// Reads a capture of layout version 1.x. Unknown major version, missing groups, truncated data,
/// counts that claim more than the file holds: FileUnreadable with the sentence that says which.
Result<CaptureSet> readHdf5Capture(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

/// The same for a file that is described already (hdf5_open.h); nothing it claims is believed.
Result<CaptureSet> readHdf5Capture(const Hdf5File &file, const JobControl &control);

/// True parameters of one simulated shot, written to /truth/shot_NNN as attributes. No analysis
/// reads them.
using ShotTruth = std::map<std::string, double>;

/// Where a capture goes.
struct CaptureTarget
{
    std::string path;
    bool replace = false; ///< a regular file of this name; captures are written once otherwise
};

/// Writes a capture: chunks of 1 Mi samples, no filters, sha256 per channel, through a temporary
/// file that gets its name when complete (PendingFile; every HDF5 return code is checked and all
/// samples are read back). `createdUtc` ISO 8601 with Z. The same input gives the same bytes.
Result<void> writeHdf5Capture(const CaptureSet &set, const CaptureTarget &target,
    const std::string &createdUtc, const std::string &title,
    const std::vector<ShotTruth> &truth = {}, const JobControl &control = {});

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/import_settings.h"

#include <string>
#include <string_view>

namespace dyncal {

struct Hdf5File;

/// How sure it is that the file is a capture in our HDF5 layout (docs/method/captures.md), 0..100.
int recogniseHdf5Capture(const std::string &path, std::string_view head);

/// Reads a capture of layout version 1.x. Unknown major version, missing groups, truncated data,
/// counts that claim more than the file holds: FileUnreadable with the sentence that says which.
Result<CaptureSet> readHdf5Capture(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

/// The same for a file that is described already (hdf5_open.h); its claims are checked.
Result<CaptureSet> readHdf5Capture(const Hdf5File &file, const JobControl &control);

} // namespace dyncal

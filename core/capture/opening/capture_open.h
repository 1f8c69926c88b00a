// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/capture/import_settings.h"

#include <string>
#include <vector>

namespace dyncal {

/// Reads one file as far as needed to show it: no hash is computed, samples may stay in the file.
/// Fails as formatOf() and the format's reader do.
Result<CaptureSet> openCapture(
    const std::string &path, const ImportSettings &settings, const JobControl &control = {});

/// Opens several files, or folders (every readable file in natural order; unreadable ones there are
/// skipped with a finding), and joins their shots in the order given. The Error lists the problems
/// of all files; a set without shots is an error too. Calibrate from the set only after
/// sealCaptures() (capture_seal.h).
Result<CaptureSet> openCaptures(const std::vector<std::string> &paths,
    const ImportSettings &settings, const JobControl &control = {});

/// Opened and sealed.
Result<CaptureSet> readCapture(
    const std::string &path, const ImportSettings &settings, const JobControl &control = {});
Result<CaptureSet> readCaptures(const std::vector<std::string> &paths,
    const ImportSettings &settings, const JobControl &control = {});

} // namespace dyncal

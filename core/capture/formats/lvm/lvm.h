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

/// 100 if the file begins with "LabVIEW Measurement", else 0.
int recogniseLvm(const std::string &path, std::string_view head);

/// Reads a LabVIEW measurement file. Every segment is a shot, every Y column a channel (role Other;
/// channels may end early). The time axis is X0 + k Delta_X, because X cells are printed with six
/// decimals; where the X cells contradict it (CAP-016) the rate stays 0. Declared sample counts are
/// only compared (CAP-018). A file that ends early keeps its whole rows (CAP-018, caution); one
/// without any whole row, or with a cell that is no number, fails with CAP-018.
Result<CaptureSet> readLvm(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

} // namespace dyncal

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

/// 100 if the file begins as MAT of version 5 to 7.2, 90 if as version 4 (which has no mark); else
/// 0.
int recogniseMat(const std::string &path, std::string_view head);

/// Reads a MATLAB file of version 4 or 5 to 7.2 as one shot: every real numeric vector is a
/// channel, every matrix one per column (per row if it is wider than long). The rate comes from
/// scalars (fs, sample_rate, dt, ts, ...), from a vector t or time (in s unless its name says _ms,
/// _us, _ns), or from a first or last column that is a uniform axis; such a column has no unit, so
/// without a scalar or settings.sampleRate_Hz that fits it the rate stays 0 (CAP-016). Where they
/// contradict each other it is 0 too (CAP-003). Everything else is left out (CAP-026). Damaged and
/// cut files are refused (CAP-018).
Result<CaptureSet> readMat(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

} // namespace dyncal

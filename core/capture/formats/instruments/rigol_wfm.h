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

/// 100 for the .wfm files that are read, 50 for .wfm files of other known families of Rigol and
/// Tektronix, so that they are refused by name; else 0.
int recogniseRigolWfm(const std::string &path, std::string_view head);

/// Reads the waveform memory (.wfm) of Rigol oscilloscopes of the families DS1000E/D and DS1000B:
/// 8-bit counts that stay in the file, one channel each. Only what the oscilloscopes' own CSV files
/// prove is read; inverted channels, rolling and alternating acquisitions, logic data and all other
/// families are refused by name (CAP-001), damaged or cut files too (CAP-018).
Result<CaptureSet> readRigolWfm(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

} // namespace dyncal

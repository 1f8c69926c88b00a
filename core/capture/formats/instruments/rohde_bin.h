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

/// 100 if the file begins as the XML description of a Rohde & Schwarz waveform; 60 for its samples
/// (name.Wfm.bin), which are refused with the name of the file to open; else 0.
int recogniseRohdeBin(const std::string &path, std::string_view head);

/// Reads a Rohde & Schwarz RTP/RTO waveform: name.bin (XML) describes name.Wfm.bin beside it, which
/// has the samples as float32, as float64 time and float32 values, or (one channel) as 8-bit
/// counts. They stay there. Histories, 16-bit counts and traces that are no samples are refused by
/// name (CAP-001), files that are damaged, cut or do not fit together too (CAP-018).
Result<CaptureSet> readRohdeBin(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

} // namespace dyncal

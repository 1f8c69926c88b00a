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

/// 100 if the file begins with AG01, AG03 or AG10 (RG01, RG03), else 0.
int recogniseKeysightBin(const std::string &path, std::string_view head);
int recogniseRigolBin(const std::string &path, std::string_view head);

/// Reads the binary waveform file of Keysight/Agilent InfiniiVision (AG..) or Rigol MSO5000 and DHO
/// oscilloscopes (RG..), which is one container. Channels are float32 in the unit of the file and
/// stay in it; saved segments become shots; time 0 is the trigger. Digital channels, histograms
/// and spectra are left out (CAP-026). Peak-detect records, whose samples are not uniform, and
/// layouts that no sample file has proven are refused (CAP-001), damaged or cut files too
/// (CAP-018).
Result<CaptureSet> readKeysightBin(
    const std::string &path, const ImportSettings &settings, const JobControl &control);
Result<CaptureSet> readRigolBin(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

} // namespace dyncal

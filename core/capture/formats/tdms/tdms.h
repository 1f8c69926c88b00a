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

/// 100 if the file begins like a TDMS file or the index of one, else 0.
int recogniseTdms(const std::string &path, std::string_view head);

/// Reads an NI TDMS file (versions 1 and 2): plain, interleaved and DAQmx raw data, NI_Scale
/// chains, waveform properties, logs of SignalExpress. Only metadata are read; samples stay in the
/// file, counts stay counts with their scale as Channel::polynomial. Rate from wf_increment (0
/// without, CAP-003), first sample at wf_start_offset. A file that ends early or is damaged after
/// its first segment keeps all complete values (CAP-018, caution); channels that cannot be read
/// correctly (texts, time stamps, complex numbers, scales that are not applied) are left out
/// (CAP-026); DAQmx counts without a scale stay counts (CAP-027). Fails with CAP-018 if nothing can
/// be read, CAP-001 for the index of a TDMS file.
Result<CaptureSet> readTdms(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

} // namespace dyncal

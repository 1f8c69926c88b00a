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

/// 100 if the file begins with a LeCroy WAVEDESC block, also after the "#9..." of a transfer.
int recogniseLecroyTrc(const std::string &path, std::string_view head);

/// Reads a LeCroy waveform (.trc), templates LECROY_2_3 and LECROY_1_0, either byte order, 8 or
/// 16 bits: one channel, whose counts stay in the file; the segments of a sequence become shots,
/// each with its own trigger as time 0. Other templates, and records that are no uniformly sampled
/// signal (histogram, spectrum, extrema, interleaved sampling, sparse transfer), are refused
/// (CAP-001), damaged or cut files too (CAP-018).
Result<CaptureSet> readLecroyTrc(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

} // namespace dyncal

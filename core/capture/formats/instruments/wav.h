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

/// 100 if the file begins as a WAV: RIFF, RIFX, RF64 or BW64 with "WAVE"; else 0.
int recogniseWav(const std::string &path, std::string_view head);

/// Reads a WAV file: integers of 1 to 32 bits, floats of 32 and 64 bits, also with the extensible
/// header, in either byte order and longer than 4 GB. Full scale is 1 and the unit "1": counts stay
/// integers (24 bits become int32 when they are read), the polynomial scales them. The samples stay
/// in the file. A length that was never written (a stream) means up to the end of the file; a file
/// that ends early keeps its whole frames (both CAP-018). Rate 0 where the header contradicts
/// itself (CAP-016). Compressed or longer samples are refused (CAP-001), damaged files too
/// (CAP-018).
Result<CaptureSet> readWav(
    const std::string &path, const ImportSettings &settings, const JobControl &control);

} // namespace dyncal

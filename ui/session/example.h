// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"

namespace dyncal {

/// Path under which the built-in example is listed in projects; it is no file.
inline constexpr const char *kExamplePath = "example:optic3";

/// The example: three simulated shots of the preset "optic3", as `dyncal simulate` makes them
/// without options. The same counts on every machine, so a project that refers to it can be opened
/// anywhere. `duration_s` is shortened only by tests.
Result<CaptureSet> exampleCaptures(const JobControl &control = {}, double duration_s = 0.02);

} // namespace dyncal

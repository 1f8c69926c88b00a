// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/file_samples.h"
#include "core/capture/formats/matlab/mat_variable.h"
#include "core/capture/raw_samples.h"

#include <memory>
#include <optional>

namespace dyncal {

/// Bytes of one number; 0 for a code that is no number.
Index bytesOfMatNumber(MatNumber number);

/// The numbers first, first + step, ... of a numeric variable; all `count` must exist. They stay in
/// the file where possible; unsigned 32-bit and 64-bit integers become float64. Empty if a 64-bit
/// integer is no exact float64 or the file cannot be read any more.
std::optional<RawSamples> matSamples(const std::shared_ptr<const SampleFile> &file,
    const MatVariable &variable, Index first, Index step, Index count);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5/hdf5_capture_writer.h"

#include <string>
#include <vector>

namespace dyncal {

/// To be called before any work for the capture begins. Fails (Usage) if the target is one of the
/// inputs (also by another name) or exists and is not to be replaced.
Result<void> checkCaptureTarget(
    const CaptureTarget &target, const std::vector<std::string> &inputs);

} // namespace dyncal

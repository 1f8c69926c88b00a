// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/formats/hdf5/hdf5_open.h"
#include "core/capture/formats/hdf5/hdf5_places.h"
#include "core/capture/raw_samples.h"

#include <vector>

namespace dyncal {

/// The samples of each wish, column by column (one of a 1-D dataset or a single value). Samples
/// that lie in the file unpacked stay there; the others are unpacked into memory by a helper
/// process. The description's claims are checked; the memory of the samples counts in the file's
/// budget. Errors name dataset and file (CAP-018).
Result<std::vector<std::vector<RawSamples>>> hdf5Columns(
    const Hdf5File &file, const std::vector<Hdf5Wish> &wishes, const JobControl &control);

} // namespace dyncal

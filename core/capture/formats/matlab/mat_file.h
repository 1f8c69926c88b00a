// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/file_samples.h"
#include "core/capture/formats/bytes/expansion_budget.h"
#include "core/capture/formats/matlab/mat_variable.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// 4 for the version 4, 5 for the versions 5 to 7.2; 0 = neither (7.3 is HDF5).
int matVersion(std::string_view head);

/// Lists the variables of a MAT file of version 4 or 5 to 7.2. Compressed matrices are expanded
/// into memory; fails if the budget does not allow it. Fails with CAP-018 where the file is cut or
/// contradicts itself.
Result<std::vector<MatVariable>> listMatFile(const std::string &path,
    const std::shared_ptr<const SampleFile> &file, ExpansionBudget &budget,
    const JobControl &control);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/pipeline/pipeline.h"
#include "core/project/recipe.h"

#include <string>
#include <vector>

namespace dyncal {

/// Writes certificate.pdf and plots/NN-name.svg into `directory` (made if missing) and returns the
/// paths to show: of the certificate, and of the folder of plots if there are any. Each file
/// appears whole or not at all. Needs a QApplication. `createdUtc` (ISO 8601 with Z) is printed and
/// makes the bytes reproducible. All texts are in the language of the recipe's certificate.
Result<std::vector<std::string>> writeReport(const CalibrationResults &results,
    const Recipe &recipe, const std::string &createdUtc, const std::string &directory);

} // namespace dyncal

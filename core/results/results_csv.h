// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <string>
#include <vector>

namespace dyncal {

/// One file of csv/.
struct CsvFile
{
    std::string name; ///< "spectrum_shot_001.csv"
    std::string text;
};

/// The numbers behind the plots at full resolution, as far as the results go: spectrum and response
/// of every shot, components, model input, singular values, model against data, poles, frequency
/// response. Files, columns and units: docs/recipe.md, "What a run writes".
std::vector<CsvFile> resultsCsv(const CalibrationResults &results);

} // namespace dyncal

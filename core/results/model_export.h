// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <string>
#include <vector>

namespace dyncal {

/// One form in which the model leaves the program.
struct ModelFile
{
    std::string name; ///< "model.mat"
    std::string format; ///< "mat", "json", "csv", "m" or "py"
    std::string bytes;
};

/// The model for use elsewhere (docs/command-line.md): A, B, C, D with the sampling interval, c0,
/// c_i and s_i as MAT, JSON and CSV, and a MATLAB and a Python script that load model.mat and
/// reproduce the response. Empty without a model and for one that diverges.
std::vector<ModelFile> modelFiles(const CalibrationResults &results);

/// Names of all files that modelFiles() can give.
const std::vector<std::string> &modelFileNames();

/// "mat", "json", "csv", "m", "py".
const std::vector<std::string> &modelFormats();

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

namespace dyncal {

/// Spectra and resonances without the recipe's nuisance modes. Needs window and spectrum.
SpectrumResult sensorSpectrum(const CalibrationResults &results, const Recipe &recipe);

/// The responses up to the first echo; empty where none ends them, so that they are not copied.
std::optional<std::vector<WindowedResponse>> recordsBefore(
    const Echoes &echoes, const std::vector<WindowedResponse> &responses);

/// The model input, up to the first echo, with the recipe's nuisance modes found in it. Needs
/// captures, window, spectrum and components.
Result<ModelInput> separatedInput(
    const CalibrationResults &results, const Recipe &recipe, const JobControl &control);

} // namespace dyncal

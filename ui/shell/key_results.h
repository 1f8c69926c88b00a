// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <QString>

#include <vector>

namespace dyncal {

/// One number that the whole work is done for.
struct KeyResult
{
    QString name; ///< object name of its label: "keySensitivity"
    QString text; ///< "f0 2.329980(12) MHz"; a dash where it is not known
    QString meaning; ///< in full, with what u is
};

/// Sensitivity, natural frequency, damping ratio and pressure step, each with its standard
/// uncertainty where that is known. Of a free decay frequency and damping alone: it has no others.
std::vector<KeyResult> keyResults(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

namespace dyncal {

/// The frequency response: of a pressure step as sensitivity, of an unknown step normalised. A row
/// for every frequency inside the band where an answer exists (fLow_Hz to fHigh_Hz), and always for
/// the marked ones (ResponseResult::atMarks), each named; the model's columns end at half its rate.
/// A free decay has none.
CertificateSection frequencyResponseSection(
    const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

namespace dyncal {

/// The results; a section without results says so.
CertificateSection resultsSection(const CalibrationResults &results);
CertificateSection shotsSection(const CalibrationResults &results);
CertificateSection modelSection(const CalibrationResults &results, const Recipe &recipe);
CertificateSection frequencyResponseSection(const CalibrationResults &results);
CertificateSection figuresSection(const CalibrationResults &results);

} // namespace dyncal

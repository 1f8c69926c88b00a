// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/certificate_template.h"
#include "core/project/recipe.h"

namespace dyncal {

/// The results; a section without results says so. What a calibration of the kind does not
/// determine (calibration_kind.h) has no line and no column.
CertificateSection resultsSection(const CalibrationResults &results, const Recipe &recipe,
    const CertificateTemplate &layout = {});
CertificateSection shotsSection(const CalibrationResults &results, const Recipe &recipe);
CertificateSection modelSection(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal

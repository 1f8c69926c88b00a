// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

namespace dyncal {

/// How the sensor was calibrated; the sentences follow from the kind (calibration_kind.h).
CertificateSection methodSection(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"

namespace dyncal {

/// Appends the sensitivity of the shots together: their mean with U, or level by level where they
/// do not agree; its trend over the steps; and the drift behind the step. Internal to
/// core/certificate.
void addSensitivity(const CalibrationResults &results, CertificateSection &section);

/// Sensitivity of one shot (number from 1) with U where that is known.
Message shotSensitivityText(const CalibrationResults &results, Index shot);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/result_quantity.h"
#include "core/pipeline/calibration_results.h"

#include <vector>

namespace dyncal {

/// The sensitivity of the shots together: their mean, or one value per level where they do not
/// agree. Internal to core/certificate.
std::vector<ResultQuantity> sensitivityQuantities(const CalibrationResults &results);

/// Appends what belongs to it: that the shots disagree, its trend over the steps, and the drift
/// behind the step.
void addSensitivityDetails(const CalibrationResults &results, CertificateSection &section);

/// Sensitivity of one shot (number from 1) with U where that is known.
Message shotSensitivityText(const CalibrationResults &results, Index shot);

} // namespace dyncal

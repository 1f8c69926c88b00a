// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <vector>

namespace dyncal {

/// What the numbers rest on: the laboratory's profile with its version and what differs from it,
/// the chain's response that is divided out, and the certificate of each input that the budget
/// names. A certificate that ended before the measurement counts as a field that is missing.
std::vector<CertificateField> traceabilityFields(
    const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal

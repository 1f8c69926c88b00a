// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <vector>

namespace dyncal {

/// The fields that must be filled in before the certificate can be issued and are not, in its
/// order: empty ones, and those that are not what they must be.
std::vector<CertificateField> unfilledFields(
    const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal

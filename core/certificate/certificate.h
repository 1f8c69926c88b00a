// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <string>

namespace dyncal {

/// The whole certificate from the results that exist; sections without results say so.
/// `createdUtc`: ISO 8601 with Z.
CertificateData makeCertificate(
    const CalibrationResults &results, const Recipe &recipe, const std::string &createdUtc);

} // namespace dyncal

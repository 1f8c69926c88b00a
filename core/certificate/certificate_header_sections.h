// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <string>

namespace dyncal {

/// Who, what, remarks, records and statements: sections that need no model.
CertificateSection administrativeSection(const Recipe &recipe);
CertificateSection itemSection(const CalibrationResults &results, const Recipe &recipe);
CertificateSection remarksSection(const CalibrationResults &results, const Recipe &recipe);
CertificateSection recordsSection(const CalibrationResults &results, const std::string &createdUtc);
CertificateSection statementsSection(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal

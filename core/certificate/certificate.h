// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"
#include "core/project/template_choice.h"

#include <string>

namespace dyncal {

/// The whole certificate from the results that exist; sections without results say so.
/// `createdUtc`: ISO 8601 with Z. `chosen`: which of it is shown, in which order; a statement of
/// conformity, where one is asked for, always stands behind the key results.
CertificateData makeCertificate(const CalibrationResults &results, const Recipe &recipe,
    const std::string &createdUtc, const ChosenTemplate &chosen = {});

} // namespace dyncal

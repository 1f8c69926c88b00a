// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <optional>

namespace dyncal {

/// The statement of conformity: claim, decision rule by its name, verdict and the worst row. Empty
/// where the recipe has no certificate.decision. Internal to core/certificate.
std::optional<CertificateSection> conformitySection(
    const CalibrationResults &results, const Recipe &recipe);

/// Whether a statement of conformity is made, as one sentence.
Message conformityStatement(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

#include <string>
#include <vector>

namespace dyncal {

/// The figures of these names (templateFigures()) in this order, each with its caption, as far as
/// the results are there that they show; one whose recordings lack the channel is left out when it
/// is drawn. Without any the section is empty. Internal to core/certificate.
CertificateSection figuresSection(const CalibrationResults &results, const Recipe &recipe,
    const std::vector<std::string> &figures);

} // namespace dyncal

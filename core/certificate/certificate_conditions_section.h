// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/recipe.h"

namespace dyncal {

/// The surroundings as recorded, and the pressure steps of a calibration that knows any. A free
/// decay has no word of pressure steps.
CertificateSection conditionsSection(const CalibrationResults &results, const Recipe &recipe);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/result_quantity.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/certificate_template.h"
#include "core/project/recipe.h"

#include <vector>

namespace dyncal {

/// What the calibration found, each with a complete u or what is known in its place: sensitivity,
/// resonance, band edges and times. Only what `layout` states.
std::vector<ResultQuantity> keyQuantities(
    const CalibrationResults &results, const Recipe &recipe, const CertificateTemplate &layout);

/// The same in one table for the first page, each with U and k. A quantity without a complete u is
/// no result: it stands in a second table, with the bound or the reason that is known.
CertificateSection keyResultsSection(const CalibrationResults &results, const Recipe &recipe,
    const CertificateTemplate &layout = {});

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"
#include "core/project/certificate_template.h"
#include "core/project/recipe.h"

namespace dyncal {

/// What the calibration found, in one table for the first page: sensitivity, resonance, band edges
/// and times, each with U and k. A quantity without a complete u is no result: it stands in a
/// second table, with the bound or the reason that is known in its place. Only what `layout`
/// states.
CertificateSection keyResultsSection(const CalibrationResults &results, const Recipe &recipe,
    const CertificateTemplate &layout = {});

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"

namespace dyncal {

/// Adds the table of the comparisons: per quantity and pair of ways how many were made, the largest
/// difference in u, and the largest of the smallest faults that they could see; then which could
/// not be made. A sentence in its place where there is no comparison at all.
void addCheckTable(const CalibrationResults &results, CertificateSection &section);

} // namespace dyncal

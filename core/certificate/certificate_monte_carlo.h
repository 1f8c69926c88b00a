// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/pipeline/calibration_results.h"

#include <optional>

namespace dyncal {

/// "GUM validated by Monte Carlo": of how many of the values and rows, after how many trials, and
/// whether full refits agree. Empty without a Monte Carlo of the whole chain: never of a part.
std::optional<CertificateField> monteCarloField(const CalibrationResults &results);

} // namespace dyncal

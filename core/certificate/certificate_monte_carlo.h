// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate_data.h"
#include "core/certificate/result_quantity.h"
#include "core/pipeline/calibration_results.h"

#include <optional>
#include <vector>

namespace dyncal {

/// How GUM and Monte Carlo compare: for how many of the values and rows they agree, after how many
/// trials, and whether full refits agree. Empty without a Monte Carlo of the whole chain: never of
/// a part.
std::optional<CertificateField> monteCarloField(const CalibrationResults &results);

/// Those of the results, as they stand in the table of the key results, for which they do not agree
/// and U is not the safer one: the ends of the interval that Monte Carlo found, which reaches
/// beyond value -+ U, to the digits of half its width (JCGM 101, 7.7). Empty where there are none.
std::optional<CertificateTable> monteCarloTable(
    const CalibrationResults &results, const std::vector<ResultQuantity> &quantities);

} // namespace dyncal

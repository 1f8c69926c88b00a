// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/response_result.h"
#include "core/model_analysis/response_source.h"

#include <optional>

namespace dyncal {

/// Fills in what is measured at result.frequency_Hz: values, their u, bounds, or why a value is
/// withheld. None above `highest_Hz`, 0.4 of the slowest record's rate: S(f) of samples repeats
/// itself there. The phase is that branch which is nearest result.modelPhase_rad.
void measureRows(const ResponseSource &source, double highest_Hz, ResponseResult &result);

/// The row of that frequency, to 1e-9; empty where there is none or its magnitude is withheld.
std::optional<Index> measuredRowAt(const ResponseResult &response, double frequency_Hz);

} // namespace dyncal

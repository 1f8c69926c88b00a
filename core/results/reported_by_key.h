// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/calibration_results.h"
#include "core/uncertainty/reported_value.h"

#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// The place of an entry in a list of results.json: "[3]".
std::string placeOf(std::size_t i);

/// Every value of `uncertainty` that is no row over frequency, by its place in results.json:
/// "sensitivity", "sensitivity.per_level[0]", "shots[0].sensitivity", "f0_hz",
/// "model.poles[0].amplitude" (a pair has one). Empty without `uncertainty`; the pointers are valid
/// as long as that is.
std::vector<std::pair<std::string, const ReportedValue *>> reportedByKey(
    const CalibrationResults &results);

} // namespace dyncal

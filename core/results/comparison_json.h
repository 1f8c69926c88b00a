// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/order_comparison.h"

#include <string>

namespace dyncal {

/// The compared orders, schema "dyncal-compare/1" (docs/command-line.md), in the form of
/// results.json: never NaN or Infinity, null with "<key>_reason" beside it.
std::string comparisonJson(
    const CalibrationResults &results, const std::vector<ComparedOrder> &orders);

/// Number of poles of one class.
Index countPoles(const SensorModel &model, PoleClass poleClass);

} // namespace dyncal

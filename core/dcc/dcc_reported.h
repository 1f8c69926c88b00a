// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"
#include "core/uncertainty/reported_value.h"

#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// Every value with a budget of its own, by its place in results.json: reportedByKey(), and of each
/// shot the velocity of the shock and the step ("shock[0].step_pa").
std::vector<std::pair<std::string, ReportedValue>> dccValues(const CalibrationResults &results);

// A list has one unit, so that readers that take a list for one quantity can read it; what has a
// unit that the D-SI does not know, or none that is known for sure, stands in no list.

/// Those with a complete u as a dcc:result, not rounded: a list for each unit, with u, Student's k
/// and degrees of freedom. None where there is no such value.
std::vector<XmlElement> dccReportedValues(const DccSource &source);

/// What Monte Carlo found of the same values, with u and interval of the trials, as a dcc:result.
/// None without trials.
std::vector<XmlElement> dccDrawnValues(const DccSource &source);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"
#include "core/uncertainty/uncertainty_report.h"

#include <string>
#include <utility>
#include <vector>

namespace dyncal {

/// Every reported value, that of single shots too, by its key in results.json ("f0_hz",
/// "shots[0].sensitivity"). Valid as long as the report.
std::vector<std::pair<std::string, const ReportedValue *>> reportedByKey(
    const UncertaintyReport &report);

// A list has one unit, so that readers that take a list for one quantity can read it; what has a
// unit that the D-SI does not know, or none that is known for sure, stands in no list.

/// Those with a complete u as a dcc:result, not rounded: a list for each unit, with u, Student's k
/// and degrees of freedom. None where there is no such value.
std::vector<XmlElement> dccReportedValues(const DccSource &source);

/// What Monte Carlo found of the same values, with u and interval of the trials, as a dcc:result.
/// None without trials.
std::vector<XmlElement> dccDrawnValues(const DccSource &source);

} // namespace dyncal

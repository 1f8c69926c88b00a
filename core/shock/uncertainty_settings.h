// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// One line of the uncertainty budget as typed.
struct BudgetEntry
{
    std::string quantity;
    double u = 0.0;
    std::string distribution = "normal";
    std::optional<double> dof = {};
    std::string certificate = {}; ///< of the reference that u is taken from; "" = none
    std::string due = {}; ///< date until which it holds, YYYY-MM-DD; "" = not stated
    bool operator==(const BudgetEntry &) const = default;
};

/// The least expanded uncertainty that the laboratory is accredited for (its calibration and
/// measurement capability, CMC), of one reported quantity: none smaller is stated.
struct CapabilityEntry
{
    std::string of; ///< "sensitivity", "magnitude", "phase_rad", "f0_hz", ...
    double expanded = 0.0; ///< U, in the unit of the value, or relative to it
    bool isRelative = true; ///< a phase's never is
    double from_Hz = 0.0; ///< of "magnitude" and "phase_rad"
    std::optional<double> to_Hz = {}; ///< absent = without end
    bool operator==(const CapabilityEntry &) const = default;
};

/// That two quantities of the budget err together.
struct CorrelationEntry
{
    std::string quantity;
    std::string with;
    double coefficient = 0.0; ///< r, -1 to 1
    bool operator==(const CorrelationEntry &) const = default;
};

/// Recipe section "uncertainty".
struct UncertaintySettings
{
    std::vector<BudgetEntry> budget;
    std::vector<CorrelationEntry> correlations = {};
    std::vector<CapabilityEntry> cmc = {};
    Index monteCarloTrials = 10000; ///< 0 = "adaptive"
    Index seed = 1;
    double coverage = 0.95;
    bool operator==(const UncertaintySettings &) const = default;
};

} // namespace dyncal

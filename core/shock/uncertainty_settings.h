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
    std::optional<double> dof;
    bool operator==(const BudgetEntry &) const = default;
};

/// Recipe section "uncertainty".
struct UncertaintySettings
{
    std::vector<BudgetEntry> budget;
    Index monteCarloTrials = 10000; ///< 0 = "adaptive"
    Index seed = 1;
    double coverage = 0.95;
    bool operator==(const UncertaintySettings &) const = default;
};

} // namespace dyncal

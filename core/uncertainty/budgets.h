// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/uncertainty_report.h"

#include <cmath>
#include <vector>

namespace dyncal {

enum class BudgetOf { Sensitivity, Level, Model, Magnitude, Phase };

/// A value that a certificate may state, with its budget, and what tells it from the others.
struct Budget
{
    BudgetOf kind = BudgetOf::Sensitivity;
    ShotLevel level = ShotLevel::None; ///< of a Level
    double frequency_Hz = kUnknown; ///< of Magnitude and Phase
    Index shots = 0; ///< that it is of
    ReportedValue reported; ///< of a phase in degrees

    bool isOverFrequency() const { return std::isfinite(frequency_Hz); }
};

/// All of a report in the order in which they are read: the sensitivity, the levels, the model's
/// values, magnitude and phase over frequency (rows inside the band that are stated).
std::vector<Budget> allBudgets(const UncertaintyReport &report, const ResponseResult &response);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_uncertainty.h"
#include "core/uncertainty/reported_value.h"

namespace dyncal {

/// What the relations of a shock give for one shot, with its lines, as everything else that is
/// reported: `of` is "velocity_m_s", "mach", "p2_pa", "p5_pa" or "step_pa". u is that of the budget
/// (evaluateStep()), or absent where an input has none. `shot` (from 1) is whose it is: the lines
/// that other shots do not share have its number.
ReportedValue stepValue(const StepUncertainty &step, StepResult result, Index shot);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/shock_stage.h"
#include "core/shock/step_monte_carlo.h"
#include "ui/stages/frame/shown_table.h"

namespace dyncal {

/// One row per quantity, one column per shot, as tables 4.1 and 4.2 of the thesis.
ShownTable stateTable(const ShockConditionsSet &shock);

/// Pressures read from the records beside those of the relations.
ShownTable measuredTable(const ShockConditionsSet &shock);

/// Where and when the shock was seen, and how far that lies from the fitted path.
ShownTable arrivalTable(const ShockConditionsSet &shock);

/// W, M, p2, p5 and the step of every shot: u by the law of propagation and by Monte Carlo.
/// `drawn` may be null.
ShownTable uncertaintyTable(const ShockConditionsSet &shock, const StepMonteCarloSet *drawn);

/// Peaks followed from shot to shot against the sound speed of the gas (SPC-005).
ShownTable followedPeakTable(const ShockConditionsSet &shock);

} // namespace dyncal

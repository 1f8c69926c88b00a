// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/synthesis/simulation_settings.h"

namespace dyncal {

/// Fails (Usage) on settings that make no sense, naming the value and the range (the ranges are
/// listed in docs/simulator.md).
Result<void> checkSimulation(const SimulationSettings &settings);

} // namespace dyncal

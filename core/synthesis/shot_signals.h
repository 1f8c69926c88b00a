// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/synthesis/channel_recorder.h"
#include "core/synthesis/shot_plan.h"

#include <array>

namespace dyncal {

/// What the DUT, the side sensor and the driver sensor see, in this order (docs/simulator.md).
std::array<SignalPlan, 3> signalsOf(const ShotPlan &plan);

} // namespace dyncal

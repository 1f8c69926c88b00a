// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/consistency/fault_isolation.h"
#include "core/consistency/way_comparison.h"
#include "core/shock/shock_settings.h"

#include <vector>

namespace dyncal {

/// One finding per quantity and shot that contradicts itself (the worst place of it), with the
/// causes that explain the contradictions and concern that quantity. What other stages say already
/// (SHK-010 of the arrivals, RSP-002 of the shots, SHK-006 of the driver) is not said again.
/// `doShotsScatter`: RSP-002 was raised, so that the shots are the first cause of CHK-005.
Findings judgeConsistency(const ComparedShots &shots, const std::vector<WayComparison> &checks,
    const ShockSettings &settings, bool doShotsScatter = false);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/consistency/way_comparison.h"
#include "core/model_analysis/sensor_response.h"
#include "core/shock/shock_conditions.h"
#include "core/shock/shock_settings.h"
#include "core/shock/step_inputs.h"

#include <vector>

namespace dyncal {

/// Compares every independent way to one quantity (velocity, Mach number, pressures, step,
/// sensitivity) within the combined uncertainty, and says which single fault would explain what
/// contradicts (docs/method/checks.md). Uncertainties: `stated`, then those of capture and cards,
/// then assumed ones, because a comparison must not fail for want of a number that nobody typed.
/// Findings: SHK-002 of the pressures, CHK-001 to CHK-004.
ConsistencyResult compareWays(const CaptureSet &set, const ShockSettings &settings,
    const ShockConditionsSet &shock, const ResponseResult &response,
    const std::vector<StatedUncertainty> &stated);

} // namespace dyncal

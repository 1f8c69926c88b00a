// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/capture/check_settings.h"
#include "core/shock/shock_conditions.h"
#include "core/signal/response_window.h"

#include <vector>

namespace dyncal {

/// CAP-013 for every shot whose DUT reads pressures and whose step differs from the computed one by
/// more than `checks.readingFactor`: the unit or the scale is wrong. The sentence proposes the unit
/// in which the recorded numbers would fit within 10 %, if there is one.
Findings checkReadings(const std::vector<WindowedResponse> &responses,
    const ShockConditionsSet &shock, const CheckSettings &checks);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/shock/shock_relations.h"
#include "core/shock/shock_settings.h"

#include <optional>
#include <vector>

namespace dyncal {

/// Reference pressure step of one shot and how it came about.
struct ShockConditions
{
    Index shot = 0;
    std::optional<ShockStates> states; ///< where a velocity was typed or measured
    std::optional<GasState> driver; ///< region 4, where T4 (and p4 or eq 3.10) is known
    std::optional<double> step_Pa; ///< empty = not determined
    bool stepTyped = false;
    std::optional<double> plateau_s;
    std::optional<double> arrival_s; ///< of the shock at the side sensor, record axis
    double distance_m = 0.0; ///< side sensor to end wall, where used
};

struct ShockConditionsSet
{
    std::vector<ShockConditions> shots; ///< one per included shot, same order as the responses
    Findings findings;

    const ShockConditions *ofShot(Index shot) const;
};

/// When the DUT felt the shock: shot number and time on the record's axis.
struct DutArrival
{
    Index shot = 0;
    double time_s = 0.0;
};

/// Pressure step per shot: typed, or computed from the velocity (typed, or distance over time
/// between one arrival sensor and the DUT) with the relations 3.1-3.9. Missing inputs leave the
/// step "not determined" with a finding that says what is missing (SHK-007); never a guess.
/// Inputs that contradict each other (SHK-001, SHK-004) leave it undetermined for that shot too,
/// as a finding that blocks (a caution where the step is typed, which then stands).
/// Recipe values win over the capture's environment and tube attributes. End wall: step = p5 - p1;
/// side wall: p2 - p1. Fails (Usage) on settings that make no sense.
Result<ShockConditionsSet> estimateShockConditions(
    const CaptureSet &set, const std::vector<DutArrival> &arrivals, const ShockSettings &settings);

} // namespace dyncal

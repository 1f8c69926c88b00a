// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/shock/shock_conditions.h"
#include "core/shock/shock_settings.h"
#include "core/shock/shock_uncertainty.h"
#include "core/shock/shock_velocity.h"
#include "core/signal/record_starts.h"

#include <vector>

namespace dyncal {

/// What earlier stages read from the records, so that it is not read again. Null = not known.
struct KnownReadings
{
    const RecordStarts *starts = nullptr;
    /// An earlier estimate with the same set and settings. The arrivals and pressures that it read
    /// from the records are kept, even if the DUT's arrival has changed since.
    const ShockConditionsSet *before = nullptr;
};

/// Pressure step per shot: typed, or computed from the velocity (typed, or measured by
/// estimateVelocity()) with the relations 3.1-3.9. Missing inputs leave the step "not determined"
/// with a finding that says what is missing (SHK-007); never a guess. Inputs that contradict each
/// other (SHK-001, SHK-004) leave it undetermined for that shot too, with a finding that blocks; a
/// typed step still stands, and the finding is then a caution. Whatever is not `known` is read from
/// the records here. Recipe values win over the capture's environment and tube attributes. End
/// wall: step = p5 - p1; side wall: p2 - p1. Uncertainties only where `request` asks for them;
/// where one of their inputs has no stated uncertainty they are left out, with the reason. Fails
/// (Usage) on settings that make no sense.
Result<ShockConditionsSet> estimateShockConditions(const CaptureSet &set,
    const std::vector<DutArrival> &arrivals, const ShockSettings &settings,
    const UncertaintyRequest &request = {}, const JobControl &control = {},
    const KnownReadings &known = {});

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "core/shock/gas_choice.h"
#include "core/shock/shock_conditions.h"
#include "core/shock/shock_relations.h"
#include "core/shock/shock_settings.h"
#include "core/shock/shock_uncertainty.h"
#include "core/signal/record_starts.h"

#include <optional>
#include <vector>

namespace dyncal {

/// What the functions of core/shock share while they work on one shot.
struct ShockWork
{
    const CaptureSet &set;
    const Shot &shot;
    const ShockSettings &settings;
    const UncertaintyRequest &request;
    const RecordStarts &starts;
    const ShockConditions *before; ///< null: the records have not been read yet
    ShockConditions conditions;
    Findings findings;
    std::optional<VelocityEstimate> recorded{}; ///< of the arrivals, where another one is used
    std::vector<GasWay> gasWays{}; ///< to the driven gas; the first one is used
    Result<void> done{}; ///< an error that stops everything

    bool atEndWall() const { return settings.dutPosition == kEndWall; }
    /// The finding blocks, unless a step is typed: that stands without a velocity.
    void reportProblem(const Error &error, std::optional<Correction> correction = std::nullopt);
    void reportMissing(Message message);
};

/// Step of the DUT's place: p5 - p1 or p2 - p1.
double stepOf(const ShockStates &states, bool atEndWall);

/// d ln(step) / d ln(W), by a central difference that stays above Mach 1.
double velocitySensitivity(const ShockWork &work);

/// The temperature in kelvin where degrees Celsius were typed, if that is what happened.
std::optional<Correction> kelvinFor(const char *key, double typed_K);

} // namespace dyncal

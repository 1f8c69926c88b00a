// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_conditions.h"

#include <utility>

namespace dyncal {

/// Everything about one shot that has to be worked on together. Internal to core/shock.
struct ShockWork
{
    const CaptureSet &set;
    const Shot &shot;
    const ShockSettings &settings;
    const UncertaintyRequest &request;
    const RecordStarts &starts;
    const ShockConditions *before; ///< null where nothing was read from the records before
    ShockConditions conditions;
    Findings findings;
    Result<void> done{}; ///< an error that stops everything

    bool atEndWall() const { return settings.dutPosition == kEndWall; }
    Finding &report(const char *id, Severity severity, Message message);
    /// A typed step stands whatever the velocity says, so nothing is blocked then.
    void reportProblem(const Error &error, std::optional<Mend> mend = std::nullopt);
    void reportMissing(Message message);
};

/// Step of the DUT's place: p5 - p1 or p2 - p1.
double stepOf(const ShockStates &states, bool atEndWall);

/// d ln(step) / d ln(W), by a central difference that stays above Mach 1.
double velocitySensitivity(const ShockWork &work);

/// The temperature in kelvin where degrees Celsius were typed, if that is what happened.
std::optional<Mend> kelvinFor(const char *key, double typed_K);

// What the operator must see of one shot; each may add a finding.
void judgeVelocity(ShockWork &work, double relativeFromDistance); ///< SHK-003
void judgeFit(ShockWork &work, const VelocityEstimate &estimate); ///< SHK-008, SHK-010
void judgeMeasured(ShockWork &work); ///< SHK-002
void judgeDriverPressure(ShockWork &work, double computed_Pa); ///< SHK-006
void judgeTypedPressure(ShockWork &work, double p1_Pa); ///< SHK-011
void reportPlateau(ShockWork &work); ///< SHK-005

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock/shock_on_show.h"

#include <algorithm>

namespace dyncal {

namespace {

const ShockConditionsSet *shockOfRun(const CalibrationResults &run)
{
    if (run.shock || !run.expected)
        return run.shock.get();
    const ShockConditionsSet &expected = run.expected->conditions;
    const bool isKnown = std::ranges::any_of(
        expected.shots, [](const ShockConditions &shot) { return shot.states.has_value(); });
    return isKnown ? &expected : nullptr;
}

} // namespace

const ShockConditionsSet *shockOnShow(const Session &session)
{
    const ShockConditionsSet *known = shockOfRun(session.results());
    return known ? known : session.resultsOnShow().shock.get();
}

bool isOldShockOnShow(const Session &session)
{
    return !shockOfRun(session.results()) && session.resultsOnShow().shock;
}

} // namespace dyncal

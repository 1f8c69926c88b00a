// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/step_monte_carlo.h"

#include "core/base/propagation.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace dyncal {
namespace {

Finding monteCarloFailed(Index shot, const Error &error)
{
    return {.id = "SHK-012",
        .severity = Severity::Caution,
        .shot = shot,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1: the uncertainty of the step could not be checked by Monte Carlo (%M1); what the law of propagation gives may be wrong."),
            {std::to_string(shot)}, {error.message}}};
}

} // namespace

const ShotMonteCarlo *StepMonteCarloSet::ofShot(Index shot) const
{
    const auto found = std::find_if(
        shots.begin(), shots.end(), [&](const ShotMonteCarlo &s) { return s.shot == shot; });
    return found != shots.end() ? &*found : nullptr;
}

Result<StepMonteCarloSet> stepMonteCarlo(
    const ShockConditionsSet &shock, const UncertaintySettings &settings, const JobControl &control)
{
    const UncertaintyRequest request = uncertaintyRequest(settings);
    StepMonteCarloSet set;
    for (const ShockConditions &shot : shock.shots) {
        if (!shot.measurement || !shot.uncertainty || !shot.uncertainty->u(StepResult::Step))
            continue;
        auto outcome = simulateStep(*shot.measurement, request, shot.uncertainty->budget,
            {settings.monteCarloTrials, static_cast<std::uint64_t>(settings.seed), shot.shot,
                settings.coverage},
            control);
        if (!outcome && outcome.error().kind != ErrorKind::DataBlocked)
            return tl::unexpected(outcome.error());
        set.shots.push_back({shot.shot, {}, {}});
        if (outcome) {
            set.shots.back().outcome = std::move(*outcome);
        } else {
            set.shots.back().missing = english(outcome.error().message);
            set.findings.push_back(monteCarloFailed(shot.shot, outcome.error()));
        }
    }
    return set;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_work.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/shock/variable_shock.h"

#include <algorithm>
#include <utility>

namespace dyncal {

namespace {

/// What makes a shock look too slow, or run backwards.
std::vector<FindingCause> causesOf(const std::string &id)
{
    using C = FindingCause;
    if (id.empty() || id == "SHK-001")
        return {C::Rate, C::Distance, C::Gas, C::Temperature};
    return {};
}

} // namespace

void ShockWork::reportProblem(const Error &error, std::optional<Correction> correction)
{
    findings.push_back({.id = error.findingId.empty() ? "SHK-001" : error.findingId,
        .severity = conditions.stepTyped ? Severity::Caution : Severity::Block,
        .shot = conditions.shot,
        .message = error.message,
        .correction = std::move(correction),
        .causes = causesOf(error.findingId)});
}

void ShockWork::reportMissing(Message message)
{
    if (!conditions.stepTyped)
        findings.push_back({.id = "SHK-007",
            .severity = Severity::Info,
            .shot = conditions.shot,
            .message = std::move(message)});
}

double stepOf(const ShockStates &states, bool atEndWall)
{
    const GasState &behind = atEndWall ? states.reflected : states.shocked;
    return behind.pressure_Pa - states.driven.pressure_Pa;
}

double velocitySensitivity(const ShockWork &work)
{
    const ShockStates &states = *work.conditions.states;
    const double relative = std::min(1e-4, 0.5 * (1.0 - 1.0 / states.mach));
    const auto stepAt = [&](double factor) {
        const auto shifted = shockStatesOf(*work.conditions.drivenGas, states.driven.pressure_Pa,
            states.driven.temperature_K, factor * states.velocity_m_s);
        return stepOf(shifted ? *shifted : states, work.atEndWall());
    };
    return (stepAt(1.0 + relative) - stepAt(1.0 - relative))
        / (2.0 * relative * stepOf(states, work.atEndWall()));
}

std::optional<Correction> kelvinFor(const char *key, double typed_K)
{
    const double kelvin = typed_K + kCelsiusZero_K;
    if (!(kelvin >= kLowestTemperature_K && kelvin <= kHighestTemperature_K))
        return std::nullopt;
    return Correction{.label = {DYNCAL_TEXT("core", "Use %1 K"), {numberText(kelvin, 6)}},
        .key = key,
        .value = numberText(kelvin)};
}

} // namespace dyncal

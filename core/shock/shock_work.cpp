// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_work.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/shock/variable_shock.h"

#include <algorithm>
#include <utility>

namespace dyncal {

Finding &ShockWork::report(const char *id, Severity severity, Message message)
{
    Finding finding;
    finding.id = id;
    finding.severity = severity;
    finding.shot = conditions.shot;
    finding.message = std::move(message);
    findings.push_back(std::move(finding));
    return findings.back();
}

void ShockWork::reportProblem(const Error &error, std::optional<Mend> mend)
{
    report(error.findingId.empty() ? "SHK-001" : error.findingId.c_str(),
        conditions.stepTyped ? Severity::Caution : Severity::Block, error.message)
        .mend
        = std::move(mend);
}

void ShockWork::reportMissing(Message message)
{
    if (!conditions.stepTyped)
        report("SHK-007", Severity::Info, std::move(message));
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

std::optional<Mend> kelvinFor(const char *key, double typed_K)
{
    const double kelvin = typed_K + kCelsiusZero_K;
    if (!(kelvin >= kLowestTemperature_K && kelvin <= kHighestTemperature_K))
        return std::nullopt;
    return Mend{
        Message{DYNCAL_TEXT("core", "Use %1 K"), {numberText(kelvin, 6)}}, key, numberText(kelvin)};
}

} // namespace dyncal

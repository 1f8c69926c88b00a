// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/reading_check.h"

#include "core/base/number_text.h"
#include "core/shock/pressure_units.h"

#include <cmath>

namespace dyncal {
namespace {

Finding misread(const WindowedResponse &response, double recorded, const std::string &unit,
    double read_Pa, double step_Pa)
{
    const auto fitting = unitThatFits(recorded, step_Pa);
    return {.id = "CAP-013",
        .severity = Severity::Caution,
        .shot = response.shot,
        .channel = response.channel,
        .message
        = {fitting ? DYNCAL_TEXT("core",
               "Shot %1: the step reads %2; %3 is expected. Is the unit %4? Set import.unit.")
                   : DYNCAL_TEXT("core",
                       "Shot %1: the step reads %2; %3 is expected. Check the unit and the scale."),
            {std::to_string(response.shot), numberWithUnit(recorded, unit, 4),
                numberWithUnit(step_Pa, "Pa", 4), fitting.value_or("")}},
        .value = read_Pa,
        .limit = step_Pa};
}

} // namespace

Findings checkReadings(const std::vector<WindowedResponse> &responses,
    const ShockConditionsSet &shock, const CheckSettings &checks)
{
    Findings findings;
    for (const WindowedResponse &response : responses) {
        const ShockConditions *conditions = shock.ofShot(response.shot);
        const auto pascals = pascalsPer(response.unit);
        if (!conditions || !conditions->step_Pa || !pascals)
            continue;
        const double read_Pa = response.step * *pascals;
        const double ratio = std::abs(read_Pa / *conditions->step_Pa);
        if (ratio < checks.readingFactor && ratio > 1.0 / checks.readingFactor)
            continue;
        const std::string &unit
            = response.recordedUnit.empty() ? response.unit : response.recordedUnit;
        findings.push_back(misread(response, read_Pa / pascalsPer(unit).value_or(1.0), unit,
            read_Pa, *conditions->step_Pa));
    }
    return findings;
}

} // namespace dyncal

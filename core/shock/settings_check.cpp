// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/settings_check.h"

#include "core/base/number_text.h"
#include "core/shock/shock_velocity.h"

#include <cmath>
#include <utility>

namespace dyncal {
namespace {

Result<void> checkTyped(const ShockSettings &settings, std::size_t shots)
{
    const std::pair<const PerShot &, const char *> lists[]{
        {settings.velocity_m_s, "shock.velocity_m_s"}, {settings.step_Pa, "shock.step_pa"}};
    for (const auto &[typed, key] : lists) {
        if (!typed.each.empty() && typed.each.size() != shots)
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "The recipe lists %1 values for %2 shots; give one number or null per shot (%3)."),
                    {std::to_string(typed.each.size()), std::to_string(shots), key}});
    }
    for (std::size_t i = 0; i < shots; ++i) {
        const auto step_Pa = settings.step_Pa.of(static_cast<Index>(i) + 1);
        if (step_Pa && !(std::isfinite(*step_Pa) && *step_Pa != 0.0))
            return fail(ErrorKind::Usage,
                Message{DYNCAL_TEXT("core",
                            "The typed pressure step is %1 Pa; it must be a number other than 0."),
                    {numberText(*step_Pa)}});
    }
    return {};
}

Result<void> checkSensors(const ShockSettings &settings, std::size_t shots)
{
    for (const ArrivalSensor &sensor : settings.arrivalSensors) {
        if (!(sensor.distanceToEndWall_m > 0.0 && std::isfinite(sensor.distanceToEndWall_m)))
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "The arrival sensor '%1' has a distance to the end wall of %2 m; it must be above 0."),
                    {sensor.channel, numberText(sensor.distanceToEndWall_m)}});
        if (!sensor.shotArrival_s.empty() && sensor.shotArrival_s.size() != shots)
            return fail(ErrorKind::Usage,
                Message{
                    DYNCAL_TEXT("core",
                        "The arrival sensor '%1' lists %2 arrivals for %3 shots; give one time or null per shot (shock.arrival_sensors[].arrival_s)."),
                    {sensor.channel, std::to_string(sensor.shotArrival_s.size()),
                        std::to_string(shots)}});
    }
    return {};
}

} // namespace

Result<void> checkShockSettings(const ShockSettings &settings, std::size_t shots)
{
    if (settings.dutPosition != kEndWall && settings.dutPosition != kSideWall)
        return fail(ErrorKind::Usage,
            Message{DYNCAL_TEXT("core",
                        "The DUT's position is '%1'; it must be 'end-wall' or 'side-wall'."),
                {settings.dutPosition}});
    if (auto checked = checkTyped(settings, shots); !checked)
        return checked;
    return checkSensors(settings, shots);
}

} // namespace dyncal

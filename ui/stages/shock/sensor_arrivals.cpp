// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/shock/sensor_arrivals.h"

#include <algorithm>

namespace dyncal {

std::optional<double> typedArrival_s(const ArrivalSensor &sensor, Index shot)
{
    const auto at = static_cast<std::size_t>(shot - 1);
    return at < sensor.shotArrival_s.size() ? sensor.shotArrival_s[at] : sensor.arrival_s;
}

std::optional<double> usedArrival_s(const ShockConditions &shot, const ArrivalSensor &sensor)
{
    if (const auto typed_s = typedArrival_s(sensor, shot.shot))
        return typed_s;
    for (const SeenArrival &seen : shot.seen) {
        if (seen.channel == sensor.channel && seen.found)
            return seen.found->time_s;
    }
    return std::nullopt;
}

void typeArrival(
    ArrivalSensor &sensor, Index shot, std::size_t shots, const std::optional<double> &arrival_s)
{
    if (sensor.shotArrival_s.empty())
        sensor.shotArrival_s.assign(shots, sensor.arrival_s);
    sensor.shotArrival_s.resize(shots);
    sensor.shotArrival_s[static_cast<std::size_t>(shot - 1)] = arrival_s;
    sensor.arrival_s.reset();
    const bool none = std::ranges::none_of(
        sensor.shotArrival_s, [](const auto &typed_s) { return typed_s.has_value(); });
    if (none)
        sensor.shotArrival_s.clear();
}

} // namespace dyncal

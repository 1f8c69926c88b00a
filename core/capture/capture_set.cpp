// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_set.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {

namespace {
constexpr double kNotRecorded = std::numeric_limits<double>::quiet_NaN();
}

const char *shotLevelName(ShotLevel level)
{
    switch (level) {
    case ShotLevel::Low:
        return "low";
    case ShotLevel::Medium:
        return "medium";
    case ShotLevel::High:
        return "high";
    case ShotLevel::None:
        break;
    }
    return "";
}

ShotLevel shotLevelFromName(std::string_view name)
{
    for (const ShotLevel level : {ShotLevel::Low, ShotLevel::Medium, ShotLevel::High}) {
        if (name == shotLevelName(level))
            return level;
    }
    return ShotLevel::None;
}

Environment::Environment()
    : p1_Pa(kNotRecorded)
    , u_p1_Pa(kNotRecorded)
    , T1_K(kNotRecorded)
    , u_T1_K(kNotRecorded)
    , p4_Pa(kNotRecorded)
    , T4_K(kNotRecorded)
    , ambientPressure_Pa(kNotRecorded)
    , ambientT_K(kNotRecorded)
    , relativeHumidity(kNotRecorded)
{
}

const Channel *Shot::channelWithRole(ChannelRole role) const
{
    const auto found = std::find_if(
        channels.begin(), channels.end(), [&](const Channel &c) { return c.role == role; });
    return found != channels.end() ? &*found : nullptr;
}

const Channel *Shot::channelCalled(const std::string &nameOrRole) const
{
    const auto named = std::find_if(channels.begin(), channels.end(),
        [&](const Channel &channel) { return channel.name == nameOrRole; });
    if (named != channels.end())
        return &*named;
    const ChannelRole role = channelRoleFromName(nameOrRole);
    return role == ChannelRole::Other ? nullptr : channelWithRole(role);
}

bool comesFrom(const Shot &shot, Index input)
{
    return shot.input == input
        || std::any_of(shot.channels.begin(), shot.channels.end(),
            [&](const Channel &channel) { return channel.input == input; });
}

void moveInputs(Shot &shot, const std::function<Index(Index)> &newPosition)
{
    shot.input = newPosition(shot.input);
    for (Channel &channel : shot.channels) {
        if (channel.input)
            channel.input = newPosition(*channel.input);
    }
}

std::optional<double> CaptureSet::tubeNumber(const std::string &key) const
{
    const auto found = tube.find(key);
    const auto number = found != tube.end() ? parseNumber(found->second) : std::nullopt;
    return number && std::isfinite(*number) ? number : std::nullopt;
}

} // namespace dyncal

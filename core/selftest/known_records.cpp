// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/known_records.h"

#include <utility>

namespace dyncal {

Channel knownChannel(
    const std::string &name, ChannelRole role, const Eigen::VectorXd &values, double rate_Hz)
{
    Channel channel;
    channel.name = name;
    channel.role = role;
    channel.samples = RawSamples(std::vector<double>(values.begin(), values.end()));
    channel.sampleRate_Hz = rate_Hz;
    return channel;
}

CaptureSet knownSet(std::vector<Channel> channels)
{
    CaptureSet set;
    Shot shot;
    shot.label = "known";
    shot.channels = std::move(channels);
    set.shots.push_back(std::move(shot));
    return set;
}

Eigen::VectorXd sharpStep(Index count, Index at, double baseline, double height)
{
    Eigen::VectorXd values = Eigen::VectorXd::Constant(count, baseline);
    values.tail(count - at).array() += height;
    return values;
}

CaptureSet shockRecords()
{
    const auto channel = [](const char *name, ChannelRole role, Index at) {
        return knownChannel(name, role, sharpStep(8000, at, 0.0, 1.0), kShockRecordRate_Hz);
    };
    return knownSet(
        {channel("DUT", ChannelRole::Dut, 4000), channel("far", ChannelRole::DrivenSide, 2000),
            channel("near", ChannelRole::DrivenSide, 3000)});
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/record_starts.h"

#include <set>

namespace dyncal {
namespace {

std::set<const Channel *> channelsOf(const Shot &shot, const std::vector<std::string> &others)
{
    std::set<const Channel *> channels;
    if (!shot.included)
        return channels;
    channels.insert(shot.channelWithRole(ChannelRole::Dut));
    channels.insert(shot.channelWithRole(ChannelRole::DrivenSide));
    for (const std::string &other : others)
        channels.insert(shot.channelCalled(other));
    return channels;
}

} // namespace

const DetectedStart *RecordStarts::of(
    const CaptureSet &set, Index shot, const Channel *channel) const
{
    const auto at = static_cast<std::size_t>(shot - 1);
    if (channel == nullptr || at >= shots.size())
        return nullptr;
    const auto &channels = set.shots[at].channels;
    for (std::size_t i = 0; i < std::min(channels.size(), shots[at].size()); ++i) {
        if (&channels[i] == channel)
            return shots[at][i] ? &*shots[at][i] : nullptr;
    }
    return nullptr;
}

Result<RecordStarts> detectStarts(const CaptureSet &set, const std::vector<std::string> &others,
    const JobControl &control, double stepSigmas)
{
    RecordStarts starts;
    for (const Shot &shot : set.shots) {
        const Index number = std::ssize(starts.shots) + 1;
        const auto wanted = channelsOf(shot, others);
        starts.shots.emplace_back();
        for (const Channel &channel : shot.channels) {
            if (control.stopRequested())
                return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
            auto &start = starts.shots.back().emplace_back();
            if (!wanted.contains(&channel) || !(channel.sampleRate_Hz > 0.0))
                continue;
            if (const auto found = detectStart(channel, {control.stop, {}}, number, stepSigmas))
                start = *found;
        }
    }
    return starts;
}

} // namespace dyncal

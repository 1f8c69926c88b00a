// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/channel_order.h"

#include "core/base/number_text.h"
#include "core/shock/shock_velocity.h"
#include "core/shock/side_arrival.h"
#include "core/signal/record_starts.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr double kLeastLead_samples = 5.0; ///< a detected start may be off by so much

Finding swapped(Index shot, const Channel &dut, const Channel &side, double lead_s)
{
    return {.id = "CAP-010",
        .severity = Severity::Caution,
        .shot = shot,
        .channel = dut.name,
        .message
        = {DYNCAL_TEXT("core",
               "Shot %1: the step reaches '%2' %3 before '%4', which the shock passes first. The two channels look swapped; exchange their roles in import.channels, for one file in import.files."),
            {std::to_string(shot), dut.name, numberWithUnit(lead_s, "s", 3), side.name}},
        .value = lead_s,
        .limit = 0.0};
}

} // namespace

Findings checkChannelOrder(
    const CaptureSet &set, const std::vector<DutArrival> &arrivals, const RecordStarts &starts)
{
    Findings findings;
    for (const DutArrival &arrival : arrivals) {
        const Shot &shot = set.shots.at(static_cast<std::size_t>(arrival.shot - 1));
        const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
        const Channel *side = shot.channelWithRole(ChannelRole::DrivenSide);
        if (!shot.included || !dut || !side)
            continue;
        const DetectedStart *start = starts.of(set, arrival.shot, side);
        const auto seen = start ? sideArrival(*side, *start, arrival.time_s) : std::nullopt;
        const double slower_Hz = std::min(dut->sampleRate_Hz, side->sampleRate_Hz);
        if (seen && seen->time_s - arrival.time_s > kLeastLead_samples / slower_Hz)
            findings.push_back(swapped(arrival.shot, *dut, *side, seen->time_s - arrival.time_s));
    }
    return findings;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel.h"
#include "core/capture/envelope_pyramid.h"

#include <span>
#include <vector>

namespace dyncal {

/// What a first look at a record shows, before anything is known about it: its course in few
/// stretches, its noise and its largest change. In the units of the numbers it was made from.
struct ChannelGlance
{
    std::vector<SampleExtremes> trace; ///< stretches of equal length; empty without samples
    double noise = 0.0; ///< standard deviation from sample to sample, over sqrt(2)
    double step = 0.0; ///< largest change of the mean from one stretch to the next but one
    Index stepAt = 0; ///< stretch in which it happens
    double swing = 0.0; ///< largest less smallest sample, over the step: how much it rings

    /// Whether the step stands out of the noise (CAP-009's limit).
    bool steps() const;

    bool operator==(const ChannelGlance &) const = default;
};

/// Of samples that are in memory. Invalid samples are left out.
ChannelGlance glanceAt(std::span<const double> values);

/// Of a record of any length: of each stretch no more than a fixed number of samples is read.
ChannelGlance glanceAt(const RawSamples &samples);

/// The same in the channel's unit (physicalValue()); noise and step by the slope about the middle
/// of the step.
ChannelGlance glanceAt(const Channel &channel);

/// What the channels of one recording may be, for the operator to take or not; Other where the
/// records do not say. The shock passes the sensors in the wall before it reaches the DUT: of the
/// records that step, the last is the DUT's (of several at once the one that rings most) and the
/// last before it the driven side's. A slow fall, or a
/// fall where others rise, is the driver's.
std::vector<ChannelRole> proposedRoles(const std::vector<ChannelGlance> &channels);

} // namespace dyncal

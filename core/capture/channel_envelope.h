// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel.h"
#include "core/capture/envelope_pyramid.h"

#include <memory>

namespace dyncal {

/// Least and greatest physical values of one channel over any stretches of its record.
///
/// Where the conversion to physical values is monotone over the counts that occur, the pyramid
/// holds counts, and only the two extremes of a stretch are converted. Otherwise the extremes may
/// belong to any count between, so the pyramid holds physical values, converted block by block
/// while it is built; it then takes 17 % of the size of 16-bit samples.
class ChannelEnvelope
{
public:
    /// Errors: those of EnvelopePyramid::build.
    static Result<ChannelEnvelope> build(const Channel &channel, const JobControl &control = {});

    /// The envelope of `channel` without reading its record again; empty if its record is another
    /// one or this pyramid does not fit its conversion.
    std::optional<ChannelEnvelope> of(const Channel &channel) const;

    const Channel &channel() const { return m_channel; }
    Index memory_bytes() const { return m_pyramid->memory_bytes(); }

    /// As those of EnvelopePyramid, in the unit of the channel.
    SampleExtremes extremes() const;
    std::optional<std::vector<SampleExtremes>> stretches(std::span<const Index> edges) const;

private:
    ChannelEnvelope(Channel channel, std::shared_ptr<const EnvelopePyramid> pyramid, bool ofValues);
    SampleExtremes converted(const SampleExtremes &found) const;

    Channel m_channel;
    std::shared_ptr<const EnvelopePyramid> m_pyramid;
    bool m_ofValues = false; ///< of physical values instead of counts
};

/// Whether sum polynomial[k] x^k is certainly monotone on [low, high]: all coefficients of its
/// derivative in the Bernstein basis of the interval have one sign. False proves the contrary only
/// below the third power.
bool isMonotone(const std::vector<double> &polynomial, double low, double high);

} // namespace dyncal

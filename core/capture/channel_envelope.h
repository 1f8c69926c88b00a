// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel.h"
#include "core/capture/envelope_pyramid.h"

#include <memory>

namespace dyncal {

/// Least and greatest physical values of one channel over any stretches of its record.
///
/// Counts are looked at, and only the two extremes of a stretch converted, where the conversion
/// rises or falls all along the counts that occur. Where it turns, its extremes may lie anywhere
/// between: then the pyramid is of the physical values themselves, which are converted block by
/// block while it is built and take 17 % of the size of 16-bit samples.
class ChannelEnvelope
{
public:
    /// Errors: those of EnvelopePyramid::build.
    static Result<ChannelEnvelope> build(const Channel &channel, const JobControl &control = {});

    /// The envelope of `channel`, without reading its record, if that is the record of this
    /// envelope and what was looked at serves the conversion of `channel` too.
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

/// Whether sum polynomial[k] x^k is sure to rise or to fall all along [low, high]: all coefficients
/// of its derivative in the Bernstein basis of the interval have one sign. False is no proof of the
/// contrary, except below the third power.
bool isMonotone(const std::vector<double> &polynomial, double low, double high);

} // namespace dyncal

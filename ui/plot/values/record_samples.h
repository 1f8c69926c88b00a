// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel_envelope.h"
#include "ui/plot/values/curve_samples.h"

namespace dyncal {

/// One recorded channel over time as a plot asks for it. Wide views need no reading of samples;
/// narrow ones read what they show. The sample rate of the channel must be known.
class RecordSamples : public CurveSamples
{
public:
    explicit RecordSamples(std::shared_ptr<const ChannelEnvelope> envelope);

    /// The whole record as extremes of `columns` stretches of about the same length, from the
    /// envelope alone: for export and print, and to fit axes.
    DrawnPoints overview(Index columns) const;

    Index size() const override { return channel().samples.size(); }
    Index firstFrom(double x) const override;
    Index firstBeyond(double x) const override;
    DrawnPoints samples(Index begin, Index end) const override;

protected:
    std::vector<SampleExtremes> stretches(std::span<const Index> edges) const override;
    Index grain() const override { return EnvelopePyramid::kBaseBlock; }

private:
    const Channel &channel() const { return m_envelope->channel(); }

    std::shared_ptr<const ChannelEnvelope> m_envelope;
};

} // namespace dyncal

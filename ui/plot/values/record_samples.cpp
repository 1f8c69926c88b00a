// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/record_samples.h"

#include <algorithm>
#include <ranges>

namespace dyncal {

RecordSamples::RecordSamples(std::shared_ptr<const ChannelEnvelope> envelope)
    : m_envelope(std::move(envelope))
{
}

Index RecordSamples::firstFrom(double x) const
{
    // Late samples may have equal times in double precision, so a division cannot find the index.
    const auto before = [this, x](Index i) { return channel().timeOf_s(i) < x; };
    return *std::ranges::partition_point(std::views::iota(Index(0), size()), before);
}

Index RecordSamples::firstBeyond(double x) const
{
    const auto upTo = [this, x](Index i) { return channel().timeOf_s(i) <= x; };
    return *std::ranges::partition_point(std::views::iota(Index(0), size()), upTo);
}

DrawnPoints RecordSamples::samples(Index begin, Index end) const
{
    DrawnPoints drawn;
    const Eigen::VectorXd values = physicalValues(channel(), begin, end - begin);
    drawn.y.assign(values.begin(), values.end());
    drawn.x.reserve(drawn.y.size());
    for (Index i = begin; i < end; ++i)
        drawn.x.push_back(channel().timeOf_s(i));
    return drawn;
}

std::vector<SampleExtremes> RecordSamples::stretches(std::span<const Index> edges) const
{
    // A part of the record that can no longer be read is a gap.
    return m_envelope->stretches(edges).value_or(std::vector<SampleExtremes>(edges.size() - 1));
}

DrawnPoints RecordSamples::overview(Index columns) const
{
    std::vector<Index> edges;
    for (Index k = 0; k < columns; ++k)
        edges.push_back(k * size() / columns / grain() * grain());
    edges.push_back(size());
    DrawnPoints drawn;
    drawn.enveloped = true;
    const std::vector<SampleExtremes> found = stretches(edges);
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (!found[k].any)
            continue;
        const double x
            = 0.5 * (channel().timeOf_s(edges[k]) + channel().timeOf_s(edges[k + 1] - 1));
        drawn.x.insert(drawn.x.end(), {x, x});
        drawn.y.insert(drawn.y.end(), {found[k].min, found[k].max});
    }
    return drawn;
}

} // namespace dyncal

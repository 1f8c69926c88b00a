// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/channel_envelope.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace dyncal {
namespace {

/// The physical values of a channel, converted when they are read.
class PhysicalSource : public SampleSource
{
public:
    explicit PhysicalSource(Channel channel)
        : m_channel(std::move(channel))
    {
    }

    bool read(Index begin, Index count, std::byte *target) const override
    {
        return m_channel.samples.visitBlocks(begin, begin + count, [&](auto counts, Index) {
            for (const auto raw : counts) {
                const double value = physicalValue(m_channel, static_cast<double>(raw));
                std::memcpy(target, &value, sizeof value);
                target += sizeof value;
            }
        });
    }

    bool isUnchanged() const override { return m_channel.samples.isWhole(); }

private:
    Channel m_channel;
};

bool sameConversion(const Channel &a, const Channel &b)
{
    return a.polynomial == b.polynomial && a.polarity == b.polarity && a.userScale == b.userScale;
}

/// Coefficients in powers of u, where x = low + u (high - low).
std::vector<double> onUnitInterval(std::vector<double> coefficients, double low, double high)
{
    const std::size_t count = coefficients.size();
    for (std::size_t i = 0; i + 1 < count; ++i) // repeated division by (x - low)
        for (std::size_t k = count - 1; k > i; --k)
            coefficients[k - 1] += low * coefficients[k];
    double power = 1.0;
    for (double &coefficient : coefficients) {
        coefficient *= power;
        power *= high - low;
    }
    return coefficients;
}

double binomial(std::size_t n, std::size_t k)
{
    double value = 1.0;
    for (std::size_t i = 0; i < k; ++i)
        value *= static_cast<double>(n - i) / static_cast<double>(i + 1);
    return value;
}

} // namespace

bool isMonotone(const std::vector<double> &polynomial, double low, double high)
{
    std::vector<double> slope;
    for (std::size_t k = 1; k < polynomial.size(); ++k)
        slope.push_back(static_cast<double>(k) * polynomial[k]);
    if (slope.empty())
        return true;
    slope = onUnitInterval(std::move(slope), low, high);
    const std::size_t degree = slope.size() - 1;
    bool rises = true;
    bool falls = true;
    for (std::size_t i = 0; i <= degree; ++i) {
        double bernstein = 0.0;
        for (std::size_t k = 0; k <= i; ++k)
            bernstein += binomial(i, k) / binomial(degree, k) * slope[k];
        rises = rises && bernstein >= 0.0; // false for NaN
        falls = falls && bernstein <= 0.0;
    }
    return rises || falls;
}

ChannelEnvelope::ChannelEnvelope(
    Channel channel, std::shared_ptr<const EnvelopePyramid> pyramid, bool ofValues)
    : m_channel(std::move(channel))
    , m_pyramid(std::move(pyramid))
    , m_ofValues(ofValues)
{
}

Result<ChannelEnvelope> ChannelEnvelope::build(const Channel &channel, const JobControl &control)
{
    auto counts = EnvelopePyramid::build(channel.samples, control);
    if (!counts)
        return tl::unexpected(counts.error());
    const SampleExtremes all = counts->extremes();
    if (isMonotone(channel.polynomial, all.min, all.max))
        return ChannelEnvelope(
            channel, std::make_shared<const EnvelopePyramid>(std::move(*counts)), false);
    auto values = EnvelopePyramid::build(RawSamples(std::make_shared<PhysicalSource>(channel),
                                             SampleType::Float64, channel.samples.size()),
        control);
    if (!values)
        return tl::unexpected(values.error());
    return ChannelEnvelope(
        channel, std::make_shared<const EnvelopePyramid>(std::move(*values)), true);
}

std::optional<ChannelEnvelope> ChannelEnvelope::of(const Channel &channel) const
{
    if (!m_channel.samples.sharesWith(channel.samples))
        return {};
    const SampleExtremes all = m_pyramid->extremes();
    if (m_ofValues ? sameConversion(m_channel, channel)
                   : isMonotone(channel.polynomial, all.min, all.max))
        return ChannelEnvelope(channel, m_pyramid, m_ofValues);
    return {};
}

SampleExtremes ChannelEnvelope::converted(const SampleExtremes &found) const
{
    if (m_ofValues || !found.any)
        return found;
    const double a = physicalValue(m_channel, found.min);
    const double b = physicalValue(m_channel, found.max);
    if (!std::isfinite(a) || !std::isfinite(b))
        return {0.0, 0.0, false, true};
    return {std::min(a, b), std::max(a, b), true, found.invalid};
}

SampleExtremes ChannelEnvelope::extremes() const
{
    return converted(m_pyramid->extremes());
}

std::optional<std::vector<SampleExtremes>> ChannelEnvelope::stretches(
    std::span<const Index> edges) const
{
    auto found = m_pyramid->stretches(edges);
    if (found)
        for (SampleExtremes &stretch : *found)
            stretch = converted(stretch);
    return found;
}

} // namespace dyncal

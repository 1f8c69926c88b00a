// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"

#include <cstring>

namespace dyncal::bench {

/// Counts of a long recording made when they are read: noise, a step in the middle and one sample
/// far beyond everything, so that no file and no memory is needed to make a long file.
class GeneratedCounts : public SampleSource
{
public:
    GeneratedCounts(Index size, std::uint64_t seed)
        : m_size(size)
        , m_seed(seed)
    {
    }

    bool read(Index begin, Index count, std::byte *target) const override
    {
        for (Index i = begin; i < begin + count; ++i, target += sizeof(std::int16_t)) {
            const std::int16_t value = valueAt(i);
            std::memcpy(target, &value, sizeof value);
        }
        return true;
    }

private:
    std::int16_t valueAt(Index i) const
    {
        if (i == m_size / 3)
            return 30000;
        std::uint64_t bits = (static_cast<std::uint64_t>(i) + m_seed) * 0x9E3779B97F4A7C15U;
        bits ^= bits >> 31U;
        const auto noise = static_cast<int>(bits % 512U) - 256;
        return static_cast<std::int16_t>((i < m_size / 2 ? -2000 : 6000) + noise);
    }

    Index m_size;
    std::uint64_t m_seed;
};

/// One shot of up to three channels (sensor under test, side wall, driver) at 100 MS/s.
inline CaptureSet recording(int channels, Index samples)
{
    CaptureSet set;
    set.inputs.emplace_back();
    Shot &shot = set.shots.emplace_back();
    for (int i = 0; i < channels; ++i) {
        Channel channel;
        channel.role = static_cast<ChannelRole>(i);
        channel.name = channelRoleName(channel.role);
        channel.samples = RawSamples(
            std::make_shared<GeneratedCounts>(samples, i * 7919 + 1), SampleType::Int16, samples);
        channel.sampleRate_Hz = 1e8;
        channel.polynomial = {0.0, 10.0 / 32768.0};
        shot.channels.push_back(channel);
    }
    return set;
}

} // namespace dyncal::bench

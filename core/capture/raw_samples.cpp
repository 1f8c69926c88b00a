// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/raw_samples.h"

#include "core/base/content_hash.h"

#include <array>
#include <bit>
#include <cstring>
#include <limits>

namespace dyncal {

static_assert(std::endian::native == std::endian::little, "hashes are of little-endian bytes");

Index bytesPerSample(SampleType type)
{
    static constexpr std::array<Index, 7> kBytes{2, 4, 4, 8, 1, 1, 2};
    return kBytes[static_cast<std::size_t>(type)];
}

RawSamples::RawSamples()
    : RawSamples(Counts())
{
}

RawSamples::RawSamples(Counts counts)
    : m_counts(std::make_shared<const Counts>(std::move(counts)))
    , m_type(static_cast<SampleType>(m_counts->index()))
    , m_size(std::visit([](const auto &v) { return std::ssize(v); }, *m_counts))
{
}

RawSamples::RawSamples(std::shared_ptr<const SampleSource> source, SampleType type, Index size)
    : m_source(std::move(source))
    , m_type(type)
    , m_size(size)
{
}

double RawSamples::at(Index i) const
{
    double value = std::numeric_limits<double>::quiet_NaN();
    visitBlocks(i, i + 1, [&](auto values, Index) { value = static_cast<double>(values[0]); });
    return value;
}

RawSamples RawSamples::inMemory(Index begin, Index count) const
{
    RawSamples copy;
    bool complete = true;
    visitBlocks(begin, begin + (count > 0 ? 1 : 0), [&](auto first, Index) {
        using T = std::remove_const_t<typename decltype(first)::element_type>;
        std::vector<T> all(static_cast<std::size_t>(count));
        complete = visitBlocks(begin, begin + count,
            [&](auto values, Index at) { std::ranges::copy(values, all.begin() + (at - begin)); });
        copy = RawSamples(Counts(std::move(all)));
    });
    return complete ? copy : RawSamples();
}

std::string sha256OfSamples(const RawSamples &samples)
{
    Sha256 hash;
    const bool complete = samples.visitBlocks(
        0, samples.size(), [&](auto values, Index) { hash.add(std::as_bytes(values)); });
    return complete ? hash.hex() : std::string();
}

} // namespace dyncal

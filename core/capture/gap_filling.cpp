// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/gap_filling.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace dyncal {
namespace {

bool hasInvalid(const RawSamples &samples)
{
    bool found = false;
    samples.visitBlocks(0, samples.size(), [&](auto values, Index) {
        found = std::any_of(values.begin(), values.end(),
            [](auto value) { return !std::isfinite(static_cast<double>(value)); });
        return !found;
    });
    return found;
}

template <typename T>
Index fill(std::vector<T> &values, Index longest)
{
    const Index size = std::ssize(values);
    const auto at = [&](Index i) -> T & { return values[static_cast<std::size_t>(i)]; };
    Index filled = 0;
    for (Index begin = 0; begin < size;) {
        if (std::isfinite(at(begin))) {
            ++begin;
            continue;
        }
        Index end = begin;
        while (end < size && !std::isfinite(at(end)))
            ++end;
        if (begin > 0 && end < size && end - begin <= longest) {
            const double from = at(begin - 1);
            const double slope = (at(end) - from) / static_cast<double>(end - begin + 1);
            for (Index k = begin; k < end; ++k)
                at(k) = static_cast<T>(from + slope * static_cast<double>(k - begin + 1));
            filled += end - begin;
        }
        begin = end;
    }
    return filled;
}

template <typename T>
Index fillAs(RawSamples &samples, Index longest)
{
    std::vector<T> values(static_cast<std::size_t>(samples.size()));
    const bool complete = samples.visitBlocks(0, samples.size(), [&](auto block, Index first) {
        std::memcpy(values.data() + first, block.data(), block.size_bytes());
    });
    const Index filled = complete ? fill(values, longest) : 0;
    if (filled > 0)
        samples = RawSamples(RawSamples::Counts(std::move(values)));
    return filled;
}

} // namespace

Index fillGaps(RawSamples &samples, Index longest)
{
    if (longest < 1 || samples.isInteger() || !hasInvalid(samples))
        return 0;
    return samples.type() == SampleType::Float32 ? fillAs<float>(samples, longest)
                                                 : fillAs<double>(samples, longest);
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/raw_samples.h"

#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace dyncal {

/// Least and greatest number of a stretch of samples.
struct SampleExtremes
{
    double min = 0.0;
    double max = 0.0;
    bool any = false; ///< false: the stretch holds no finite number (or no sample)
    bool invalid = false; ///< the stretch holds NaN or infinities; they are not in min and max

    bool operator==(const SampleExtremes &) const = default;
};

/// Exact minima and maxima over any stretches of a record, however long, without looking at all of
/// its samples again: extremes of blocks of 64 samples, of 4 blocks, of 16 blocks and so on, in the
/// type of the samples. They take less than 5 % of the record's own size. Whatever blocks do not
/// cover is read from the samples, so nothing is ever approximated: a spike of one sample is found
/// by every stretch that holds it and by no other.
class EnvelopePyramid
{
public:
    static constexpr Index kBaseBlock = 64;
    static constexpr Index kFanOut = 4;

    /// Of no samples.
    EnvelopePyramid() = default;

    /// Reads the record once, in order. Fails with Cancelled, or with FileUnreadable (CAP-018) if
    /// the samples cannot be read any more.
    static Result<EnvelopePyramid> build(RawSamples samples, const JobControl &control = {});

    const RawSamples &samples() const { return m_samples; }
    Index size() const { return m_samples.size(); }
    Index memory_bytes() const; ///< taken beside the samples

    /// Of the whole record; needs no reading.
    SampleExtremes extremes() const;

    /// Extremes of the stretches [edges[k], edges[k + 1]). Edges ascend (equal neighbours make an
    /// empty stretch) and lie within 0..size(). At most one base block of samples is read per edge
    /// (edges close together in one read), none at multiples of kBaseBlock or at the record's end.
    /// Empty if the samples cannot be read any more.
    std::optional<std::vector<SampleExtremes>> stretches(std::span<const Index> edges) const;

private:
    template <typename T>
    struct Level
    {
        std::vector<T> min; ///< min > max: no finite number in the block
        std::vector<T> max;
        std::vector<std::uint8_t> invalid; ///< empty for integers
    };
    template <typename T>
    using Levels = std::vector<Level<T>>; ///< finest first; the last has one block
    template <typename T>
    class Builder;
    template <typename T>
    class Query;

    RawSamples m_samples;
    /// In the order of SampleType.
    std::variant<Levels<std::int16_t>, Levels<std::int32_t>, Levels<float>, Levels<double>,
        Levels<std::int8_t>, Levels<std::uint8_t>, Levels<std::uint16_t>>
        m_levels;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/envelope_pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr Index kBlock = EnvelopePyramid::kBaseBlock;
constexpr Index kFan = EnvelopePyramid::kFanOut;
/// Edges closer than this are read together: one call costs as much time as reading so many
/// samples.
constexpr Index kReadGap = 512;

constexpr Index blocksFor(Index count, Index block)
{
    return (count + block - 1) / block;
}

constexpr std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Extremes in the type of the samples; empty while min > max.
template <typename T>
struct Range
{
    // Infinities for floating point: an infinite sample must not look like the empty range.
    static constexpr bool kFloating = std::is_floating_point_v<T>;
    static constexpr T kHighest
        = kFloating ? std::numeric_limits<T>::infinity() : std::numeric_limits<T>::max();
    static constexpr T kLowest
        = kFloating ? -std::numeric_limits<T>::infinity() : std::numeric_limits<T>::lowest();

    T min = kHighest;
    T max = kLowest;
    bool invalid = false;

    void include(T low, T high)
    {
        min = low < min ? low : min;
        max = high > max ? high : max;
    }
    void includeEach(std::span<const T> values)
    {
        for (const T value : values) {
            if constexpr (kFloating) {
                if (!std::isfinite(value)) {
                    invalid = true;
                    continue;
                }
            }
            include(value, value);
        }
    }
};

/// One whole base block. Plain loops that the compiler vectorises; they decide how fast a record
/// opens (docs/benchmarks.md).
template <typename T>
Range<T> rangeOfBlock(const T *values)
{
    Range<T> range;
    if constexpr (!Range<T>::kFloating) {
        for (Index i = 0; i < kBlock; ++i)
            range.include(values[i], values[i]);
    } else {
        // Minima of floating point numbers may not be reordered, so each lane has its own.
        constexpr std::size_t kLanes = 32 / sizeof(T);
        std::array<T, kLanes> min;
        std::array<T, kLanes> max;
        min.fill(Range<T>::kHighest);
        max.fill(Range<T>::kLowest);
        std::array<T, kLanes> differences{}; // x - x: NaN for a NaN or infinity
        for (Index i = 0; i < kBlock; i += static_cast<Index>(kLanes)) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                const T value = values[at(i) + lane];
                min[lane] = value < min[lane] ? value : min[lane];
                max[lane] = value > max[lane] ? value : max[lane];
                differences[lane] += value - value;
            }
        }
        if (std::ranges::any_of(differences, [](T d) { return std::isnan(d); }))
            range.includeEach({values, at(kBlock)});
        else
            for (std::size_t lane = 0; lane < kLanes; ++lane)
                range.include(min[lane], max[lane]);
    }
    return range;
}

template <typename T>
SampleExtremes extremesOf(const Range<T> &range)
{
    if (range.min > range.max)
        return {0.0, 0.0, false, range.invalid};
    return {static_cast<double>(range.min), static_cast<double>(range.max), true, range.invalid};
}

} // namespace

/// Fills the levels as the samples arrive.
template <typename T>
class EnvelopePyramid::Builder
{
public:
    explicit Builder(Index count)
    {
        Index blocks = blocksFor(count, kBlock);
        while (blocks > 0) {
            Level<T> &level = m_levels.emplace_back();
            level.min.assign(at(blocks), Range<T>::kHighest);
            level.max.assign(at(blocks), Range<T>::kLowest);
            if constexpr (Range<T>::kFloating)
                level.invalid.assign(at(blocks), 0);
            blocks = blocks == 1 ? 0 : blocksFor(blocks, kFan);
        }
    }

    void add(std::span<const T> values, Index first)
    {
        Level<T> &base = m_levels.front();
        while (!values.empty()) {
            const Index block = first / kBlock;
            const Index here = std::min(std::ssize(values), (block + 1) * kBlock - first);
            if (here == kBlock) {
                include(base, block, rangeOfBlock(values.data()));
            } else {
                Range<T> part;
                part.includeEach(values.first(at(here)));
                include(base, block, part);
            }
            values = values.subspan(at(here));
            first += here;
        }
    }

    Levels<T> finish()
    {
        for (std::size_t i = 1; i < m_levels.size(); ++i)
            for (Index block = 0; block < std::ssize(m_levels[i - 1].min); ++block)
                include(m_levels[i], block / kFan, rangeOf(m_levels[i - 1], block));
        return std::move(m_levels);
    }

    static Range<T> rangeOf(const Level<T> &level, Index block)
    {
        return {level.min[at(block)], level.max[at(block)],
            Range<T>::kFloating && level.invalid[at(block)] != 0};
    }

private:
    static void include(Level<T> &level, Index block, const Range<T> &range)
    {
        T &min = level.min[at(block)];
        T &max = level.max[at(block)];
        min = range.min < min ? range.min : min;
        max = range.max > max ? range.max : max;
        if constexpr (Range<T>::kFloating)
            level.invalid[at(block)] |= range.invalid ? 1 : 0;
    }

    Levels<T> m_levels;
};

/// Answers one request for stretches: blocks first, then what has to be read.
template <typename T>
class EnvelopePyramid::Query
{
public:
    Query(const RawSamples &samples, const Levels<T> &levels, std::span<const Index> edges)
        : m_samples(samples)
        , m_levels(levels)
        , m_ranges(edges.empty() ? 0 : edges.size() - 1)
    {
        for (std::size_t k = 0; k < m_ranges.size(); ++k)
            divide(edges[k], edges[k + 1], k);
    }

    std::optional<std::vector<SampleExtremes>> answer()
    {
        for (std::size_t next = 0; next < m_pieces.size();) {
            std::size_t end = next + 1;
            while (end < m_pieces.size() && m_pieces[end].begin - m_pieces[end - 1].end <= kReadGap)
                ++end;
            if (!read({m_pieces.data() + next, end - next}))
                return {};
            next = end;
        }
        std::vector<SampleExtremes> found;
        found.reserve(m_ranges.size());
        for (const Range<T> &range : m_ranges)
            found.push_back(extremesOf(range));
        return found;
    }

private:
    struct Piece ///< samples of one stretch that no whole block covers
    {
        Index begin;
        Index end;
        std::size_t stretch;
    };

    void divide(Index begin, Index end, std::size_t stretch)
    {
        const Index firstBlock = blocksFor(begin, kBlock);
        const Index endBlock
            = end == m_samples.size() ? blocksFor(end, kBlock) : end / kBlock; // the last is short
        if (firstBlock >= endBlock) {
            addPiece(begin, end, stretch);
            return;
        }
        addPiece(begin, firstBlock * kBlock, stretch);
        includeBlocks(firstBlock, endBlock, m_ranges[stretch]);
        addPiece(endBlock * kBlock, end, stretch);
    }

    void addPiece(Index begin, Index end, std::size_t stretch)
    {
        if (begin < end)
            m_pieces.push_back({begin, end, stretch});
    }

    /// Blocks [begin, end) of the finest level, taken from the coarsest levels that have them.
    void includeBlocks(Index begin, Index end, Range<T> &range) const
    {
        for (const Level<T> &level : m_levels) {
            const Index count = std::ssize(level.min);
            const bool coarsest = count == 1;
            for (; begin < end && (coarsest || begin % kFan != 0); ++begin)
                include(level, begin, range);
            for (; begin < end && end != count && end % kFan != 0; --end)
                include(level, end - 1, range);
            if (begin >= end)
                return;
            begin /= kFan;
            end = blocksFor(end, kFan);
        }
    }

    static void include(const Level<T> &level, Index block, Range<T> &range)
    {
        const Range<T> here = Builder<T>::rangeOf(level, block);
        range.include(here.min, here.max);
        range.invalid = range.invalid || here.invalid;
    }

    bool read(std::span<const Piece> pieces)
    {
        std::size_t next = 0;
        return m_samples.visitBlocks(
            pieces.front().begin, pieces.back().end, [&](auto values, Index first) {
                if constexpr (std::is_same_v<decltype(values), std::span<const T>>) {
                    const Index last = first + std::ssize(values);
                    for (std::size_t k = next; k < pieces.size() && pieces[k].begin < last; ++k) {
                        const Index begin = std::max(pieces[k].begin, first);
                        const Index end = std::min(pieces[k].end, last);
                        if (begin < end)
                            m_ranges[pieces[k].stretch].includeEach(
                                values.subspan(at(begin - first), at(end - begin)));
                        next = end == pieces[k].end ? k + 1 : k;
                    }
                }
            });
    }

    const RawSamples &m_samples;
    const Levels<T> &m_levels;
    std::vector<Range<T>> m_ranges;
    std::vector<Piece> m_pieces; ///< in the order of the record
};

Result<EnvelopePyramid> EnvelopePyramid::build(RawSamples samples, const JobControl &control)
{
    EnvelopePyramid pyramid;
    pyramid.m_samples = std::move(samples);
    const Index count = pyramid.size();
    bool complete = true;
    const auto buildAs = [&]<typename T>(Levels<T> &levels) {
        Builder<T> builder(count);
        complete = pyramid.m_samples.visitBlocks(0, count, [&](auto values, Index first) {
            if constexpr (std::is_same_v<decltype(values), std::span<const T>>) {
                // A record in memory comes as one stretch; in blocks, so that a stop is seen.
                for (Index done = 0; done < std::ssize(values); done += RawSamples::kBlock) {
                    if (control.stopRequested())
                        return false;
                    builder.add(values.subspan(at(done),
                                    at(std::min(RawSamples::kBlock, std::ssize(values) - done))),
                        first + done);
                    control.report(static_cast<double>(first + done) / static_cast<double>(count));
                }
            }
            return true;
        });
        levels = builder.finish();
    };
    const auto choose = [&]<std::size_t... kType>(std::index_sequence<kType...>)
    {
        (void)((at(static_cast<Index>(pyramid.m_samples.type())) == kType
                   && (buildAs(pyramid.m_levels.emplace<kType>()), true))
            || ...);
    };
    choose(std::make_index_sequence<std::variant_size_v<decltype(m_levels)>>());
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Cancelled."), {}});
    if (!complete)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "A recording cannot be read any more: its file was changed or is gone; add it again."),
                {}},
            "CAP-018");
    control.report(1.0);
    return pyramid;
}

Index EnvelopePyramid::memory_bytes() const
{
    return std::visit(
        [](const auto &levels) {
            Index bytes = 0;
            for (const auto &level : levels)
                bytes += static_cast<Index>(
                    2 * level.min.size() * sizeof(level.min[0]) + level.invalid.size());
            return bytes;
        },
        m_levels);
}

SampleExtremes EnvelopePyramid::extremes() const
{
    return std::visit(
        []<typename T>(const Levels<T> &levels) {
            return levels.empty() ? SampleExtremes()
                                  : extremesOf(Builder<T>::rangeOf(levels.back(), 0));
        },
        m_levels);
}

std::optional<std::vector<SampleExtremes>> EnvelopePyramid::stretches(
    std::span<const Index> edges) const
{
    return std::visit(
        [&]<typename T>(
            const Levels<T> &levels) { return Query<T>(m_samples, levels, edges).answer(); },
        m_levels);
}

} // namespace dyncal

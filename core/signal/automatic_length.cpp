// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/automatic_length.h"

#include "core/signal/fft.h"
#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace dyncal {
namespace {

constexpr Index kBlocks = 1000; ///< into which the record after the start is divided
constexpr Index kLeastBlock = 8;
constexpr Index kFirstBlocks = 20; ///< until then the level is taken to be still settling
constexpr Index kLasting = 10; ///< blocks that a departure from the plateau must last
constexpr Index kLeastLasting = 3; ///< at the end of the record
constexpr double kDepartureShare = 0.03; ///< of the step, for the size of ringing, too
constexpr double kLeastPlateau = 0.1; ///< of the largest excursion: below, the response only begins
constexpr Index kZoom = 10; ///< from one look at the record's beginning to the next, closer one
constexpr double kDepartureSigmas = 6.0;
constexpr Index kGapPart = 4; ///< of the time so far, in which a level may leave by and by
constexpr double kParabola = 1.5; ///< times what goes on like a parabola is no departure
constexpr double kDecayed = 1.5; ///< rms of a block over the noise
// Ringing in the blocks: a peak of the power spectrum of their differences, in which the end of a
// plateau is flat and drift is small.
constexpr Index kLeastPeriods = 4; ///< on record
constexpr Index kPeriodsLookedAt = 3; ///< for its size
constexpr double kOverMedian = 25.0; ///< of the power: noise alone reaches 15
constexpr double kProminence = 10.0; ///< over the least power an octave below and above

/// What is compared with the blocks that follow, and by how much these must differ.
struct Departure
{
    Index part = 2; ///< the blocks before without the first 1/part of them
    double share = kDepartureShare; ///< of the step
};

/// In a closer look at the beginning, where the top of an overshoot is not yet far behind, and
/// where an echo is no end.
constexpr Departure kEarlyDeparture{4, 0.1};

/// `reduce` of the finite samples of each block after `start`; NaN for blocks without any.
template <typename Reduction>
Eigen::VectorXd blockValues(
    const Channel &channel, Index start, Index limit, Index block, const Reduction &reduce)
{
    Eigen::VectorXd values(limit / block);
    for (Index b = 0; b < values.size(); ++b) {
        const Eigen::VectorXd samples
            = finiteOnly(physicalValues(channel, start + b * block, block));
        values[b] = samples.size() > 0 ? reduce(samples) : std::numeric_limits<double>::quiet_NaN();
    }
    return values;
}

/// What the blocks before a departure are like.
struct Plateau
{
    double level = 0.0;
    double range = 0.0;
    double slope = 0.0; ///< from one third to the next
    double curvature = 0.0; ///< change of that slope

    /// By how much a parabola through the thirds moves in so many of them from the middle one.
    double movesIn(double thirds) const
    {
        return std::abs(slope) * thirds + 0.5 * std::abs(curvature) * thirds * thirds;
    }
};

std::optional<Plateau> plateauOf(const Eigen::VectorXd &blocks)
{
    const Eigen::VectorXd values = finiteOnly(blocks);
    const Index third = values.size() / 3;
    if (values.size() == 0)
        return std::nullopt;
    Plateau plateau{median(values), values.maxCoeff() - values.minCoeff()};
    if (third > 0) {
        const double first = median(values.head(third)), last = median(values.tail(third));
        plateau.slope = 0.5 * (last - first);
        plateau.curvature = first + last - 2.0 * median(values.segment(third, third));
    }
    return plateau;
}

/// A level, and by how much others may differ from it.
struct Surroundings
{
    double baseline = 0.0;
    double noise = 0.0;
    Index shared = 0; ///< blocks that hold samples of the next one
};

/// Where the blocks from `first` on leave the level of the latter part of those before, for as long
/// as the plateau has lasted so far or to the end. Half a period of slow ringing does not last that
/// long. Ringing, or a slow rise or droop that goes on, does not leave the range of the blocks
/// before, nor what a parabola through them would. The last `gap` blocks before are not looked at:
/// a level that leaves by and by has left in them, and where it began to is the answer.
std::optional<Index> departure(const Eigen::VectorXd &levels, Index first, Index gap,
    const Surroundings &around, const Departure &rule)
{
    const Index count = std::min(std::max(kLasting, first), levels.size() - first);
    const Index from = first / rule.part;
    const Index size = std::max(first - from - around.shared - gap, Index(0));
    const auto before = plateauOf(levels.segment(from, size));
    if (count < kLeastLasting || !before || (gap > 0 && size < 2 * around.shared))
        return std::nullopt;
    const double within = std::max(around.noise, before->range);
    const double thirds = 3.0 * static_cast<double>(first - from) / static_cast<double>(size) - 1.5;
    const double distance = std::max({rule.share * std::abs(before->level - around.baseline),
        within, kParabola * before->movesIn(thirds)});
    const auto difference = (levels.segment(first, count).array() - before->level).eval();
    if (!(difference > distance).all() && !(difference < -distance).all())
        return std::nullopt;
    Index end = first;
    while (end > first - gap && std::abs(levels[end - 1] - before->level) > within)
        --end;
    return end;
}

/// Mean of `count` blocks from each one on: ringing of that period is not seen in it.
Eigen::VectorXd runningMean(const Eigen::VectorXd &levels, Index count)
{
    Eigen::VectorXd means(levels.size() - count + 1);
    for (Index b = 0; b < means.size(); ++b)
        means[b] = levels.segment(b, count).mean();
    return means;
}

/// Whether ringing of that period is large enough to be taken for a departure.
bool isLarge(const Eigen::VectorXd &levels, Index period, double baseline)
{
    const Index count = std::min(kPeriodsLookedAt * period, levels.size() - period + 1);
    const Eigen::VectorXd mean = runningMean(levels.head(count + period - 1), period);
    const double ringing = std::sqrt(
        (levels.segment(period / 2, count) - mean).squaredNorm() / static_cast<double>(count));
    return ringing > 0.5 * kDepartureShare * std::abs(median(levels) - baseline);
}

/// Means of the blocks of a record's part after `start`, without large ringing.
class StepLevels
{
public:
    StepLevels(const Channel &channel, Index start, Index span, double baseline, double noiseSd)
        : m_block(std::max(span / kBlocks, kLeastBlock))
        , m_baseline(baseline)
        , m_noise(kDepartureSigmas * noiseSd / std::sqrt(static_cast<double>(m_block)))
        , m_levels(blockValues(channel, start, span, m_block,
              [](const Eigen::VectorXd &samples) { return samples.mean(); }))
        , m_period(slowestRinging_blocks(m_levels))
    {
        if (m_period > 1 && isLarge(m_levels, m_period, baseline)) {
            m_levels = runningMean(m_levels, m_period);
            m_shared = m_period - 1;
        }
    }

    Index ringing() const { return m_period * m_block; } ///< its period in samples, or 0

    /// Samples until the level leaves its plateau, times kUsedShare.
    std::optional<Index> lengthOfPlateau(const Departure &rule) const
    {
        if (m_levels.size() <= kFirstBlocks)
            return std::nullopt;
        const double least = kLeastPlateau
            * (m_levels.array() - m_baseline).abs().maxCoeff<Eigen::PropagateNumbers>();
        for (Index b = std::max(kFirstBlocks, 4 * m_shared); b < m_levels.size(); ++b) {
            for (const Index gap : {b / kGapPart, Index(0)}) {
                const auto end = departure(m_levels, b, gap, {m_baseline, m_noise, m_shared}, rule);
                if (end && !(std::abs(m_levels[*end - 1] - m_baseline) < least))
                    return static_cast<Index>(kUsedShare * static_cast<double>(*end * m_block));
            }
        }
        return std::nullopt;
    }

private:
    Index m_block = 1; ///< samples
    double m_baseline = 0.0;
    double m_noise = 0.0;
    Eigen::VectorXd m_levels;
    Index m_period = 0; ///< of ringing, blocks
    Index m_shared = 0; ///< blocks that have samples in common with the next one
};

} // namespace

Index slowestRinging_blocks(const Eigen::VectorXd &levels)
{
    if (levels.size() < 2 * kLeastPeriods + 2 || !levels.allFinite())
        return 0;
    const Index count = levels.size() - 1;
    Eigen::VectorXd steps = levels.tail(count) - levels.head(count);
    steps.array() -= steps.mean();
    for (Index i = 0; i < count; ++i) {
        const double turn = 2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5);
        steps[i] *= 0.5 - 0.5 * std::cos(turn / static_cast<double>(count));
    }
    const Eigen::VectorXd power = RealFft(count).forward(steps).cwiseAbs2();
    const double floor = kOverMedian * median(power.tail(power.size() - 1));
    for (Index k = kLeastPeriods; 2 * k < power.size(); ++k) {
        const bool isPeak = power[k] > floor && power[k] >= power[k - 1] && power[k] >= power[k + 1]
            && power[k] > kProminence * power.segment(k / 2, k - k / 2).minCoeff()
            && power[k] > kProminence * power.segment(k + 1, k).minCoeff();
        if (isPeak)
            return (count + k - 1) / k;
    }
    return 0;
}

Index automaticStepLength(
    const Channel &channel, Index start, Index limit, double baseline, double noiseSd)
{
    Index ringing = 0;
    const auto look = [&](Index span, const Departure &rule) {
        const StepLevels levels(channel, start, span, baseline, noiseSd);
        ringing = std::max(ringing, levels.ringing());
        return levels.lengthOfPlateau(rule);
    };
    Index length = look(limit, Departure()).value_or(limit);
    // Of a long record the first blocks may hold the whole plateau. Closer looks see it, as long as
    // ringing that a wider one has seen is seen by them, too.
    for (Index span = limit / kZoom; span >= kBlocks * kLeastBlock; span /= kZoom) {
        if (span < 2 * kLeastPeriods * ringing)
            break;
        length = std::min(length, look(span, kEarlyDeparture).value_or(length));
    }
    return length;
}

Index automaticDecayLength(
    const Channel &channel, Index start, Index limit, double baseline, double noiseSd)
{
    const Index block = std::max(limit / kBlocks, kLeastBlock);
    const Eigen::VectorXd rms
        = blockValues(channel, start, limit, block, [&](const Eigen::VectorXd &samples) {
              return std::sqrt((samples.array() - baseline).square().mean());
          });
    for (Index b = 1; b + kLasting <= rms.size(); ++b) {
        if ((rms.segment(b, kLasting).array() <= kDecayed * noiseSd).all())
            return std::max(b * block, kLeastWindow);
    }
    return limit;
}

} // namespace dyncal

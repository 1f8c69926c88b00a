// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/automatic_length.h"

#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr Index kBlocks = 1000; ///< into which the record after the start is divided
constexpr Index kLeastBlock = 8;
constexpr Index kFirstBlocks = 20; ///< until then the level is taken to be still settling
constexpr Index kLasting = 10; ///< blocks that a departure from the plateau must last
constexpr Index kLeastLasting = 3; ///< at the end of the record
constexpr double kDepartureShare = 0.03; ///< of the step
constexpr double kDepartureSigmas = 6.0;
constexpr double kDecayed = 1.5; ///< rms of a block over the noise

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

/// Whether the blocks from `first` on leave the level of the latter half of those before, for as
/// long as the plateau has lasted so far or to the end. Half a period of slow ringing does not last
/// that long. Ringing, or a slow rise or droop that goes on, does not leave the range of the blocks
/// before.
bool departs(const Eigen::VectorXd &levels, Index first, double baseline, double noise)
{
    const Index count = std::min(std::max(kLasting, first), levels.size() - first);
    const Eigen::VectorXd before = finiteOnly(levels.segment(first / 2, first - first / 2));
    if (count < kLeastLasting || before.size() == 0)
        return false;
    const double plateau = median(before);
    const double distance = std::max({kDepartureShare * std::abs(plateau - baseline), noise,
        before.maxCoeff() - before.minCoeff()});
    const auto difference = (levels.segment(first, count).array() - plateau).eval();
    return (difference > distance).all() || (difference < -distance).all();
}

} // namespace

Index automaticStepLength(
    const Channel &channel, Index start, Index limit, double baseline, double noiseSd)
{
    const Index block = std::max(limit / kBlocks, kLeastBlock);
    const Eigen::VectorXd levels = blockValues(channel, start, limit, block,
        [](const Eigen::VectorXd &samples) { return samples.mean(); });
    const double noise = kDepartureSigmas * noiseSd / std::sqrt(static_cast<double>(block));
    for (Index b = kFirstBlocks; b < levels.size(); ++b) {
        if (departs(levels, b, baseline, noise))
            return static_cast<Index>(kUsedShare * static_cast<double>(b * block));
    }
    return limit;
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

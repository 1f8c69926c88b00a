// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/event_search.h"

#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kSearchBlocks = 4096; ///< a record is first looked at in about this many blocks
constexpr Index kLeastSearchBlock = 16;
constexpr Index kSideBlocks = 4; ///< blocks on either side that a level change is averaged over
constexpr double kFirstShare = 0.25; ///< of the largest: the first change this large is the event,
                                     ///< as a side wall sees the incident and the reflected shock
constexpr double kLevelShare = 0.25; ///< of the largest excursion; less is no change of level
constexpr double kLevelSigmas = 8.0;

/// Change of level at the begin of each block: mean of the blocks after it less the mean before.
Eigen::VectorXd levelChanges(const Eigen::VectorXd &level)
{
    const Index n = level.size();
    Eigen::VectorXd change = Eigen::VectorXd::Zero(n);
    for (Index b = 1; b < n; ++b) {
        const Index before = std::min(b, kSideBlocks), behind = std::min(n - b, kSideBlocks);
        change[b]
            = std::abs(level.segment(b, behind).mean() - level.segment(b - before, before).mean());
    }
    return change;
}

/// The first block whose value reaches a share of the largest.
Index firstReaching(const Eigen::VectorXd &values, double share)
{
    const double limit = share * values.maxCoeff();
    return std::find_if(values.begin(), values.end(), [&](double v) { return v >= limit; })
        - values.begin();
}

} // namespace

Eigen::VectorXd withoutSpikes(Eigen::VectorXd values)
{
    if (!values.allFinite())
        values = finiteOnly(std::move(values));
    const Index n = values.size();
    if (n < 3)
        return {};
    const auto a = values.head(n - 2).array(), b = values.segment(1, n - 2).array(),
               c = values.tail(n - 2).array();
    return a.min(b).max(a.max(b).min(c)).matrix();
}

double largestDistance(const Eigen::Ref<const Eigen::VectorXd> &values, double level)
{
    return values.size() > 0 ? (values.array() - level).abs().maxCoeff() : 0.0;
}

Result<BlockScan> scanBlocks(const Channel &channel, const JobControl &control)
{
    const Index size = channel.samples.size();
    const Index block = std::max(size / kSearchBlocks, kLeastSearchBlock);
    const Index blocks = size / block;
    BlockScan scan{block, Eigen::VectorXd::Zero(blocks), Eigen::VectorXd::Zero(blocks), false};
    for (Index b = 0; b < blocks; ++b) {
        if (b % 64 == 0 && control.stopRequested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
        const Eigen::VectorXd values = withoutSpikes(physicalValues(channel, b * block, block));
        if (values.size() > 0)
            scan.level[b] = values.mean();
        else if (b > 0)
            scan.level[b] = scan.level[b - 1];
        if (values.size() > 0 && !scan.anyValid) // an invalid begin makes no change of level
            scan.level.head(b).setConstant(scan.level[b]);
        scan.anyValid = scan.anyValid || values.size() > 0;
        scan.excursion[b] = largestDistance(values, scan.level[std::max<Index>(b - 2, 0)]);
        control.report(static_cast<double>(b + 1) / static_cast<double>(blocks));
    }
    return scan;
}

Event findEvent(const BlockScan &scan)
{
    const Eigen::VectorXd change = levelChanges(scan.level);
    const double highest = change.maxCoeff();
    const double noise = median(change); // of absolute values: 0.67 standard deviations
    if (highest >= kLevelShare * scan.excursion.maxCoeff() && highest > kLevelSigmas * noise) {
        const Index first = firstReaching(change, kFirstShare);
        Index climbed = 0;
        change.segment(first, std::min(2 * kSideBlocks, change.size() - first)).maxCoeff(&climbed);
        return {first + climbed, true};
    }
    return {firstReaching(scan.excursion, 0.5), false};
}

} // namespace dyncal

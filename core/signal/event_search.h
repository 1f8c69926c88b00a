// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/channel.h"

#include <Eigen/Core>

namespace dyncal {

/// Median of each three neighbours of the finite samples, so that lone spikes vanish; may be empty.
Eigen::VectorXd withoutSpikes(Eigen::VectorXd values);

/// Largest distance of a value from `level`; 0 for no values.
double largestDistance(const Eigen::Ref<const Eigen::VectorXd> &values, double level);

/// Coarse picture of a record: about 4096 blocks of at least 16 samples, without lone spikes.
struct BlockScan
{
    Index blockSize = 0;
    Eigen::VectorXd level; ///< mean of each block; of an invalid block: that of a neighbour
    Eigen::VectorXd excursion; ///< largest distance of a block from the level two blocks before
    bool anyValid = false;
};

/// Reads the record once, block by block. At least 32 samples. Fails only when stopped.
Result<BlockScan> scanBlocks(const Channel &channel, const JobControl &control);

/// Where the event of a record happens: in a block or at its begin.
struct Event
{
    Index block = 0;
    bool isSignificant = false; ///< a clear change of level, not only an excursion
};

/// The first large and lasting change of level; without one (impact, decay) the first large
/// excursion. A short burst can be higher than a step, so the change of level is preferred.
Event findEvent(const BlockScan &scan);

} // namespace dyncal

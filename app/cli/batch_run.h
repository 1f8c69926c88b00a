// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/batch/batch_plan.h"
#include "core/batch/batch_shard.h"
#include "core/batch/batch_tally.h"

#include <string>

namespace dyncal {

struct BatchRun
{
    std::string planFolder;
    BatchPlan plan;
    BatchShard shard;
    unsigned jobs = 1; ///< sensors at a time, each in a process with one thread
};

struct BatchOutcome
{
    BatchTally tally; ///< of the shard's sensors
    std::size_t computed = 0;
    std::size_t kept = 0; ///< complete before
};

/// Computes what is missing of the shard and says on stderr what failed. A sensor that fails or
/// crashes stops none other: why is kept beside its results. Fails (Usage) if the plan was made for
/// other versions of the methods; (Cancelled) when asked to stop, with what is complete kept; and
/// where processes cannot be started or a failure cannot be kept.
Result<BatchOutcome> runBatch(const BatchRun &run);

} // namespace dyncal

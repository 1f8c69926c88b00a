// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>

namespace dyncal {

/// What computes a batch elsewhere.
enum class BatchRunner { Slurm, Parallel, Make };

/// "slurm", "parallel" or "make"; fails (Usage) on anything else.
Result<BatchRunner> batchRunner(const std::string &name);

/// What a script is made from.
struct BatchScript
{
    BatchRunner runner = BatchRunner::Slurm;
    std::string plan; ///< path on the machines that run it
    std::string summary; ///< path of the summary
    std::size_t shards = 1; ///< at most kMostShardsOfScript
    unsigned jobs = 1; ///< of each shard
};

/// Clusters take arrays up to index 1000 unless they are told otherwise (MaxArraySize 1001).
inline constexpr std::size_t kMostShardsOfScript = 1000;

/// Shards for so many sensors: some 25 in each, because clusters limit what is submitted, at most
/// kMostShardsOfScript.
std::size_t usualShards(std::size_t sensors);

/// A script that runs all shards and then merges, however they ended; running or submitting it
/// again computes only what is missing. For Slurm: a shell script that submits one array and the
/// merge behind it (afterany). The program is $DYNCAL, or dyncal in the path. Fails (Usage) if a
/// path holds a line break, which make cannot be given.
Result<std::string> batchScript(const BatchScript &script);

} // namespace dyncal

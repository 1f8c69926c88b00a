// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_script.h"

#include <algorithm>

namespace dyncal {
namespace {

constexpr std::size_t kSensorsOfShard = 25;

/// One word of a POSIX shell, whatever is in it.
std::string shellWord(const std::string &text)
{
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

/// As make has to be given it to pass it on to a shell.
std::string makeWord(const std::string &text)
{
    std::string word;
    for (const char c : shellWord(text))
        word += c == '$' ? std::string("$$") : std::string(1, c);
    return word;
}

std::string runOf(const BatchScript &script, const std::string &plan, const std::string &shard)
{
    const std::string count = std::to_string(script.shards);
    return "batch run " + plan + " --shard " + shard + "/" + count + " --jobs "
        + std::to_string(script.jobs);
}

std::string slurmScript(const BatchScript &script)
{
    return "#!/bin/sh\n"
           "# Submits the batch to Slurm: one array, and the merge behind it. Submit it again after\n"
           "# failures: only what is missing is computed. Options for sbatch (partition, time) may\n"
           "# be given in SBATCH_OPTIONS. Exit code 1 of a task means cautions, not failure.\n"
           "set -eu\n"
           "plan="
        + shellWord(script.plan) + "\nsummary=" + shellWord(script.summary)
        + "\nDYNCAL=${DYNCAL:-dyncal}\n"
          "export DYNCAL plan summary\n"
          "shards=$(sbatch ${SBATCH_OPTIONS:-} --parsable --export=ALL --array=1-"
        + std::to_string(script.shards) + " --cpus-per-task=" + std::to_string(script.jobs)
        + " \\\n    --job-name=dyncal-batch --output=/dev/null <<'JOB'\n"
          "#!/bin/sh\n"
          "exec \"$DYNCAL\" "
        + runOf(script, "\"$plan\"", "\"$SLURM_ARRAY_TASK_ID\"")
        + "\nJOB\n)\n"
          "sbatch ${SBATCH_OPTIONS:-} --parsable --export=ALL --dependency=\"afterany:${shards%%;*}\" \\\n"
          "    --job-name=dyncal-merge --output=\"$summary.log\" <<'JOB'\n"
          "#!/bin/sh\n"
          "exec \"$DYNCAL\" batch merge \"$plan\" --partial -o \"$summary\"\n"
          "JOB\n";
}

std::string parallelScript(const BatchScript &script)
{
    return "#!/bin/sh\n"
           "# Runs the batch with GNU parallel, one shard on each processor, and merges. Run it again\n"
           "# after failures: only what is missing is computed. Options for parallel (--sshlogin) may\n"
           "# be given in PARALLEL_OPTIONS.\n"
           "plan="
        + shellWord(script.plan) + "\nsummary=" + shellWord(script.summary)
        + "\nDYNCAL=${DYNCAL:-dyncal}\n"
          "export DYNCAL plan summary\n"
          "seq "
        + std::to_string(script.shards) + " | parallel ${PARALLEL_OPTIONS:-} '\"$DYNCAL\" "
        + runOf(script, "\"$plan\"", "{}")
        + "'\n"
          "exec \"$DYNCAL\" batch merge \"$plan\" --partial -o \"$summary\"\n";
}

std::string makeScript(const BatchScript &script)
{
    std::string targets;
    for (std::size_t shard = 1; shard <= script.shards; ++shard)
        targets += " shard-" + std::to_string(shard);
    return "# Runs the batch with make -j N -f FILE, N shards at a time, and merges. Run it again\n"
           "# after failures: only what is missing is computed.\n"
           "DYNCAL ?= dyncal\n"
           "summary:"
        + targets + "\n\t$(DYNCAL) batch merge " + makeWord(script.plan) + " --partial -o "
        + makeWord(script.summary) + "\n" + targets.substr(1) + ": shard-%:\n\t-$(DYNCAL) "
        + runOf(script, makeWord(script.plan), "$*") + "\n.PHONY: summary" + targets + "\n";
}

} // namespace

Result<BatchRunner> batchRunner(const std::string &name)
{
    if (name == "slurm")
        return BatchRunner::Slurm;
    if (name == "parallel")
        return BatchRunner::Parallel;
    if (name == "make")
        return BatchRunner::Make;
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "--for is \"%1\"; it needs slurm, parallel or make."), {name}});
}

std::size_t usualShards(std::size_t sensors)
{
    const std::size_t wanted = (sensors + kSensorsOfShard - 1) / kSensorsOfShard;
    return std::clamp(wanted, std::size_t(1), kMostShardsOfScript);
}

Result<std::string> batchScript(const BatchScript &script)
{
    for (const std::string &path : {script.plan, script.summary})
        if (path.find('\n') != std::string::npos)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "The name %1 holds a line break, which a script cannot pass on; rename it."),
                    {path}});
    switch (script.runner) {
    case BatchRunner::Slurm:
        return slurmScript(script);
    case BatchRunner::Parallel:
        return parallelScript(script);
    case BatchRunner::Make:
        break;
    }
    return makeScript(script);
}

} // namespace dyncal

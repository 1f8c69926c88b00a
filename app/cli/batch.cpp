// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"
#include "app/cli/batch_run.h"
#include "app/cli/console.h"
#include "app/cli/recipe_options.h"
#include "app/cli/spoken.h"
#include "app/cli/verbs.h"

#include "core/base/allowed_threads.h"
#include "core/base/foreign_text.h"
#include "core/batch/batch_files.h"
#include "core/batch/batch_planning.h"
#include "core/batch/batch_script.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

/// Options of all parts; each declares those it has.
struct BatchOptions
{
    std::string root;
    RecipeOptions recipe;
    bool eachFile = false;
    std::string plan;
    std::string output;
    std::string shard;
    unsigned jobs = allowedThreads();
    bool json = false;
    bool partial = false;
    std::string runner;
    std::size_t shards = 0; ///< 0: usualShards()
};

constexpr unsigned kMostJobs = 1024;

/// Blocked: something is blocked, failed or missing.
int exitCodeOf(const BatchTally &tally)
{
    using enum SensorState;
    if (tally.count(Blocked) + tally.count(Failed) + tally.count(Missing) > 0)
        return static_cast<int>(ExitCode::Blocked);
    return static_cast<int>(
        tally.count(Cautions) > 0 ? ExitCode::DoneWithCautions : ExitCode::Done);
}

std::vector<SensorStanding> inTheLanguageAsked(std::vector<SensorStanding> standings)
{
    for (SensorStanding &standing : standings)
        standing.record.reason = spoken(standing.record.said, standing.record.reason);
    return standings;
}

/// Sentences about sensors: those that have a reason.
void printReasons(std::ostream &out, const std::vector<SensorStanding> &standings)
{
    for (const SensorStanding &standing : standings)
        if (!standing.record.reason.empty())
            out << presentableInBrief(standing.id) << ": " << sensorStateName(standing.record.state)
                << ": " << presentable(spoken(standing.record.said, standing.record.reason))
                << '\n';
}

int planIt(const BatchOptions &options)
{
    ProgressLine progress("Planning");
    const Result<BatchPlan> plan
        = planBatch({options.root, options.recipe.recipe, options.recipe.profile, options.eachFile,
                        options.output},
            {interruptToken(), progress.sink()});
    if (!plan)
        return report(plan.error());
    if (const Result<void> written = writePlanFile(options.output, *plan); !written)
        return report(written.error());
    std::size_t planned = 0;
    for (const PlannedSensor &sensor : *plan) {
        planned += sensor.obstacle.empty() ? 1 : 0;
        if (!sensor.obstacle.empty())
            std::cerr << presentableInBrief(sensor.id) << ": "
                      << presentable(spoken(sensor.said, sensor.obstacle)) << '\n';
    }
    std::cout << planned << " of " << plan->size() << " sensors planned\nWritten:\n  "
              << presentable(options.output) << '\n';
    return static_cast<int>(planned == plan->size() ? ExitCode::Done : ExitCode::Blocked);
}

int runIt(const BatchOptions &options)
{
    const Result<BatchShard> shard = parseShard(options.shard);
    if (!shard)
        return report(shard.error());
    Result<BatchPlan> plan = readPlan(options.plan);
    if (!plan)
        return report(plan.error());
    const Result<BatchOutcome> done
        = runBatch({folderOfPlan(options.plan), std::move(*plan), *shard, options.jobs});
    if (!done)
        return report(done.error());
    std::cout << tallyText(done->tally) << '\n'
              << "Computed " << done->computed << ", kept " << done->kept << '\n';
    return exitCodeOf(done->tally);
}

int showStatus(const BatchOptions &options)
{
    const Result<BatchPlan> plan = readPlan(options.plan);
    if (!plan)
        return report(plan.error());
    const std::vector<SensorStanding> standings = standingsOf(folderOfPlan(options.plan), *plan);
    if (options.json) {
        std::cout << statusJson(inTheLanguageAsked(standings));
    } else {
        std::cout << tallyText(tallyOf(standings)) << '\n';
        printReasons(std::cout, standings);
    }
    return static_cast<int>(ExitCode::Done);
}

int mergeIt(const BatchOptions &options)
{
    const Result<BatchTally> tally = mergeBatch(options.plan, options.output, options.partial);
    if (!tally)
        return report(tally.error());
    std::cout << tallyText(*tally) << "\nWritten:\n  " << presentable(options.output) << '\n';
    return exitCodeOf(*tally);
}

std::string absolutePath(const std::string &path)
{
    std::error_code ignored;
    return std::filesystem::absolute(path, ignored).lexically_normal().string();
}

int printScript(const BatchOptions &options)
{
    const Result<BatchRunner> runner = batchRunner(options.runner);
    if (!runner)
        return report(runner.error());
    const Result<BatchPlan> plan = readPlan(options.plan);
    if (!plan)
        return report(plan.error());
    const std::string path = absolutePath(options.plan);
    const std::string summary = std::filesystem::path(path).replace_extension("csv").string();
    const Result<std::string> script = batchScript({*runner, path, summary,
        options.shards > 0 ? options.shards : usualShards(plan->size()), options.jobs});
    if (!script)
        return report(script.error());
    std::cout << *script;
    return static_cast<int>(ExitCode::Done);
}

using Declare = std::shared_ptr<BatchOptions>;

CLI::App *addPart(CLI::App &batch, VerbAction &action, const Declare &options,
    const std::string &name, const std::string &help, int (*act)(const BatchOptions &))
{
    CLI::App *part = batch.add_subcommand(name, help);
    part->callback([options, act, &action] { action = [options, act] { return act(*options); }; });
    return part;
}

void declarePlan(CLI::App &part, const Declare &options)
{
    part.add_option("plan", options->plan, "Plan made by dyncal batch plan")
        ->required()
        ->type_name("PLAN");
}

void declareJobs(CLI::App &part, const Declare &options)
{
    part.add_option("--jobs", options->jobs, "Sensors computed at a time, each on one processor")
        ->check(CLI::Range(1U, kMostJobs))
        ->type_name("J");
}

void addPlanning(CLI::App &batch, VerbAction &action)
{
    const auto options = std::make_shared<BatchOptions>();
    CLI::App *part
        = addPart(batch, action, options, "plan", "List the sensors below a folder", planIt);
    part->add_option("root", options->root, "Folder with a folder of recordings for each sensor")
        ->required()
        ->type_name("ROOT");
    options->recipe.declare(*part);
    part->add_flag("--each-file", options->eachFile, "Every recording is a sensor of its own");
    part->add_option("-o,--output", options->output, "Plan to write; results go beside it")
        ->required()
        ->type_name("PLAN");
    part->footer("Example:\n  dyncal batch plan recordings --recipe recipe.json -o night.jsonl");
}

void addRunning(CLI::App &batch, VerbAction &action)
{
    const auto options = std::make_shared<BatchOptions>();
    CLI::App *part
        = addPart(batch, action, options, "run", "Calibrate what is not complete yet", runIt);
    declarePlan(*part, options);
    part->add_option("--shard", options->shard, "Only the K-th of N parts")->type_name("K/N");
    declareJobs(*part, options);
    part->footer("Example:\n  dyncal batch run night.jsonl --jobs 2\n"
                 "  dyncal batch run night.jsonl --shard 3/7");
}

void addStatus(CLI::App &batch, VerbAction &action)
{
    const auto options = std::make_shared<BatchOptions>();
    CLI::App *part
        = addPart(batch, action, options, "status", "Say how far the batch is", showStatus);
    declarePlan(*part, options);
    part->add_flag("--json", options->json, "As JSON");
    part->footer("Example:\n  dyncal batch status night.jsonl");
}

void addMerging(CLI::App &batch, VerbAction &action)
{
    const auto options = std::make_shared<BatchOptions>();
    CLI::App *part = addPart(
        batch, action, options, "merge", "Write the summary, one row for each sensor", mergeIt);
    declarePlan(*part, options);
    part->add_option("-o,--output", options->output, "Summary to write")
        ->required()
        ->type_name("SUMMARY");
    part->add_flag("--partial", options->partial, "Also if sensors are missing");
    part->footer("Example:\n  dyncal batch merge night.jsonl -o night.csv");
}

void addScript(CLI::App &batch, VerbAction &action)
{
    const auto options = std::make_shared<BatchOptions>();
    options->jobs = 1;
    CLI::App *part = addPart(batch, action, options, "script",
        "Print a job for a cluster or several machines", printScript);
    declarePlan(*part, options);
    part->add_option("--for", options->runner, "What runs it: slurm, parallel or make")
        ->required()
        ->type_name("RUNNER");
    part->add_option("--shards", options->shards, "Parts of the batch")
        ->check(CLI::Range(std::size_t(1), kMostShardsOfScript))
        ->type_name("N");
    declareJobs(*part, options);
    part->footer("Example:\n  dyncal batch script night.jsonl --for slurm > night.sh");
}

} // namespace

void addBatch(CLI::App &program, VerbAction &action)
{
    CLI::App *batch
        = program.add_subcommand("batch", "Calibrate many sensors: plan, run, status, merge");
    batch->require_subcommand(1);
    addPlanning(*batch, action);
    addRunning(*batch, action);
    addStatus(*batch, action);
    addMerging(*batch, action);
    addScript(*batch, action);
    batch->footer("Example:\n  dyncal batch plan recordings --recipe recipe.json -o night.jsonl\n"
                  "  dyncal batch run night.jsonl\n  dyncal batch merge night.jsonl -o night.csv");
}

} // namespace dyncal

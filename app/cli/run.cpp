// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/console.h"
#include "app/cli/interrupt.h"
#include "app/cli/recipe_options.h"
#include "app/cli/run_output.h"
#include "app/cli/run_summary.h"
#include "app/cli/verbs.h"
#include "app/clock.h"

#include "core/base/number_text.h"
#include "core/capture/format_registry.h"

#include <algorithm>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

struct RunOptions
{
    std::vector<std::string> files;
    RecipeOptions recipe;
    std::string order;
    std::string output;
};

/// The recipe with --order put in; checked as if it had been written there.
Result<Recipe> withOrder(Recipe recipe, const std::string &order)
{
    if (order.empty())
        return recipe;
    recipe.realization.order = {};
    if (order == "auto")
        return recipe;
    const std::optional<double> value = parseNumber(order);
    constexpr double kReadable = 1e6;
    if (!value || !(*value >= 1.0 && *value <= kReadable)
        || static_cast<double>(static_cast<Index>(*value)) != *value)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core", "--order is \"%1\"; it needs \"auto\" or a whole number from 1."),
                {order}});
    recipe.realization.order = static_cast<Index>(*value);
    return parseRecipe(recipeJson(recipe));
}

Result<Recipe> recipeOf(const RunOptions &options)
{
    const Result<Recipe> recipe = options.recipe.read();
    return recipe ? withOrder(*recipe, options.order) : recipe;
}

/// Whether an error leaves results that are worth keeping: the data were at fault, not the call.
bool keepsResults(const Error &error)
{
    return error.kind == ErrorKind::DataBlocked;
}

PipelineOutcome compute(const Recipe &recipe, const CaptureSet &set)
{
    ProgressLine progress("Computing");
    ResultCache cache;
    return runPipeline(std::make_shared<CaptureSet>(set), recipe, cache, kLastStage,
        {interruptToken(), progress.sink()});
}

Result<CaptureSet> readFiles(const RunOptions &options, const Recipe &recipe)
{
    ProgressLine progress("Reading");
    return readCaptures(options.files, recipe.import, {interruptToken(), progress.sink()});
}

/// Whether a blocking finding has said already what stopped the run.
bool isSaid(const Error &error, const Findings &findings)
{
    return std::any_of(findings.begin(), findings.end(), [&](const Finding &finding) {
        return finding.severity == Severity::Block && finding.id == error.findingId
            && finding.shot == error.shot;
    });
}

/// Prints the answer and says how it went.
int conclude(
    const PipelineOutcome &outcome, const Recipe &recipe, const std::vector<std::string> &paths)
{
    std::cout << runSummary(outcome, recipe) << "Written:\n";
    for (const std::string &path : paths)
        std::cout << "  " << path << '\n';
    const Findings findings = outcome.results.findings();
    reportFindings(findings);
    if (outcome.error)
        return isSaid(*outcome.error, findings) ? static_cast<int>(exitCodeOf(*outcome.error))
                                                : report(*outcome.error);
    return static_cast<int>(exitCodeOf(findings));
}

int run(const RunOptions &options)
{
    const Result<std::string> created = currentUtc();
    if (!created)
        return report(created.error());
    const Result<Recipe> recipe = recipeOf(options);
    if (!recipe)
        return report(recipe.error());
    const Result<CaptureSet> set = readFiles(options, *recipe);
    if (!set)
        return report(set.error());
    if (const Result<void> made = makeFolder(options.output); !made)
        return report(made.error());
    const PipelineOutcome outcome = compute(*recipe, *set);
    if (outcome.error && !keepsResults(*outcome.error))
        return report(*outcome.error);
    const Result<std::vector<std::string>> paths
        = writeRun(outcome, *recipe, *created, options.output);
    if (!paths)
        return report(paths.error());
    return conclude(outcome, *recipe, *paths);
}

} // namespace

void addRun(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<RunOptions>();
    CLI::App *verb = program.add_subcommand(
        "run", "Calibrate: results.json, certificate.pdf, plots/ and csv/ from captures");
    verb->add_option("files", options->files, "Captures of one sensor, or folders of captures")
        ->required()
        ->type_name("FILE");
    options->recipe.declare(*verb);
    verb->add_option("--order", options->order, "Model order: auto or a number")
        ->type_name("auto|N");
    verb->add_option("-o,--output", options->output, "Folder to write to")
        ->required()
        ->type_name("DIR");
    verb->footer("Example:\n  dyncal run example.h5 -o out\n"
                 "  dyncal run low.lvm medium.lvm high.lvm --recipe recipe.json --order 4 -o out");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

} // namespace dyncal

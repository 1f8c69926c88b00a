// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/clock.h"
#include "app/cli/calibration.h"
#include "app/cli/calibration_run.h"
#include "app/cli/console.h"
#include "app/cli/recipe_options.h"
#include "app/cli/run_summary.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/project/template_choice.h"

#include <iostream>
#include <memory>

namespace dyncal {
namespace {

struct RunOptions
{
    std::vector<std::string> files;
    RecipeOptions recipe;
    std::string order;
    std::string templateName;
    std::string output;
};

Result<Recipe> recipeOf(const RunOptions &options)
{
    Result<Recipe> recipe = options.recipe.read();
    if (!recipe)
        return recipe;
    locateTemplate(options.recipe.recipe, *recipe);
    takeTemplate(options.templateName, *recipe);
    return withOrder(*recipe, options.order);
}

/// Prints the summary and the files written; the exit code.
int conclude(
    const PipelineOutcome &outcome, const Recipe &recipe, const std::vector<std::string> &paths)
{
    std::cout << runSummary(outcome, recipe) << "Written:\n";
    for (const std::string &path : paths)
        std::cout << "  " << presentable(path) << '\n';
    return reportOutcome(outcome);
}

int run(const RunOptions &options)
{
    const Result<std::string> created = currentUtc();
    if (!created)
        return report(created.error());
    const Result<Recipe> recipe = recipeOf(options);
    if (!recipe)
        return report(recipe.error());
    const Result<FinishedRun> done
        = calibrateInto({options.files, *recipe, options.recipe.files(), options.output, *created});
    return done ? conclude(done->outcome, *recipe, done->paths) : report(done.error());
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
    declareOrder(*verb, options->order);
    declareTemplate(*verb, options->templateName);
    verb->add_option("-o,--output", options->output, "Folder to write to")
        ->required()
        ->type_name("DIR");
    verb->footer("Example:\n  dyncal run example.h5 -o out\n"
                 "  dyncal run low.lvm medium.lvm high.lvm --recipe recipe.json --order 4 -o out");
    verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

} // namespace dyncal

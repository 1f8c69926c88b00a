// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"
#include "app/cli/calibration.h"
#include "app/cli/console.h"
#include "app/cli/project_job.h"
#include "app/cli/recipe_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/results/model_export.h"
#include "core/results/publication.h"
#include "core/results/run_files.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

struct ExportOptions
{
    std::vector<std::string> files;
    RecipeOptions recipe;
    std::string order;
    std::vector<std::string> what{"model"};
    std::vector<std::string> formats = modelFormats();
    std::string output;
};

bool isProject(const std::vector<std::string> &files)
{
    return files.size() == 1 && std::filesystem::path(files.front()).extension() == ".dyncal";
}

/// A project brings its own recipe; recordings take that of --recipe.
Result<ProjectState> readJob(const ExportOptions &options)
{
    if (isProject(options.files)) {
        if (!options.recipe.files().empty())
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "%1 is a project and brings its own recipe, so --recipe and --profile (%2) would change nothing; leave them out, or export from the recordings."),
                    {options.files.front(), options.recipe.files().front()}});
        return readProjectJob(options.files.front());
    }
    ProjectState state;
    Result<Recipe> recipe = options.recipe.read();
    if (!recipe)
        return tl::unexpected<Error>(recipe.error());
    Result<CaptureSet> set = readForCalibration(options.files, *recipe);
    if (!set)
        return tl::unexpected<Error>(set.error());
    state.captures = std::make_shared<const CaptureSet>(std::move(*set));
    state.recipe = std::move(*recipe);
    return state;
}

/// The files read besides the recordings: they must not be overwritten.
std::vector<std::string> readBeside(const ExportOptions &options)
{
    std::vector<std::string> files = options.recipe.files();
    if (isProject(options.files))
        files.push_back(options.files.front());
    return files;
}

int reportBlocked(const PipelineOutcome &outcome)
{
    const int code = reportOutcome(outcome);
    std::cerr << "No model was written.\n";
    return code;
}

int exportJob(const ExportOptions &options)
{
    const Result<ProjectState> job = readJob(options);
    if (!job)
        return report(job.error());
    const Result<Recipe> recipe = withOrder(job->recipe, options.order);
    if (!recipe)
        return report(recipe.error());
    Result<FolderWrite> folder
        = FolderWrite::begin(modelFolder(options.output, *job->captures, readBeside(options)));
    if (!folder)
        return report(folder.error());
    const PipelineOutcome outcome = calibrate(*job->captures, *recipe, StageId::Uncertainty);
    if (outcome.error && outcome.error->kind == ErrorKind::FileUnreadable)
        return report(*outcome.error);
    if (!mayPublish(outcome))
        return reportBlocked(outcome);
    const auto paths
        = writeModelFiles(outcome.results, options.formats, *folder, {interruptToken(), {}});
    if (!paths)
        return report(paths.error());
    for (const std::string &path : *paths)
        std::cout << presentable(path) << '\n';
    return reportOutcome(outcome);
}

} // namespace

void addExport(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<ExportOptions>();
    CLI::App *verb = program.add_subcommand(
        "export", "Write the model for use elsewhere: MAT, JSON, CSV, MATLAB and Python scripts");
    verb->add_option("files", options->files, "A project, or captures of one sensor")
        ->required()
        ->type_name("PROJECT|FILE");
    options->recipe.declare(*verb);
    declareOrder(*verb, options->order);
    verb->add_option("--what", options->what, "What to write")
        ->delimiter(',')
        ->check(CLI::IsMember({"model"}))
        ->type_name("model");
    verb->add_option("--format", options->formats, "All of them where none is named")
        ->delimiter(',')
        ->check(CLI::IsMember(modelFormats()))
        ->type_name("mat,json,csv,m,py");
    verb->add_option("-o,--output", options->output, "Folder to write to")
        ->required()
        ->type_name("DIR");
    verb->footer("Example:\n  dyncal export job.dyncal --what model -o out\n"
                 "  dyncal export example.h5 --order 3 --format mat,py -o out");
    verb->callback([options, &action] { action = [options] { return exportJob(*options); }; });
}

} // namespace dyncal

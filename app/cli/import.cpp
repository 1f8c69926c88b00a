// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/clock.h"
#include "app/base/interrupt.h"
#include "app/cli/capture_target.h"
#include "app/cli/console.h"
#include "app/cli/recipe_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/capture/capture_seal.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/capture/import_rules.h"
#include "core/capture/opening/capture_open.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

struct ImportOptions
{
    std::vector<std::string> files;
    RecipeOptions recipe;
    std::string output;
    bool replace = false;
};

/// Captures are written once: nothing that exists is replaced, least of all an input.
CaptureTarget target(const ImportOptions &options)
{
    return {options.output, options.replace};
}

Result<CaptureSet> readAndApply(const ImportOptions &options, const Recipe &recipe)
{
    ProgressLine progress("Reading");
    Result<CaptureSet> set
        = readCaptures(options.files, recipe.import, {interruptToken(), progress.sink()});
    if (!set)
        return set;
    Result<CaptureSet> applied = applyImportSettings(*set, recipe.import, recipe.checks);
    const Result<void> whole = checkStillWhole(*set); // else what is missing looks like gaps
    return whole ? applied : tl::unexpected<Error>(whole.error());
}

Result<void> write(const CaptureSet &set, const ImportOptions &options, const std::string &created)
{
    ProgressLine progress("Writing");
    const std::string title = std::filesystem::path(options.output).stem().string();
    return writeHdf5Capture(
        set, target(options), created, title, {}, {interruptToken(), progress.sink()});
}

std::vector<std::string> inputsOf(const ImportOptions &options)
{
    std::vector<std::string> inputs = options.recipe.files();
    inputs.insert(inputs.end(), options.files.begin(), options.files.end());
    return inputs;
}

int importFiles(const ImportOptions &options)
{
    const Result<std::string> created = currentUtc();
    if (!created)
        return report(created.error());
    const Result<Recipe> recipe = options.recipe.read();
    if (!recipe)
        return report(recipe.error());
    if (const Result<void> free = checkCaptureTarget(target(options), inputsOf(options)); !free)
        return report(free.error());
    const Result<CaptureSet> set = readAndApply(options, *recipe);
    if (!set)
        return report(set.error());
    if (worstSeverity(set->findings)
        == Severity::Block) { // a capture would give bad data valid hashes
        reportFindings(set->findings);
        std::cerr << "No capture was written.\n";
        return static_cast<int>(exitCodeOf(set->findings));
    }
    if (const Result<void> written = write(*set, options, *created); !written)
        return report(written.error());
    std::cout << "Wrote " << presentable(options.output) << ": " << set->shots.size()
              << (set->shots.size() == 1 ? " shot" : " shots") << " from " << set->inputs.size()
              << (set->inputs.size() == 1 ? " file\n" : " files\n");
    reportFindings(set->findings);
    return static_cast<int>(exitCodeOf(set->findings));
}

} // namespace

void addImport(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<ImportOptions>();
    CLI::App *verb = program.add_subcommand(
        "import", "Bring files of any readable format into one capture (.h5)");
    verb->add_option("files", options->files, "Recordings of one sensor, or folders of them")
        ->required()
        ->type_name("FILE");
    verb->add_option("-o,--output", options->output, "Capture to write (.h5)")
        ->required()
        ->type_name("CAPTURE");
    verb->add_flag("--replace", options->replace, "Replace a file of this name");
    options->recipe.declare(*verb);
    verb->footer(
        "The import section of the recipe is applied once, here: leave it out of the recipe of the run.\n\n"
        "Example:\n  dyncal import low.csv medium.csv high.csv -o shots.h5\n"
        "  dyncal import recordings/ --profile laboratory.json -o shots.h5");
    verb->callback([options, &action] { action = [options] { return importFiles(*options); }; });
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"
#include "app/cli/calibration.h"
#include "app/cli/console.h"
#include "app/cli/findings_json.h"
#include "app/cli/recipe_options.h"
#include "app/cli/verbs.h"

#include "core/base/json_text.h"
#include "core/capture/opening/capture_open.h"
#include "core/pipeline/pipeline.h"
#include "core/results/results_json.h"
#include "core/shock/reading_check.h"

#include <algorithm>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

using Json = nlohmann::json;

struct CheckOptions
{
    std::vector<std::string> files;
    RecipeOptions recipe;
    bool json = false;
};

Result<CaptureSet> readFiles(const CheckOptions &options, const Recipe &recipe)
{
    ProgressLine progress("Reading");
    return readCaptures(options.files, recipe.import, {interruptToken(), progress.sink()});
}

/// Findings of the shock relations, from the arrivals read from the records: no model is computed.
Findings shockFindings(const CalibrationResults &results, const Recipe &recipe)
{
    if (!recipe.shock.enabled || !results.window)
        return {};
    const ShockConditionsSet &shock = results.expected->conditions;
    Findings findings = shock.findings;
    const Findings misread = checkReadings(results.window->responses, shock, recipe.checks);
    findings.insert(findings.end(), misread.begin(), misread.end());
    return findings;
}

/// The gravest first; shot by shot within one severity.
void sort(Findings &findings)
{
    std::stable_sort(findings.begin(), findings.end(), [](const Finding &a, const Finding &b) {
        return a.severity != b.severity ? a.severity > b.severity : a.shot < b.shot;
    });
}

void print(const Findings &findings, std::size_t shots)
{
    for (const Finding &finding : findings)
        std::cout << lineOf(finding) << '\n';
    const auto count = [&](Severity severity) {
        return std::count_if(findings.begin(), findings.end(),
            [&](const Finding &finding) { return finding.severity == severity; });
    };
    std::cout << "Shots " << shots << ": blocking " << count(Severity::Block) << ", cautions "
              << count(Severity::Caution) << ", infos " << count(Severity::Info) << ".\n";
}

Json checkJson(const CaptureSet &set, const Findings &findings)
{
    Json files = Json::array();
    for (const InputFile &input : set.inputs)
        files.push_back({{"file", input.file}, {"format", input.format}, {"sha256", input.sha256}});
    return {{"schema", "dyncal-check/1"}, {"files", std::move(files)}, {"shots", set.shots.size()},
        {"findings", findingsJson(findings)}};
}

PipelineOutcome cut(const CaptureSet &set, const Recipe &recipe)
{
    ProgressLine progress("Checking");
    ResultCache cache;
    return ofWholeRecordings(runPipeline(std::make_shared<CaptureSet>(set), recipe, cache,
                                 StageId::Window, {interruptToken(), progress.sink()}),
        set);
}

int check(const CheckOptions &options)
{
    const Result<Recipe> recipe = options.recipe.read();
    if (!recipe)
        return report(recipe.error());
    const Result<CaptureSet> set = readFiles(options, *recipe);
    if (!set)
        return report(set.error());
    const PipelineOutcome outcome = cut(*set, *recipe);
    if (outcome.error && outcome.error->kind != ErrorKind::DataBlocked)
        return report(*outcome.error);
    Findings findings = allFindings(outcome);
    const Findings ofShock = shockFindings(outcome.results, *recipe);
    findings.insert(findings.end(), ofShock.begin(), ofShock.end());
    sort(findings);
    if (options.json)
        std::cout << jsonText(checkJson(*set, findings));
    else
        print(findings, set->shots.size());
    if (outcome.error && outcome.error->findingId.empty())
        return report(*outcome.error); // not among the findings
    return static_cast<int>(exitCodeOf(findings));
}

} // namespace

void addCheck(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<CheckOptions>();
    CLI::App *verb = program.add_subcommand(
        "check", "Say what is wrong with recordings, without calibrating from them");
    verb->add_option("files", options->files, "Captures of one sensor, or folders of captures")
        ->required()
        ->type_name("FILE");
    options->recipe.declare(*verb);
    verb->add_flag("--json", options->json, "As JSON");
    verb->footer("Example:\n  dyncal check shots/\n"
                 "  dyncal check low.csv high.csv --recipe recipe.json --json");
    verb->callback([options, &action] { action = [options] { return check(*options); }; });
}

} // namespace dyncal

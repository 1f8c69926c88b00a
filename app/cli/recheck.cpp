// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"
#include "app/cli/calibration.h"
#include "app/cli/console.h"
#include "app/cli/recheck_text.h"
#include "app/cli/verbs.h"

#include "core/recheck/named_recordings.h"
#include "core/recheck/recording_search.h"
#include "core/results/results_json.h"
#include "core/results/results_reading.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

namespace dyncal {
namespace {

struct RecheckOptions
{
    std::vector<std::string> folders;
    std::vector<std::string> recordings;
    bool json = false;
};

bool isOfData(const Error &error)
{
    return error.kind != ErrorKind::Cancelled && error.kind != ErrorKind::Internal;
}

/// The error with the run that it concerns.
tl::unexpected<Error> notComputed(const EarlierRun &run, const Error &error)
{
    if (!isOfData(error))
        return tl::unexpected<Error>(error);
    return fail(error.kind,
        {DYNCAL_TEXT("core", "The run in %1 cannot be computed again: %2"),
            {run.folder, english(error.message)}},
        error.findingId);
}

/// The results that this program makes up to a stage, as it would write them.
Result<nlohmann::json> resultsNow(
    const CaptureSet &set, const EarlierRun &run, StageId last, ResultCache &cache)
{
    const PipelineOutcome outcome = calibrate(set, run.recipe, last, cache);
    if (outcome.error && outcome.error->kind != ErrorKind::DataBlocked)
        return notComputed(run, *outcome.error);
    const std::string created = textAt(run.results, "created_utc");
    return nlohmann::json::parse(resultsJson(outcome, run.recipe, created));
}

/// Whether a reader has refused what a file of the same bytes holds: that is no file that cannot be
/// read, but one that allows no result today.
bool isRefusal(const Error &error)
{
    return isOfData(error) && error.findingId != "CAP-018" && error.findingId != "CAP-015";
}

std::string refusalText(const Error &error)
{
    const std::string id = error.findingId.empty() ? std::string() : error.findingId + ": ";
    return id + english(error.message);
}

/// A file that changed since it was found is none of the run's.
Result<CaptureSet> recordingsOf(const EarlierRun &run, const NamedRecordings &recordings)
{
    Result<CaptureSet> set = readForCalibration(recordings.paths(), run.recipe);
    const auto isTheSame = [](const InputFile &read, const RecordedInput &needed) {
        return read.sha256 == needed.sha256;
    };
    if (!set || std::ranges::equal(set->inputs, run.inputs, isTheSame))
        return set;
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The recordings of the results in %1 changed while they were read; repeat it when nothing writes to them."),
            {run.folder}},
        "CAP-015");
}

/// Of the Monte Carlos nothing is compared but their findings: where all that they are drawn from
/// is as issued, to the last bit and by the same methods, these are, too.
Result<RecheckedRun> computedAgain(const CaptureSet &set, const EarlierRun &run)
{
    ResultCache cache;
    const auto early
        = resultsNow(set, run, StageId::Evidence, cache).map([&](const nlohmann::json &now) {
              return recheckedRun(run, now, {}, RecheckDepth::ToEvidence);
          });
    if (!early || early->isAsIssued())
        return early;
    return resultsNow(set, run, kLastStage, cache).map([&](const nlohmann::json &now) {
        return recheckedRun(run, now);
    });
}

Result<RecheckedRun> recheckRun(const EarlierRun &run, const std::vector<std::string> &paths)
{
    const Result<NamedRecordings> recordings = NamedRecordings::of(run.inputs, paths);
    if (!recordings)
        return tl::unexpected<Error>(recordings.error());
    const Result<CaptureSet> set = recordingsOf(run, *recordings);
    if (!set && isRefusal(set.error()))
        return recheckedRun(run, {}, refusalText(set.error()));
    if (!set)
        return tl::unexpected<Error>(set.error());
    return computedAgain(*set, run);
}

Result<RecheckedRun> recheckFolder(const std::string &folder, RecordingSearch &search)
{
    const Result<EarlierRun> run = readEarlierRun(folder);
    if (!run)
        return tl::unexpected<Error>(run.error());
    const auto paths = search.find(*run, {interruptToken(), {}});
    return paths ? recheckRun(*run, *paths) : tl::unexpected<Error>(paths.error());
}

/// What is given and is no folder of results has its answer already.
struct FoldersToRecheck
{
    std::vector<std::string> folders; ///< each once
    std::vector<RecheckAnswer> refused;
};

FoldersToRecheck foldersToRecheck(const std::vector<std::string> &given)
{
    FoldersToRecheck all;
    std::set<std::filesystem::path> known;
    std::error_code unknown;
    for (const std::string &folder : given) {
        const auto found = runFoldersBelow(folder);
        if (!found)
            all.refused.push_back({folder, tl::unexpected<Error>(found.error())});
        for (const std::string &one : found ? *found : std::vector<std::string>())
            if (known.insert(std::filesystem::weakly_canonical(one, unknown)).second)
                all.folders.push_back(one);
    }
    return all;
}

void tellUnreadable(const Error &error)
{
    report(error);
    for (const Error &further : error.further)
        report(further);
}

ExitCode exitCodeOf(const std::vector<RecheckAnswer> &answers)
{
    const bool isUnread
        = std::ranges::any_of(answers, [](const auto &answer) { return !answer.run; });
    const bool isOver = std::ranges::any_of(
        answers, [](const auto &answer) { return answer.run && answer.run->hasDifferences(); });
    return isUnread ? ExitCode::FileUnreadable
        : isOver    ? ExitCode::DoneWithCautions
                    : ExitCode::Done;
}

int concludeRecheck(const std::vector<RecheckAnswer> &answers, bool json)
{
    std::cout << (json ? recheckJson(answers) : recheckText(answers));
    for (const RecheckAnswer &answer : answers)
        if (!answer.run)
            tellUnreadable(answer.run.error());
    return static_cast<int>(exitCodeOf(answers));
}

int recheck(const RecheckOptions &options)
{
    Result<RecordingSearch> search = RecordingSearch::in(options.recordings);
    if (!search)
        return report(search.error());
    auto [folders, answers] = foldersToRecheck(options.folders);
    for (const std::string &folder : folders) {
        answers.push_back({folder, recheckFolder(folder, *search)});
        const auto &run = answers.back().run;
        if (!run && !isOfData(run.error()))
            return report(run.error());
    }
    return concludeRecheck(answers, options.json);
}

} // namespace

void addRecheck(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<RecheckOptions>();
    CLI::App *verb = program.add_subcommand(
        "recheck", "Compute earlier results again and list what differs by more than its U");
    verb->add_option("folders", options->folders, "Folders of dyncal run, or above such")
        ->required()
        ->type_name("FOLDER");
    verb->add_option("--recordings", options->recordings,
            "Where the recordings are, by content; without it beside the results")
        ->type_name("DIR");
    verb->add_flag("--json", options->json, "As JSON");
    verb->footer(
        "Exit codes: 0 no difference over U, 1 some, 3 a folder or recording cannot be read.\n\n"
        "Example:\n  dyncal recheck out\n"
        "  dyncal recheck results/2025 results/2026 --recordings archive --json");
    verb->callback([options, &action] { action = [options] { return recheck(*options); }; });
}

} // namespace dyncal

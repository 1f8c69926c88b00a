// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/correction/correction_task.h"

#include "core/capture/opening/capture_open.h"
#include "core/pipeline/early_stages.h"
#include "core/results/publication.h"
#include "core/results/results_json.h"
#include "ui/text/shown_text.h"

namespace dyncal {

namespace {

constexpr double kReadingShare = 0.3; ///< of the progress

std::vector<std::string> pathsOf(const QStringList &paths)
{
    std::vector<std::string> all;
    for (const QString &path : paths)
        all.push_back(path.toStdString());
    return all;
}

tl::unexpected<Error> missing(const char *sentence)
{
    return fail(ErrorKind::Usage, {sentence, {}});
}

Result<std::optional<Interval>> intervalOf(const TypedStretch &typed)
{
    if (!typed.begin_s && !typed.end_s)
        return std::optional<Interval>();
    if (typed.begin_s && typed.end_s && *typed.begin_s < *typed.end_s)
        return std::optional(Interval{*typed.begin_s, *typed.end_s});
    return missing(DYNCAL_TEXT("core",
        "A stretch of the recording needs a begin and, behind it, an end; type both or neither."));
}

Result<RecordOptions> recordOptionsOf(const CorrectionChoice &choice)
{
    const auto window = intervalOf(choice.window);
    const auto quiet = intervalOf(choice.quiet);
    if (!window || !quiet)
        return tl::unexpected<Error>(window ? quiet.error() : window.error());
    return RecordOptions{*window, *quiet, choice.beyond_Pa};
}

Result<CalibrationSource> sourceOf(const CorrectionTask &task)
{
    if (!task.run)
        return calibrationAt(task.results);
    if (const std::optional<Error> obstacle = publicationObstacle(task.run->outcome))
        return tl::unexpected<Error>(*obstacle);
    return calibrationOf(
        resultsJson(task.run->outcome, task.run->recipe, task.run->createdUtc), "results.json");
}

} // namespace

Recipe readingRecipe(const CorrectionChoice &choice, const Recipe &project)
{
    Recipe recipe;
    if (choice.isReadAsProject) {
        recipe.import = project.import;
        recipe.checks = project.checks;
    }
    if (!choice.channel.isEmpty())
        recipe.import.channels[choice.channel.toStdString()] = channelRoleName(ChannelRole::Dut);
    return recipe;
}

Result<CorrectionTask> taskOf(const CorrectionChoice &choice, const Recipe &project)
{
    if (!choice.isOfProject && choice.results.isEmpty())
        return missing(DYNCAL_TEXT("core",
            "No calibration is chosen; choose the results.json of the sensor, or take the open project."));
    if (choice.recordings.isEmpty())
        return missing(
            DYNCAL_TEXT("core", "No recording is chosen; choose those that are to be corrected."));
    return recordOptionsOf(choice).map([&](const RecordOptions &record) {
        return CorrectionTask{choice.isOfProject ? std::string() : choice.results.toStdString(),
            std::nullopt, pathsOf(choice.recordings), readingRecipe(choice, project), choice.filter,
            record};
    });
}

Result<QStringList> channelsOf(const std::vector<std::string> &recordings,
    const ImportSettings &settings, const JobControl &control)
{
    return openCaptures(recordings, settings, control).map([](const CaptureSet &set) {
        QStringList names;
        for (const Shot &shot : set.shots)
            for (const Channel &channel : shot.channels)
                if (const QString name = rawText(channel.name); !names.contains(name))
                    names << name;
        return names;
    });
}

Result<CorrectionReport> correctionReport(const CorrectionTask &task, const JobControl &control)
{
    const Result<CalibrationSource> source = sourceOf(task);
    if (!source)
        return tl::unexpected<Error>(source.error());
    const Result<PreparedCaptures> prepared
        = readCaptures(task.recordings, task.recipe.import, control.between(0.0, kReadingShare))
              .and_then([&](const CaptureSet &set) { return prepareCaptures(set, task.recipe); });
    if (!prepared)
        return tl::unexpected<Error>(prepared.error());
    CorrectionReport report{
        prepared->findings, std::make_shared<const CaptureSet>(prepared->set), nullptr};
    if (!areCorrectable(report.findings, *report.captures))
        return report;
    return correctRecordings(
        *source, *report.captures, task.filter, task.record, control.between(kReadingShare, 1.0))
        .map([&](CorrectionOutcome outcome) {
            for (const Finding &finding : findingsOf(outcome))
                report.findings.push_back(finding);
            report.outcome = std::make_shared<const CorrectionOutcome>(std::move(outcome));
            return report;
        });
}

} // namespace dyncal

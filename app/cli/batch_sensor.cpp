// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/batch_sensor.h"

#include "app/base/clock.h"
#include "app/cli/calibration_run.h"
#include "app/cli/console.h"

#include "core/base/allowed_threads.h"
#include "core/base/json_text.h"
#include "core/batch/planned_inputs.h"
#include "core/batch/sensor_place.h"

#include <fcntl.h>
#include <unistd.h>

#include <string_view>

namespace dyncal {
namespace {

constexpr std::string_view kHows = "CKBSF"; ///< in the order of SensorAnswer::How

std::vector<std::string> settingsOf(const PlannedSensor &sensor)
{
    std::vector<std::string> settings;
    for (const std::string &path : {sensor.recipe, sensor.profile})
        if (!path.empty())
            settings.push_back(path);
    return settings;
}

/// Calibrates as `dyncal run SOURCE --recipe RECIPE --profile PROFILE` in the plan's folder would.
Result<void> calibrateSensor(
    const PlannedSensor &sensor, const std::vector<std::string> &paths, const Recipe &recipe)
{
    const Result<std::string> created = currentUtc();
    if (!created)
        return tl::unexpected<Error>(created.error());
    std::vector<InputStamp> stamps;
    const auto accept = [&](const CaptureSet &set) {
        return checkReadInputs(set, paths, sensor).map([&](std::vector<InputStamp> read) {
            stamps = std::move(read);
        });
    };
    const auto record = [&](const PipelineOutcome &outcome) {
        SensorOutcome made = recordOf(outcome, sensorKey(sensor));
        made.stamps = stamps;
        return recordText(made);
    };
    return calibrateInto({{sensor.source}, recipe, settingsOf(sensor),
                             sensor.output + '/' + kCalibrationFolder, *created, accept, record})
        .map([](const FinishedRun &) {});
}

KeptMessage setAsideMessage(const std::string &name)
{
    if (name.empty())
        return {};
    return keptMessage(
        {DYNCAL_TEXT("core",
             "The results were not as they were written and are now in %1; they are computed anew."),
            {name}});
}

Result<SensorAnswer> broughtUpToPlan(const PlannedSensor &sensor)
{
    const Result<std::vector<std::string>> paths = plannedPaths(".", sensor);
    if (!paths)
        return tl::unexpected<Error>(paths.error());
    const Result<Recipe> recipe = plannedRecipe(sensor);
    if (!recipe)
        return tl::unexpected<Error>(recipe.error());
    const Result<std::string> aside = setDamagedAside(sensor.output);
    if (!aside)
        return tl::unexpected<Error>(aside.error());
    const auto results = plannedResults(".", sensor);
    const Result<void> done = results ? checkKnownInputs(results->stamps, *paths, sensor)
                                      : calibrateSensor(sensor, *paths, *recipe);
    if (!done)
        return tl::unexpected<Error>(done.error());
    return SensorAnswer{
        results ? SensorAnswer::Kept : SensorAnswer::Computed, setAsideMessage(*aside)};
}

SensorAnswer ofError(const Error &error, const PlannedSensor &sensor)
{
    if (error.kind == ErrorKind::Cancelled)
        return {SensorAnswer::Stopped, {}};
    if (error.kind == ErrorKind::Usage && isBeingComputed(sensor.output))
        return {SensorAnswer::Busy, keptMessage(error.message)};
    return {SensorAnswer::Failed,
        error.findingId.empty() ? keptMessage(error.message)
                                : keptMessage({"%1: %M1", {error.findingId}, {error.message}})};
}

/// Neither progress nor findings of one among many; what failed is told by the parent.
void silence()
{
    if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0)
        ::dup2(nowhere, STDERR_FILENO);
}

ChildAnswer childAnswer(const SensorAnswer &answer)
{
    return {0, kHows[static_cast<std::size_t>(answer.how)] + jsonLine(messageJson(answer.said))};
}

} // namespace

ChildAnswer computeSensor(const PlannedSensor &sensor, const std::string &planFolder)
{
    silence();
    useOneThread();
    if (::chdir(planFolder.c_str()) != 0)
        return childAnswer({SensorAnswer::Failed,
            keptMessage(
                {DYNCAL_TEXT("core", "The folder %1 cannot be entered; check that you may."),
                    {planFolder}})});
    const Result<SensorAnswer> answer = broughtUpToPlan(sensor);
    return childAnswer(answer ? *answer : ofError(answer.error(), sensor));
}

SensorAnswer parseAnswer(const std::string &answer)
{
    const std::size_t how = answer.empty() ? kHows.npos : kHows.find(answer.front());
    try {
        if (how != kHows.npos)
            return {static_cast<SensorAnswer::How>(how),
                messageOfJson(nlohmann::json::parse(answer.substr(1)))};
    } catch (const nlohmann::json::exception &) { // cut off: no answer
    }
    return {SensorAnswer::Failed,
        keptMessage(
            {DYNCAL_TEXT("core", "Its process ended without an answer (%1); run the batch again."),
                {answer}})};
}

} // namespace dyncal

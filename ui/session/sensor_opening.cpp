// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/sensor_opening.h"

#include "core/batch/planned_inputs.h"
#include "core/batch/sensor_place.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {

namespace {

/// The sensor with the paths of its settings as this program has to open them.
PlannedSensor seenFromHere(PlannedSensor sensor, const std::string &planFolder)
{
    for (std::string *path : {&sensor.recipe, &sensor.profile})
        if (!path->empty())
            *path = pathOfPlan(planFolder, *path);
    return sensor;
}

void expectPlanned(CaptureSet &set, const PlannedSensor &sensor)
{
    for (InputFile &input : set.inputs) {
        const std::string name = std::filesystem::path(input.path).filename().string();
        const auto planned = std::ranges::find(sensor.inputs, name, &PlannedFile::file);
        if (planned != sensor.inputs.end())
            input.expectedSha256 = planned->sha256;
    }
}

} // namespace

Result<OpenedSensor> openSensor(
    const std::string &planFolder, const PlannedSensor &sensor, const JobControl &control)
{
    if (!sensor.obstacle.empty())
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "%1 could not be planned, so there is nothing to open (%2); mend that and make the plan anew."),
                {sensor.id, sensor.obstacle}});
    const Result<std::vector<std::string>> paths = plannedPaths(planFolder, sensor);
    if (!paths)
        return tl::unexpected(paths.error());
    const Result<Recipe> recipe
        = plannedRecipe(seenFromHere(sensor, std::filesystem::absolute(planFolder).string()));
    if (!recipe)
        return tl::unexpected(recipe.error());
    Result<CapturesRead> read = readEach(*paths, recipe->import, control);
    if (!read)
        return tl::unexpected(read.error());
    expectPlanned(read->set, sensor);
    return OpenedSensor{{std::make_shared<const CaptureSet>(std::move(read->set)), *recipe}, *paths,
        std::move(read->problems)};
}

} // namespace dyncal

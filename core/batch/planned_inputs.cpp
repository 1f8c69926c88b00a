// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/planned_inputs.h"

#include "core/base/content_hash.h"
#include "core/batch/sensor_place.h"
#include "core/capture/capture_seal.h"
#include "core/capture/opening/folder_files.h"
#include "core/project/template_choice.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> changedSincePlanned(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 is not as it was when the batch was planned; make the plan anew (dyncal batch plan), then only what changed is computed again."),
            {path}});
}

/// Files added, removed or renamed; the content is looked at later.
bool areOfNames(const std::vector<std::string> &paths, const PlannedSensor &sensor)
{
    return std::ranges::equal(
        paths, sensor.inputs, [](const std::string &path, const PlannedFile &input) {
            return fs::path(path).filename() == input.file;
        });
}

InputStamp stampOf(const InputFile &input)
{
    return {input.bytes, input.changed_ns};
}

} // namespace

Result<std::vector<std::string>> plannedPaths(
    const std::string &planFolder, const PlannedSensor &sensor)
{
    const std::string source = pathOfPlan(planFolder, sensor.source);
    std::error_code unknown;
    Result<std::vector<std::string>> paths
        = fs::is_directory(source, unknown) ? filesOfFolder(source) : std::vector{source};
    if (!paths)
        return paths;
    if (!fs::exists(source, unknown) || !areOfNames(*paths, sensor))
        return changedSincePlanned(source);
    return paths;
}

Result<std::vector<InputStamp>> checkReadInputs(
    const CaptureSet &set, const std::vector<std::string> &paths, const PlannedSensor &sensor)
{
    std::map<std::string, InputFile> read;
    for (const InputFile &input : set.inputs)
        read[input.path] = input;
    std::vector<InputStamp> stamps;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const auto found = read.find(paths[i]);
        const InputFile input
            = found != read.end() ? found->second : stampedInput(paths[i], std::string());
        const std::string hash
            = input.sha256.empty() ? sha256OfFile(paths[i]) : input.sha256; // one left out
        if (hash != sensor.inputs[i].sha256)
            return changedSincePlanned(paths[i]);
        stamps.push_back(stampOf(input));
    }
    return stamps;
}

Result<void> checkKnownInputs(const std::vector<InputStamp> &known,
    const std::vector<std::string> &paths, const PlannedSensor &sensor)
{
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const bool isKnown
            = i < known.size() && known[i] == stampOf(stampedInput(paths[i], std::string()));
        if (!isKnown && sha256OfFile(paths[i]) != sensor.inputs[i].sha256)
            return changedSincePlanned(paths[i]);
    }
    return {};
}

Result<Recipe> plannedRecipe(const PlannedSensor &sensor)
{
    Result<Recipe> recipe = readRecipeFiles(sensor.recipe, sensor.profile);
    if (!recipe)
        return recipe;
    locateTemplate(sensor.recipe, *recipe);
    const Result<std::string> hash = hashOfRecipe(*recipe);
    if (!hash)
        return tl::unexpected<Error>(hash.error());
    if (*hash != sensor.recipeSha256)
        return changedSincePlanned(sensor.recipe.empty() ? sensor.profile : sensor.recipe);
    return recipe;
}

} // namespace dyncal

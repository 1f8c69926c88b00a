// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_planning.h"

#include "core/base/content_hash.h"
#include "core/batch/sensor_name.h"
#include "core/batch/sensor_search.h"
#include "core/project/recipe.h"
#include "core/project/template_choice.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// As the plan states it: relative to the plan's folder.
std::string fromPlan(const std::string &path, const std::string &plan)
{
    if (path.empty())
        return path;
    std::error_code ignored;
    const fs::path folder = fs::weakly_canonical(folderOfPlan(plan), ignored);
    return fs::weakly_canonical(path, ignored).lexically_relative(folder).generic_string();
}

bool liesIn(const std::string &path, const std::string &folder)
{
    std::error_code ignored;
    const fs::path inner = fs::weakly_canonical(folderOfPlan(path), ignored);
    const fs::path outer = fs::weakly_canonical(folder, ignored);
    const auto [end, rest] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
    return end == outer.end();
}

/// Of the recipe in this file over the profile. A template of no recipe's lies beside the plan,
/// where the batch is computed.
Result<std::string> plannedHash(const std::string &recipePath, const BatchRequest &request)
{
    return readRecipeFiles(recipePath, request.profile).and_then([&](Recipe recipe) {
        locateTemplate(recipePath.empty() ? request.plan : recipePath, recipe);
        return hashOfRecipe(recipe);
    });
}

/// Plans one sensor after the other.
class BatchPlanner
{
public:
    BatchPlanner(const BatchRequest &request, std::string commonHash)
        : m_request(request)
        , m_commonHash(std::move(commonHash))
        , m_methods(methodVersions())
        , m_outputs(fs::path(request.plan).stem().string() + ".out")
    {
    }

    PlannedSensor plan(const FoundSensor &found) const
    {
        PlannedSensor sensor{found.id, fromPlan(found.source, m_request.plan), {}, {}, {}, {}, {},
            m_outputs + '/' + sensorFolderName(found.id), {}};
        if (found.obstacle)
            state(*found.obstacle, sensor);
        if (sensor.obstacle.empty())
            takeRecipe(found.recipe, sensor);
        if (sensor.obstacle.empty())
            takeFiles(found.files, sensor);
        if (!sensor.obstacle.empty()) // half of a key is none
            return {sensor.id, sensor.source, {}, {}, {}, {}, {}, sensor.output, sensor.obstacle,
                sensor.said};
        return sensor;
    }

private:
    static void state(const Message &obstacle, PlannedSensor &sensor)
    {
        sensor.obstacle = english(obstacle);
        sensor.said = keptMessage(obstacle);
    }

    void takeRecipe(const std::string &own, PlannedSensor &sensor) const
    {
        const Result<std::string> hash = own.empty() ? m_commonHash : plannedHash(own, m_request);
        if (!hash) {
            state(hash.error().message, sensor);
            return;
        }
        sensor.recipe = fromPlan(own.empty() ? m_request.recipe : own, m_request.plan);
        sensor.profile = fromPlan(m_request.profile, m_request.plan);
        sensor.recipeSha256 = *hash;
        sensor.methods = m_methods;
    }

    static void takeFiles(const std::vector<std::string> &files, PlannedSensor &sensor)
    {
        for (const std::string &file : files) {
            std::error_code unknown;
            const std::uintmax_t bytes = fs::file_size(file, unknown);
            std::string hash = sha256OfFile(file);
            if (hash.empty()) {
                state({DYNCAL_TEXT("core", "%1 cannot be read; check that you may read it."),
                          {fs::path(file).filename().string()}},
                    sensor);
                return;
            }
            sensor.inputs.push_back({fs::path(file).filename().string(), std::move(hash), bytes});
        }
    }

    const BatchRequest &m_request;
    std::string m_commonHash;
    MethodVersions m_methods;
    std::string m_outputs;
};

Result<void> checkPlace(const BatchRequest &request)
{
    if (!liesIn(request.plan, request.root))
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The plan %1 would lie below %2, where the recordings are, and the results with it; give the plan a place outside."),
            {request.plan, request.root}});
}

Result<std::vector<FoundSensor>> sensorsBelow(const BatchRequest &request)
{
    std::vector<std::string> settings;
    for (const std::string &path : {request.recipe, request.profile})
        if (!path.empty())
            settings.push_back(path);
    Result<std::vector<FoundSensor>> found
        = findSensors({request.root, request.eachFile, std::move(settings)});
    if (found && found->empty())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "There is no recording below %1; readable are the files that dyncal info reads, in a folder for each sensor or, with --each-file, one file for each."),
                {request.root}});
    return found;
}

} // namespace

Result<BatchPlan> planBatch(const BatchRequest &request, const JobControl &control)
{
    if (const Result<void> place = checkPlace(request); !place)
        return tl::unexpected<Error>(place.error());
    const Result<std::string> hash = plannedHash(request.recipe, request);
    if (!hash)
        return tl::unexpected<Error>(hash.error());
    const Result<std::vector<FoundSensor>> found = sensorsBelow(request);
    if (!found)
        return tl::unexpected<Error>(found.error());
    const BatchPlanner planner(request, *hash);
    BatchPlan plan;
    for (const FoundSensor &sensor : *found) {
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Cancelled."), {}});
        plan.push_back(planner.plan(sensor));
        control.report(static_cast<double>(plan.size()) / static_cast<double>(found->size()));
    }
    return plan;
}

Result<void> checkMethods(const BatchPlan &plan)
{
    const MethodVersions own = methodVersions();
    const auto other = std::ranges::find_if(plan, [&own](const PlannedSensor &sensor) {
        return sensor.obstacle.empty() && sensor.methods != own;
    });
    if (other == plan.end())
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The plan was made for other versions of the methods than this program has (first for %1); make the plan anew, then what changed is computed again."),
            {other->id}});
}

std::string planText(const BatchPlan &plan)
{
    std::string text;
    for (const PlannedSensor &sensor : plan)
        text += planLine(sensor);
    return text;
}

} // namespace dyncal

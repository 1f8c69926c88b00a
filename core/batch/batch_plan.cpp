// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_plan.h"

#include "core/base/content_hash.h"
#include "core/base/json_text.h"
#include "core/project/strict_json.h"
#include "core/project/template_choice.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

constexpr const char *kPlanSchema = "dyncal-batch-plan/1";

Json textOrNull(const std::string &text)
{
    return text.empty() ? Json() : Json(text);
}

Json inputsJson(const std::vector<PlannedFile> &inputs)
{
    Json list = Json::array();
    for (const PlannedFile &input : inputs)
        list.push_back({{"file", input.file}, {"sha256", input.sha256}, {"bytes", input.bytes}});
    return list;
}

/// Below the plan and nowhere else: a plan from elsewhere must not lead out of its folder.
bool liesBelow(const std::string &path)
{
    const fs::path given(path);
    return !path.empty() && given.is_relative() && given != "."
        && std::ranges::find(given, fs::path("..")) == given.end();
}

bool isFileName(const std::string &name)
{
    return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
}

bool isInput(const PlannedFile &input)
{
    return isFileName(input.file) && isSha256Hex(input.sha256);
}

bool isSound(const PlannedSensor &sensor)
{
    const bool isPlace = !sensor.id.empty() && !sensor.source.empty() && liesBelow(sensor.output);
    const bool isComplete = !sensor.inputs.empty() && std::ranges::all_of(sensor.inputs, isInput)
        && isSha256Hex(sensor.recipeSha256) && !sensor.methods.empty();
    return isPlace && (isComplete || !sensor.obstacle.empty());
}

std::string memberText(const Json &line, const char *key)
{
    const Json value = line.value(key, Json());
    return value.is_null() ? std::string() : value.get<std::string>();
}

PlannedFile inputOf(const Json &input)
{
    return {input.at("file"), input.at("sha256"), input.at("bytes")};
}

/// Throws what the JSON library throws where a value has another type.
PlannedSensor sensorOf(const Json &line)
{
    PlannedSensor sensor{memberText(line, "id"), memberText(line, "source"), {},
        memberText(line, "recipe"), memberText(line, "profile"), memberText(line, "recipe_sha256"),
        line.value("methods", MethodVersions()), memberText(line, "output"),
        memberText(line, "not_planned"), messageOfJson(line.value("message", Json()))};
    for (const Json &input : line.value("inputs", Json::array()))
        sensor.inputs.push_back(inputOf(input));
    return sensor;
}

Result<PlannedSensor> parseLine(const std::string &text, const std::string &place)
{
    const Result<Json> json = parseStrictJson(text, place);
    if (!json)
        return tl::unexpected<Error>(json.error());
    try {
        if (json->is_object() && json->value("schema", "") == kPlanSchema)
            if (PlannedSensor sensor = sensorOf(*json); isSound(sensor))
                return sensor;
    } catch (const Json::exception &) { // a value of another type: told below
    }
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 is no sensor of a batch (schema %2 with id, source, inputs, hashes and an output below the plan); make the plan anew with dyncal batch plan."),
            {place, kPlanSchema}});
}

Result<void> checkFirst(
    std::set<std::string> &seen, const std::string &text, const std::string &place)
{
    if (seen.insert(text).second)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 names \"%2\", as an earlier line does; one of the two has to go, or make the plan anew."),
            {place, text}});
}

/// Adds the lines one by one.
class PlanReader
{
public:
    explicit PlanReader(std::string name)
        : m_name(std::move(name))
    {
    }

    Result<void> add(const std::string &text)
    {
        ++m_line;
        if (text.find_first_not_of(" \t\r") == std::string::npos)
            return {};
        const std::string place = "Line " + std::to_string(m_line) + " of " + m_name;
        Result<PlannedSensor> sensor = parseLine(text, place);
        if (!sensor)
            return tl::unexpected<Error>(sensor.error());
        if (Result<void> first = checkFirst(m_ids, sensor->id, place); !first)
            return first;
        if (Result<void> first = checkFirst(m_outputs, sensor->output, place); !first)
            return first;
        m_plan.push_back(std::move(*sensor));
        return {};
    }

    BatchPlan take() { return std::move(m_plan); }

private:
    std::string m_name;
    std::size_t m_line = 0;
    std::set<std::string> m_ids;
    std::set<std::string> m_outputs;
    BatchPlan m_plan;
};

Result<BatchPlan> readLines(std::istream &lines, const std::string &name)
{
    PlanReader reader(name);
    for (std::string line; std::getline(lines, line);)
        if (const Result<void> added = reader.add(line); !added)
            return tl::unexpected<Error>(added.error());
    return reader.take();
}

tl::unexpected<Error> isNoPlan(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The plan %1 cannot be read; check the name, or make it with dyncal batch plan."),
            {path}});
}

} // namespace

std::string planLine(const PlannedSensor &sensor)
{
    Json line{{"schema", kPlanSchema}, {"id", sensor.id}, {"source", sensor.source},
        {"inputs", inputsJson(sensor.inputs)}, {"recipe", textOrNull(sensor.recipe)},
        {"profile", textOrNull(sensor.profile)}, {"recipe_sha256", textOrNull(sensor.recipeSha256)},
        {"methods", sensor.methods}, {"output", sensor.output}};
    if (!sensor.obstacle.empty())
        line["not_planned"] = sensor.obstacle;
    if (!sensor.said.text.empty())
        line["message"] = messageJson(sensor.said);
    return jsonLine(line);
}

Result<BatchPlan> parsePlan(const std::string &text, const std::string &name)
{
    std::istringstream lines(text);
    return readLines(lines, name);
}

Result<BatchPlan> readPlan(const std::string &path)
{
    std::error_code unknown;
    std::ifstream file(path);
    if (!file || fs::is_directory(path, unknown))
        return isNoPlan(path);
    Result<BatchPlan> plan = readLines(file, path);
    if (plan && file.bad())
        return isNoPlan(path);
    return plan;
}

std::string sensorKey(const PlannedSensor &sensor)
{
    std::string text = kPlanSchema;
    text += '\n' + sensor.recipeSha256 + '\n';
    for (const auto &[stage, version] : sensor.methods)
        text += stage + ' ' + std::to_string(version) + '\n';
    for (const PlannedFile &input : sensor.inputs)
        text += input.sha256 + ' ' + std::to_string(input.file.size()) + ' ' + input.file + '\n';
    return sha256Hex(text);
}

Result<std::string> hashOfRecipe(const Recipe &recipe)
{
    if (!isTemplateFile(recipe.certificate.templateName))
        return sha256Hex(recipeJson(recipe));
    return chooseTemplate(recipe.certificate.templateName)
        .map([&](const ChosenTemplate &chosen) { // its copy is named by what is in it
            return sha256Hex(recipeJson(withKeptTemplate(recipe, chosen)));
        });
}

std::string folderOfPlan(const std::string &planPath)
{
    const fs::path parent = fs::path(planPath).parent_path();
    return parent.empty() ? "." : parent.string();
}

} // namespace dyncal

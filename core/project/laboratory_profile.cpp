// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/laboratory_profile.h"

#include "core/base/content_hash.h"
#include "core/base/json_text.h"
#include "core/project/json_merge.h"

#include <algorithm>
#include <map>
#include <set>

namespace dyncal {
namespace {

constexpr const char *kProfileSchema = "dyncal-profile/1";
constexpr const char *kIssue = "issue"; ///< what the laboratory demands of a certificate
constexpr const char *kSecondName = "second_name";

using Allowed = std::map<std::string, std::set<std::string>>; ///< keys of a section; none = any

const Allowed &allowedSections()
{
    static const Allowed sections{
        {"import", {}},
        {"checks", {}},
        {"chain", {}},
        {"shock",
            {"arrival_sensors", "driver_length_m", "driven_length_m", "inner_diameter_m",
                "dut_position", "front_duration_s", "u_front_duration_s", "attenuation",
                "attenuation_per_m", "dut_distance_to_end_wall_m", "tube_length_m",
                "wall_sound_speed_m_s", "plateau_guard_s", "largest_mach",
                "largest_driver_pressure_pa"}},
        {"uncertainty", {"budget", "cmc", "correlations"}},
        {kIssue, {kSecondName}},
    };
    return sections;
}

/// The first key that has no place in a profile; empty where there is none.
std::string foreignKey(const Json &sections, const Allowed &allowed)
{
    for (const auto &[section, content] : sections.items()) {
        const auto found = allowed.find(section);
        if (found == allowed.end())
            return section;
        if (found->second.empty() || !content.is_object())
            continue;
        for (const auto &[key, value] : content.items())
            if (!found->second.contains(key))
                return std::string(section).append(".").append(key);
    }
    return {};
}

Result<std::string> takeWord(Json &document, const char *key, const std::string &path)
{
    const Json word = document.value(key, Json());
    document.erase(key);
    if (word.is_string() && !word.get<std::string>().empty())
        return word.get<std::string>();
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The profile %1 needs \"%2\" as a text that is not empty; a certificate says by name and version which profile was used."),
            {path, key}});
}

/// Of the first kind: a recipe with the sections import and checks.
Result<LaboratoryProfile> unnamedProfile(Json document, const std::string &path)
{
    const Allowed known{{"schema", {}}, {"import", {}}, {"checks", {}}};
    const std::string foreign = foreignKey(document, known);
    if (!foreign.empty())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The profile %1 holds \"%2\"; a laboratory's profile holds the sections import and checks only, the rest belongs into the recipe."),
                {path, foreign}});
    return LaboratoryProfile{std::move(document), {}};
}

bool isOfFirstKind(const Json &document)
{
    return document.value("schema", Json()) != kProfileSchema && !document.contains("name");
}

Result<void> checkSchema(const Json &document, const std::string &path)
{
    if (document.value("schema", Json()) == kProfileSchema)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The profile %1 is no profile that this version reads; it needs the schema \"%2\"."),
            {path, kProfileSchema}});
}

Result<void> checkSections(const Json &sections, const std::string &path)
{
    const std::string foreign = foreignKey(sections, allowedSections());
    if (foreign.empty())
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The profile %1 holds \"%2\", which is of one calibration; put it into the recipe (docs/recipe.md says what a profile holds)."),
            {path, foreign}});
}

Result<void> checkDemands(const Json &sections, const std::string &path)
{
    const Json demands = sections.value(kIssue, Json::object());
    if (demands.is_object() && demands.value(kSecondName, Json(false)).is_boolean())
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The profile %1 needs \"issue\" as an object with \"second_name\" true or false."),
            {path}});
}

Result<LaboratoryProfile> namedProfile(Json document, std::string sha256, const std::string &path)
{
    if (const Result<void> known = checkSchema(document, path); !known)
        return tl::unexpected<Error>(known.error());
    document.erase("schema");
    const Result<std::string> name = takeWord(document, "name", path);
    const Result<std::string> version = takeWord(document, "version", path);
    if (!name || !version)
        return tl::unexpected<Error>(name ? version.error() : name.error());
    if (const Result<void> known = checkSections(document, path); !known)
        return tl::unexpected<Error>(known.error());
    if (const Result<void> said = checkDemands(document, path); !said)
        return tl::unexpected<Error>(said.error());
    Json demands = document.value(kIssue, Json());
    document.erase(kIssue);
    return LaboratoryProfile{std::move(document),
        ProfileMark{*name, *version, std::move(sha256), {}}, std::move(demands)};
}

/// Whether its elements have names, so that lists of profile and recipe are joined line by line.
bool hasNames(const std::string &list)
{
    return list == "budget" || list == "cmc" || list == "correlations";
}

/// Of a correlation the pair, whichever of the two is written first.
Json nameOf(const Json &line, const std::string &list)
{
    if (!line.is_object())
        return {};
    if (list != "correlations")
        return line.value(list == "budget" ? "quantity" : "of", Json());
    const Json one = line.value("quantity", Json()), other = line.value("with", Json());
    return one < other ? Json::array({one, other}) : Json::array({other, one});
}

bool holdsName(const Json &lines, const Json &name, const std::string &list)
{
    return std::any_of(
        lines.begin(), lines.end(), [&](const Json &line) { return nameOf(line, list) == name; });
}

/// All of `upper`, behind those lines of `lower` that it has no name of.
Json joinedLines(const Json &lower, const Json &upper, const std::string &list)
{
    Json joined = Json::array();
    for (const Json &line : lower)
        if (!holdsName(upper, nameOf(line, list), list))
            joined.push_back(line);
    joined.insert(joined.end(), upper.begin(), upper.end());
    return joined;
}

void joinList(const char *list, const Json &lower, Json &upper)
{
    const Json::json_pointer at("/uncertainty/" + std::string(list));
    if (lower.contains(at) && upper.contains(at) && lower[at].is_array() && upper[at].is_array())
        upper[at] = joinedLines(lower[at], upper[at], list);
}

/// `value` as far as the keys of `form` go.
bool isAsStated(const Json &form, const Json &value)
{
    if (!form.is_object() || !value.is_object())
        return form == value;
    return std::ranges::all_of(form.items(), [&](const auto &item) {
        return value.contains(item.key()) && isAsStated(item.value(), value[item.key()]);
    });
}

/// Also of what is no line: a recipe's mark may have been edited.
std::string wordOf(const Json &line, const std::string &list)
{
    const auto word = [](const Json &value) {
        return value.is_string() ? value.get<std::string>() : std::string();
    };
    const Json name = nameOf(line, list);
    return name.is_array() ? word(name[0]) + ", " + word(name[1]) : word(name);
}

void compareLines(const Json &stated, const Json &found, const std::string &path,
    const std::string &list, std::vector<std::string> &changed)
{
    for (const Json &line : stated) {
        const bool isThere = std::any_of(
            found.begin(), found.end(), [&](const Json &other) { return isAsStated(line, other); });
        if (!isThere)
            changed.push_back(path + "{" + wordOf(line, list) + "}");
    }
}

/// A channel's role alone leaves the rest of the channel open.
bool isRoleOf(const Json &role, const Json &channel)
{
    return role.is_string() && channel.is_object() && channel.value("role", Json()) == role;
}

void compareObjects(const Json &stated, const Json &found, const std::string &path,
    std::vector<std::string> &changed)
{
    for (const auto &[key, value] : stated.items()) {
        const std::string here = path.empty() ? key : std::string(path).append(".").append(key);
        const Json other = found.is_object() ? found.value(key, Json()) : Json();
        if (hasNames(key) && value.is_array())
            compareLines(value, other, here, key, changed);
        else if (value.is_object() && other.is_object())
            compareObjects(value, other, here, changed);
        else if (value != other && !isRoleOf(value, other))
            changed.push_back(here);
    }
}

Codec<std::string> jsonObject()
{
    return {"an object",
        [](const JsonAt &at) -> Result<std::string> {
            if (!at.value.is_object())
                return mismatch(at, "an object");
            return jsonText(at.value);
        },
        [](const std::string &text) { return Json::parse(text); }};
}

} // namespace

Result<LaboratoryProfile> laboratoryProfile(const std::string &text, const std::string &path)
{
    Result<Json> document = parseStrictJson(text, "The profile");
    if (!document)
        return tl::unexpected<Error>(document.error());
    if (!document->is_object())
        return LaboratoryProfile{std::move(*document), {}};
    return isOfFirstKind(*document) ? unnamedProfile(std::move(*document), path)
                                    : namedProfile(std::move(*document), sha256Hex(text), path);
}

bool demandsSecondName(const ProfileMark &mark)
{
    const Json sections = Json::parse(mark.sections, nullptr, false);
    const Json demands = sections.is_object() ? sections.value(kIssue, Json()) : Json();
    return demands.is_object() && demands.value(kSecondName, Json()) == Json(true);
}

bool namesChain(const Json &document)
{
    return document.is_object() && document.contains(Json::json_pointer("/chain/source"));
}

void joinRecipes(Json &lower, const Json &upper)
{
    Json joined = upper;
    if (namesChain(upper)) // another file: neither the hash nor the list of the one below
        lower.erase("chain");
    for (const char *list : {"budget", "cmc", "correlations"})
        joinList(list, lower, joined);
    putOver(lower, joined);
}

Field<Recipe> profileSection()
{
    using S = ProfileMark;
    return field("profile", DYNCAL_TEXT("RecipeLabel", "profile of the laboratory"),
        &Recipe::profile,
        orNull(object<S>({
            field("name", DYNCAL_TEXT("RecipeLabel", "name of the profile"), &S::name,
                nonEmptyText(), true),
            field("version", DYNCAL_TEXT("RecipeLabel", "version of the profile"), &S::version,
                nonEmptyText(), true),
            field("sha256", DYNCAL_TEXT("RecipeLabel", "hash of the profile's file"), &S::sha256,
                nonEmptyText(), true),
            field("sections", DYNCAL_TEXT("RecipeLabel", "what the profile held"), &S::sections,
                jsonObject(), true),
        })));
}

std::vector<std::string> changedFromProfile(const ProfileMark &mark, const Json &recipe)
{
    std::vector<std::string> changed;
    Json sections = Json::parse(mark.sections);
    sections.erase(kIssue); // no part of a recipe
    compareObjects(sections, recipe, "", changed);
    return changed;
}

} // namespace dyncal

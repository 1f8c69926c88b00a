// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/issue/issued_recipe.h"

#include "core/base/calendar_date.h"
#include "core/base/content_hash.h"
#include "core/base/json_text.h"
#include "core/certificate/certificate_header_sections.h"
#include "core/certificate/certificate_words.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

std::string fieldOf(const Recipe &recipe, const char *name)
{
    const auto typed = recipe.certificate.fields.find(name);
    return typed == recipe.certificate.fields.end() || isBlank(typed->second) ? std::string()
                                                                              : typed->second;
}

void fillBlank(Recipe &recipe, const char *name, const std::string &text)
{
    if (!text.empty() && fieldOf(recipe, name).empty())
        recipe.certificate.fields[name] = text;
}

std::string withoutFolder(const std::string &path)
{
    return std::filesystem::path(path).filename().string();
}

std::string shotPlace(Index shot)
{
    return shot > 0 ? ", shot " + std::to_string(shot) : std::string();
}

} // namespace

Recipe issuedRecipe(Recipe recipe, const std::string &number, const IssueNames &names)
{
    recipe.certificate.fields["certificate_number"] = number;
    recipe.certificate.fields["date_issued"] = dayOfMoment(names.utc);
    fillBlank(recipe, "operator", names.by);
    if (!names.reviewedBy.empty())
        recipe.certificate.fields["approved_by"] = names.reviewedBy;
    recipe.chain.source = withoutFolder(recipe.chain.source);
    recipe.comparison.source = withoutFolder(recipe.comparison.source);
    return recipe;
}

std::string issuerOf(const Recipe &recipe, const IssueNames &names)
{
    return names.by.empty() ? fieldOf(recipe, "operator") : names.by;
}

std::string jobOf(const CaptureSet &captures)
{
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < captures.inputs.size(); ++i) {
        std::string part = captures.inputs[i].sha256;
        for (const Shot &shot : captures.shots)
            if (shot.input == static_cast<Index>(i))
                part += ' ' + std::to_string(shot.inFile);
        parts.push_back(std::move(part));
    }
    std::ranges::sort(parts);
    std::string text;
    for (const std::string &part : parts)
        text += part + '\n';
    return sha256Hex(std::string_view(text));
}

std::string jobSha256(const CaptureSet &captures, const Recipe &recipe, const IssueNames &names,
    const std::string &amends, const std::string &reason)
{
    // Number and time come with the reservation and are no part of the job.
    const IssueNames withoutTime{names.by, names.reviewedBy, {}};
    return sha256Hex(std::string_view(
        jsonLine({{"job", jobOf(captures)}, {"by", names.by}, {"reviewed_by", names.reviewedBy},
            {"recipe", recipeJson(issuedRecipe(recipe, {}, withoutTime))}, {"amends", amends},
            {"reason", reason}})));
}

std::vector<std::pair<std::string, std::string>> decisionsOf(
    const CaptureSet &captures, const Recipe &recipe)
{
    std::vector<std::pair<std::string, std::string>> decisions;
    for (std::size_t i = 0; i < captures.shots.size(); ++i)
        if (!captures.shots[i].included)
            decisions.emplace_back(
                "left out shot " + std::to_string(i + 1), captures.shots[i].excludeReason);
    for (const Acknowledgement &seen : recipe.acknowledge)
        decisions.emplace_back("accepted " + seen.finding + shotPlace(seen.shot), seen.reason);
    if (!recipe.realization.adoptedReason.empty())
        decisions.emplace_back("chose the model order", recipe.realization.adoptedReason);
    if (!recipe.import.sampleRateReason.empty())
        decisions.emplace_back("stated the sample rate", recipe.import.sampleRateReason);
    if (recipe.import.interpolateInvalid > 0)
        decisions.emplace_back("interpolated invalid samples, at most "
                + std::to_string(recipe.import.interpolateInvalid) + " in a row",
            "");
    return decisions;
}

std::string sensorName(const CalibrationResults &results, const Recipe &recipe)
{
    std::string name;
    for (const CertificateField &field : itemSection(results, recipe).fields)
        if (!field.missing && field.id != "sensor_description")
            name += (name.empty() ? "" : " ") + english(field.value);
    return name;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe.h"

#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/project/correlation_checks.h"
#include "core/project/laboratory_profile.h"
#include "core/project/recipe_fields_analysis.h"
#include "core/project/recipe_fields_comparison.h"
#include "core/project/recipe_fields_import.h"
#include "core/project/recipe_fields_measurement.h"
#include "core/project/recipe_fields_shock.h"
#include "core/project/recipe_fields_uncertainty.h"
#include "core/project/section_keys.h"
#include "core/reference/reference_source.h"

#include <filesystem>
#include <fstream>
#include <set>

namespace dyncal {
namespace {

constexpr const char *kSchema = "dyncal-recipe/1";
constexpr std::size_t kLargestFile = std::size_t(4) << 20U;

/// The schema is checked and written, but not part of the Recipe.
Field<Recipe> schema()
{
    const Codec<std::string> codec = oneOf({kSchema});
    return {"schema", DYNCAL_TEXT("RecipeLabel", "kind of file"),
        [codec](const JsonAt &at, Recipe &) -> Result<void> {
            return codec.read(at).map([](const std::string &) {});
        },
        [](const Recipe &) { return Json(kSchema); }};
}

const Codec<Recipe> &recipeCodec()
{
    static const Codec<Recipe> codec = [] {
        std::vector<Field<Recipe>> fields{schema()};
        SectionKeys<Recipe> plain;
        Recipe::keys(plain);
        for (const auto &sections : {importSections(), shockSections(), measurementSections(),
                 analysisSections(), uncertaintySections(), comparisonSections(),
                 std::vector{profileSection()}, plain.take()})
            fields.insert(fields.end(), sections.begin(), sections.end());
        return object<Recipe>(std::move(fields));
    }();
    return codec;
}

/// A second line for a quantity would silently be ignored, so it is an error.
Result<void> checkBudget(const std::vector<BudgetEntry> &budget)
{
    std::set<std::string> seen;
    for (const BudgetEntry &entry : budget) {
        if (!seen.insert(entry.quantity).second)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "Recipe key uncertainty.budget holds the quantity \"%1\" twice; join the two contributions to one."),
                    {entry.quantity}});
    }
    return {};
}

Result<void> checkDecision(const std::optional<DecisionSettings> &decision)
{
    if (!decision || decision->from_Hz < decision->to_Hz)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "Recipe key certificate.decision.to_hz is %1; it needs more than certificate.decision.from_hz, which is %2."),
            {numberText(decision->to_Hz, 6), numberText(decision->from_Hz, 6)}});
}

/// A band that holds no frequency would hold nothing back.
Result<void> checkCapability(const std::vector<CapabilityEntry> &cmc)
{
    for (const CapabilityEntry &entry : cmc) {
        if (entry.to_Hz && *entry.to_Hz < entry.from_Hz)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "Recipe key uncertainty.cmc holds an entry of \"%1\" from %2 to %3 Hz; the second must be the larger."),
                    {entry.of, numberText(entry.from_Hz, 6), numberText(*entry.to_Hz, 6)}});
    }
    return {};
}

/// Checks that concern several keys.
Result<void> checkTogether(const Recipe &recipe)
{
    const RealizationSettings &realization = recipe.realization;
    if (!realization.order.isAuto() && *realization.order.value > realization.maxOrder)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "Recipe key realization.order is %1; it needs at most realization.max_order, which is %2."),
                {std::to_string(*realization.order.value), std::to_string(realization.maxOrder)}});
    if (const Result<void> checked = checkDecision(recipe.certificate.decision); !checked)
        return checked;
    if (const Result<void> checked = checkCapability(recipe.uncertainty.cmc); !checked)
        return checked;
    if (const Result<void> checked
        = checkCorrelations(recipe.uncertainty, std::ssize(recipe.shock.velocity_m_s.each));
        !checked)
        return checked;
    return checkBudget(recipe.uncertainty.budget);
}

Result<Recipe> recipeOf(const Json &document)
{
    Result<Recipe> recipe = recipeCodec().read({document, "", recipeKeyPaths()});
    if (!recipe)
        return recipe;
    if (const Result<void> checked = checkTogether(*recipe); !checked)
        return tl::unexpected<Error>(checked.error());
    return recipe;
}

tl::unexpected<Error> unreadable(const std::string &path, const char *why)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core", "The file %1 cannot be read: %2."), {path, why}});
}

Result<std::string> textOfFile(const std::string &path)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return unreadable(path, "it is a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return unreadable(path, "there is no such file, or no permission to read it");
    std::string text(kLargestFile + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (file.bad())
        return unreadable(path, "reading failed");
    if (text.size() > kLargestFile)
        return unreadable(path, "it is larger than the 4 MiB that any recipe needs");
    return text;
}

/// `stated` as the recipe writes it, as far as its keys go: defaults that nobody stated are left
/// out.
Json asWritten(const Json &stated, const Json &whole)
{
    if (!stated.is_object() || !whole.is_object())
        return whole;
    Json written = Json::object();
    for (const auto &[key, value] : stated.items())
        written[key] = asWritten(value, whole.value(key, Json()));
    return written;
}

/// Checked for itself, so that messages name its own mistakes.
Result<LaboratoryProfile> profileAt(const std::string &path)
{
    const Result<std::string> text = textOfFile(path);
    if (!text)
        return tl::unexpected<Error>(text.error());
    Result<LaboratoryProfile> profile = laboratoryProfile(*text, path);
    if (!profile)
        return profile;
    const Result<Recipe> valid = recipeOf(profile->sections);
    if (!valid)
        return tl::unexpected<Error>(valid.error());
    if (!profile->mark)
        return profile;
    Json stated = asWritten(profile->sections, recipeCodec().write(*valid));
    if (!profile->demands.is_null())
        stated["issue"] = profile->demands;
    profile->mark->sections = jsonText(stated);
    return profile;
}

/// The mark of `profile`, unless the recipe was joined with another one.
Result<Recipe> marked(Recipe recipe, const LaboratoryProfile &profile, const std::string &path)
{
    if (profile.mark && recipe.profile && recipe.profile->sha256 != profile.mark->sha256)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The recipe holds the values of the profile \"%1\", version %2, and %3 is another one; leave --profile out, or start from a recipe without the key profile."),
                {recipe.profile->name, recipe.profile->version, path}});
    if (profile.mark)
        recipe.profile = profile.mark;
    return recipe;
}

Result<Json> recipeDocument(const std::string &path)
{
    const Result<std::string> text = textOfFile(path);
    if (!text)
        return tl::unexpected<Error>(text.error());
    return parseStrictJson(*text, "The recipe");
}

std::string folderOf(const std::string &path)
{
    return std::filesystem::path(path).parent_path().string();
}

/// A recipe that a run wrote says what it had from this very profile.
bool holdsChainOf(const LaboratoryProfile &profile, const Recipe &recipe)
{
    return profile.mark && recipe.profile && profile.mark->sha256 == recipe.profile->sha256
        && namesChain(profile.sections)
        && profile.sections.at(Json::json_pointer("/chain/source")) == recipe.chain.source;
}

} // namespace

Result<Recipe> parseRecipe(const std::string &json)
{
    const Result<Json> document = parseStrictJson(json, "The recipe");
    if (!document)
        return tl::unexpected<Error>(document.error());
    return recipeOf(*document);
}

std::string recipeJson(const Recipe &recipe)
{
    return jsonText(recipeCodec().write(recipe));
}

Result<Recipe> readRecipeFile(const std::string &path)
{
    return readRecipeFiles(path, {});
}

Result<Recipe> readRecipeFiles(const std::string &recipePath, const std::string &profilePath)
{
    const Result<LaboratoryProfile> profile
        = profilePath.empty() ? LaboratoryProfile{Json::object(), {}} : profileAt(profilePath);
    if (!profile)
        return tl::unexpected<Error>(profile.error());
    const Result<Json> own = recipePath.empty() ? Json::object() : recipeDocument(recipePath);
    if (!own)
        return tl::unexpected<Error>(own.error());
    Json document = profile->sections;
    joinRecipes(document, *own);
    Result<Recipe> recipe = recipeOf(document);
    if (!recipe)
        return recipe;
    loadSource(folderOf(recipePath), recipe->comparison);
    const bool isOfProfile = !namesChain(*own) || holdsChainOf(*profile, *recipe);
    loadSource(folderOf(isOfProfile ? profilePath : recipePath), recipe->chain);
    return marked(std::move(*recipe), *profile, profilePath);
}

Result<Recipe> withProfile(const Recipe &recipe, const std::string &profilePath)
{
    const Result<LaboratoryProfile> profile = profileAt(profilePath);
    if (!profile)
        return tl::unexpected<Error>(profile.error());
    Json merged = recipeCodec().write(recipe);
    merged["profile"] = nullptr;
    joinRecipes(merged, profile->sections);
    Result<Recipe> joined = recipeOf(merged);
    if (!joined)
        return joined;
    joined->comparison.loaded = recipe.comparison.loaded;
    joined->chain.loaded = recipe.chain.loaded;
    if (namesChain(profile->sections))
        loadSource(folderOf(profilePath), joined->chain);
    return marked(std::move(*joined), *profile, profilePath);
}

std::vector<std::string> changedFromProfile(const Recipe &recipe)
{
    if (!recipe.profile)
        return {};
    return changedFromProfile(*recipe.profile, recipeCodec().write(recipe));
}

const std::vector<RecipeKey> &recipeKeys()
{
    static const std::vector<RecipeKey> keys = [] {
        std::vector<RecipeKey> found = recipeCodec().keys;
        for (RecipeKey &key : found)
            key.path.erase(0, 1); // the leading dot
        return found;
    }();
    return keys;
}

const std::vector<std::string> &recipeKeyPaths()
{
    static const std::vector<std::string> paths = [] {
        std::vector<std::string> found;
        for (const RecipeKey &key : recipeKeys())
            found.push_back(key.path);
        return found;
    }();
    return paths;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_correction.h"

#include "core/project/json_merge.h"
#include "core/project/strict_json.h"

namespace dyncal {
namespace {

/// The document with nothing but `value` at the dotted key.
Json alone(const std::string &key, const Json &value)
{
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos)
        return Json::object({{key, value}});
    return Json::object({{key.substr(0, dot), alone(key.substr(dot + 1), value)}});
}

} // namespace

Result<Recipe> correctedRecipe(const Recipe &recipe, const Correction &correction)
{
    const Result<Json> value = parseStrictJson(correction.value, correction.key);
    if (!value)
        return tl::unexpected(value.error());
    Result<Json> whole = parseStrictJson(recipeJson(recipe), "recipe");
    if (!whole)
        return tl::unexpected(whole.error());
    putOver(*whole, alone(correction.key, *value));
    return parseRecipe(whole->dump()).map([&](Recipe corrected) {
        corrected.comparison.loaded = recipe.comparison.loaded; // no key of the recipe
        corrected.chain.loaded = recipe.chain.loaded;
        return corrected;
    });
}

} // namespace dyncal

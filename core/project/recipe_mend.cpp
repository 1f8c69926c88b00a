// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_mend.h"

#include "core/project/strict_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace dyncal {

Result<Recipe> mendedRecipe(const Recipe &recipe, const Mend &mend)
{
    Result<Json> value = parseStrictJson(mend.value, mend.key);
    if (!value)
        return tl::unexpected(value.error());
    Result<Json> whole = parseStrictJson(recipeJson(recipe), "recipe");
    if (!whole)
        return tl::unexpected(whole.error());
    std::string path = "/" + mend.key;
    std::replace(path.begin(), path.end(), '.', '/');
    Json &place = (*whole)[Json::json_pointer(path)];
    if (place.is_object() && value->is_object())
        place.update(*value);
    else
        place = std::move(*value);
    return parseRecipe(whole->dump());
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/project/recipe_key.h"
#include "core/project/recipe_sections.h"

#include <string>
#include <vector>

namespace dyncal {

/// Reads a recipe. Fails (Usage) on malformed JSON (line and column), on an unknown key (names it
/// and the nearest known one), on a value of the wrong type or out of range (key, found, needed).
Result<Recipe> parseRecipe(const std::string &json);

/// The recipe as JSON, every default filled in, keys sorted, two-space indent, LF.
/// parseRecipe(recipeJson(r)) == r.
std::string recipeJson(const Recipe &recipe);

/// Reads a recipe file (kind FileUnreadable if it cannot be opened), and the reference transducer's
/// file and the chain's that it names (loadSource()).
Result<Recipe> readRecipeFile(const std::string &path);

/// A recipe file over a laboratory's profile: keys missing in the recipe are taken from the
/// profile, and of the budget and the CMC the lines that it does not have. Either path may be
/// empty. Fails (Usage) if the profile holds what belongs into a recipe (docs/recipe.md) or if the
/// recipe was joined with another profile.
Result<Recipe> readRecipeFiles(const std::string &recipePath, const std::string &profilePath);

/// The recipe with what the profile states put over it; its mark is that of the profile.
Result<Recipe> withProfile(const Recipe &recipe, const std::string &profilePath);

/// The keys whose values are not those of the profile that the recipe was joined with.
std::vector<std::string> changedFromProfile(const Recipe &recipe);

/// Every key that a recipe may hold: what docs/recipe.md is checked against, and its labels.
const std::vector<RecipeKey> &recipeKeys();

/// Their dotted paths alone.
const std::vector<std::string> &recipeKeyPaths();

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/recipe_options.h"

namespace dyncal {

void RecipeOptions::declare(CLI::App &verb)
{
    verb.add_option("--recipe", recipe, "Every decision (docs/recipe.md)")->type_name("RECIPE");
    verb.add_option(
            "--profile", profile, "The laboratory's import rules and limits, below the recipe")
        ->type_name("PROFILE");
}

std::vector<std::string> RecipeOptions::files() const
{
    std::vector<std::string> given;
    for (const std::string &file : {recipe, profile})
        if (!file.empty())
            given.push_back(file);
    return given;
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/recipe.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace dyncal {

/// Options --recipe and --profile, as several subcommands have them.
struct RecipeOptions
{
    std::string recipe;
    std::string profile;

    void declare(CLI::App &verb);
    /// The recipe over the profile; the default recipe where neither is given.
    Result<Recipe> read() const { return readRecipeFiles(recipe, profile); }
    /// The paths given.
    std::vector<std::string> files() const;
};

/// Option --order.
void declareOrder(CLI::App &verb, std::string &order);

/// Option --template.
void declareTemplate(CLI::App &verb, std::string &name);
/// What it says in place of the recipe's; "" = nothing. A file stays the same in every folder.
void takeTemplate(const std::string &name, Recipe &recipe);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/recipe_options.h"

#include "core/project/template_choice.h"

#include <filesystem>

namespace dyncal {

namespace {

/// An empty word, as a script gives for a variable that is not set, is no wish for the default.
std::string isSomething(const std::string &word)
{
    return word.empty() ? "it is given without a value; give one or leave it out" : "";
}

} // namespace

void RecipeOptions::declare(CLI::App &verb)
{
    verb.add_option("--recipe", recipe, "Every decision (docs/recipe.md)")
        ->type_name("RECIPE")
        ->check(isSomething);
    verb.add_option(
            "--profile", profile, "The laboratory's import rules and limits, below the recipe")
        ->type_name("PROFILE")
        ->check(isSomething);
}

void declareOrder(CLI::App &verb, std::string &order)
{
    verb.add_option("--order", order, "Model order: auto or a number")
        ->type_name("auto|N")
        ->check(isSomething);
}

void declareTemplate(CLI::App &verb, std::string &name)
{
    verb.add_option("--template", name,
            "What the certificate shows: accredited, full, short, research, or a file (.json); else that of the recipe")
        ->type_name("NAME|FILE")
        ->check(isSomething);
}

void takeTemplate(const std::string &name, Recipe &recipe)
{
    if (!name.empty())
        recipe.certificate.templateName
            = isTemplateFile(name) ? std::filesystem::absolute(name).string() : name;
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

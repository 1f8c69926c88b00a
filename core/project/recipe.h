// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/check_settings.h"
#include "core/capture/import_settings.h"
#include "core/decomposition/component_settings.h"
#include "core/model_analysis/response_settings.h"
#include "core/project/certificate_settings.h"
#include "core/realization/input/realization_settings.h"
#include "core/shock/shock_settings.h"
#include "core/shock/uncertainty_settings.h"
#include "core/signal/signal_settings.h"

#include <string>
#include <vector>

namespace dyncal {

/// Every decision of one calibration and no data: a plain value (schema "dyncal-recipe/1").
/// The same captures with the same recipe give the same numbers in the window and headless.
struct Recipe
{
    ImportSettings import;
    CheckSettings checks;
    ShockSettings shock;
    WindowSettings window;
    bool remap = true; ///< remap the response to 0..1 (step treatments only)
    SpectrumSettings spectrum;
    ComponentSettings pca;
    InputSettings input;
    RealizationSettings realization;
    ResponseSettings response;
    UncertaintySettings uncertainty;
    std::vector<Acknowledgement> acknowledge;
    CertificateSettings certificate;

    bool operator==(const Recipe &) const = default;
};

/// Reads a recipe. Fails (Usage) on malformed JSON (line and column), on an unknown key (names it
/// and the nearest known one), on a value of the wrong type or out of range (key, found, needed).
Result<Recipe> parseRecipe(const std::string &json);

/// The recipe as JSON, every default filled in, keys sorted, two-space indent, LF.
/// parseRecipe(recipeJson(r)) == r.
std::string recipeJson(const Recipe &recipe);

/// Reads a recipe file (kind FileUnreadable if it cannot be opened).
Result<Recipe> readRecipeFile(const std::string &path);

/// A recipe file over a laboratory's profile: keys missing in the recipe are taken from the
/// profile. Either path may be empty. Fails (Usage) if the profile holds anything but the sections
/// "import" and "checks".
Result<Recipe> readRecipeFiles(const std::string &recipePath, const std::string &profilePath);

/// Every key that a recipe may hold, as dotted path ("window.end_s", "import.exclude[].shot",
/// "import.channels{}.unit"):
/// what docs/recipe.md is checked against.
const std::vector<std::string> &recipeKeyPaths();

} // namespace dyncal

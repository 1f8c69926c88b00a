// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/message.h"
#include "core/capture/check_settings.h"
#include "core/capture/import_settings.h"
#include "core/decomposition/component_settings.h"
#include "core/model_analysis/response_settings.h"
#include "core/project/certificate_settings.h"
#include "core/project/profile_mark.h"
#include "core/realization/input/realization_settings.h"
#include "core/reference/chain_settings.h"
#include "core/reference/comparison_settings.h"
#include "core/shock/shock_settings.h"
#include "core/shock/uncertainty_settings.h"
#include "core/signal/signal_settings.h"

#include <optional>
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
    ChainSettings chain;
    ComparisonSettings comparison;
    UncertaintySettings uncertainty;
    std::vector<Acknowledgement> acknowledge;
    CertificateSettings certificate;
    std::optional<ProfileMark> profile; ///< of the laboratory, that this was joined with

    /// The sections of plain settings, which list their keys themselves; those with keys of a form
    /// of their own are in recipe_fields_*.cpp.
    static void keys(auto &recipe)
    {
        recipe.section("checks", DYNCAL_TEXT("RecipeLabel", "limits of findings"), &Recipe::checks);
        recipe.section("pca", DYNCAL_TEXT("RecipeLabel", "principal components"), &Recipe::pca);
    }
    bool operator==(const Recipe &) const = default;
};

} // namespace dyncal

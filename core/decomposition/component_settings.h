// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/message.h"

namespace dyncal {

/// Recipe section "pca".
struct ComponentSettings
{
    Index components = 1; ///< kept in the reconstructions
    bool centre = false; ///< subtract the mean over shots first
    Index residualLags = 500;
    double residualConfidence = 0.99;

    static void keys(auto &section)
    {
        using S = ComponentSettings;
        section.whole(
            "components", DYNCAL_TEXT("RecipeLabel", "components kept"), &S::components, 1, 1000);
        section.flag("centre", DYNCAL_TEXT("RecipeLabel", "subtract the mean"), &S::centre);
        section.whole(
            "residual_lags", DYNCAL_TEXT("RecipeLabel", "lags"), &S::residualLags, 1, 10000000);
        section.inside("residual_confidence", DYNCAL_TEXT("RecipeLabel", "confidence of the bound"),
            &S::residualConfidence, 0.5, 1.0);
    }
    bool operator==(const ComponentSettings &) const = default;
};

} // namespace dyncal

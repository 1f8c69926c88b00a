// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/message.h"

namespace dyncal {

/// Recipe section "checks": the limits of findings that a laboratory may set for itself, usually in
/// its profile. The defaults are the program's own limits.
struct CheckSettings
{
    Index saturationRun = 3; ///< equal samples in a row at an extreme that count as saturation
    double flatCodes = 1.0; ///< standard deviation in codes below which a channel is flat
    double leastCodes = 64.0; ///< codes that a step should use at least
    double stepSigmas = 6.0; ///< standard deviations of the noise by which a step must stand out
    double rateMismatch_percent = 0.1; ///< between a stated and a typed sample rate
    double readingFactor = 3.0; ///< between the step that is read and the computed one

    static void keys(auto &section)
    {
        using S = CheckSettings;
        constexpr double kLeastStepSigmas = 4.0; // below, noise alone would count as a step
        section.whole("saturation_run",
            DYNCAL_TEXT("RecipeLabel", "equal samples that count as saturation"), &S::saturationRun,
            2, 1000000000);
        section.nonNegative("flat_codes",
            DYNCAL_TEXT("RecipeLabel", "scatter below which a channel is flat"), &S::flatCodes);
        section.nonNegative("min_codes", DYNCAL_TEXT("RecipeLabel", "codes that a step should use"),
            &S::leastCodes);
        section.number("step_sigma",
            DYNCAL_TEXT("RecipeLabel", "noise by which a step must stand out"), &S::stepSigmas,
            kLeastStepSigmas, 1e6);
        section.nonNegative("rate_mismatch_percent",
            DYNCAL_TEXT("RecipeLabel", "difference allowed between two sample rates"),
            &S::rateMismatch_percent);
        section.inside("reading_factor",
            DYNCAL_TEXT("RecipeLabel", "factor allowed between read and computed step"),
            &S::readingFactor, 1.0, 1e6);
    }
    bool operator==(const CheckSettings &) const = default;
};

} // namespace dyncal

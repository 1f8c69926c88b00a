// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/recipe_fields_uncertainty.h"

#include "core/project/capability_quantities.h"
#include "core/project/correlated_quantities.h"
#include "core/project/recipe_limits.h"

namespace dyncal {
namespace {

constexpr Index kLeastTrials = 100; // as propagateMonteCarlo() takes them
constexpr Index kMostTrials = 1000000;
constexpr Index kLargestSeed = 9007199254740991; // every JSON reader keeps it exactly

Codec<BudgetEntry> budgetEntry()
{
    using S = BudgetEntry;
    return object<S>({
        field("quantity", DYNCAL_TEXT("RecipeLabel", "quantity of the budget"), &S::quantity,
            nonEmptyText(), true),
        field("u", DYNCAL_TEXT("RecipeLabel", "u of the budget"), &S::u, nonNegativeNumber(), true),
        field("distribution", DYNCAL_TEXT("RecipeLabel", "distribution of the budget"),
            &S::distribution, oneOf({"normal", "rectangular", "triangular", "u-shaped"})),
        field("dof", DYNCAL_TEXT("RecipeLabel", "degrees of freedom of the budget"), &S::dof,
            orNull(positiveNumber())),
        field("certificate", DYNCAL_TEXT("RecipeLabel", "certificate of the reference"),
            &S::certificate, textOrNull()),
        field(
            "due", DYNCAL_TEXT("RecipeLabel", "due date of the reference"), &S::due, dateOrNull()),
    });
}

Codec<CapabilityEntry> capabilityEntry()
{
    using S = CapabilityEntry;
    return object<S>({
        field("of", DYNCAL_TEXT("RecipeLabel", "quantity of the CMC"), &S::of,
            oneOf({kCapabilityQuantities.begin(), kCapabilityQuantities.end()}), true),
        field("expanded", DYNCAL_TEXT("RecipeLabel", "CMC"), &S::expanded,
            number(0.0, 1e9, Bound::Exclusive), true),
        field("relative", DYNCAL_TEXT("RecipeLabel", "CMC is relative"), &S::isRelative, boolean()),
        field("from_hz", DYNCAL_TEXT("RecipeLabel", "CMC from"), &S::from_Hz, nonNegativeNumber()),
        field("to_hz", DYNCAL_TEXT("RecipeLabel", "CMC to"), &S::to_Hz, orNull(positiveNumber())),
    });
}

Codec<std::string> correlatedQuantity()
{
    return oneOf({kCorrelatedQuantities.begin(), kCorrelatedQuantities.end()});
}

Codec<CorrelationEntry> correlationEntry()
{
    using S = CorrelationEntry;
    return object<S>({
        field("quantity", DYNCAL_TEXT("RecipeLabel", "correlated quantity"), &S::quantity,
            correlatedQuantity(), true),
        field("with", DYNCAL_TEXT("RecipeLabel", "quantity it is correlated with"), &S::with,
            correlatedQuantity(), true),
        field("r", DYNCAL_TEXT("RecipeLabel", "correlation coefficient"), &S::coefficient,
            number(-1.0, 1.0), true),
    });
}

/// 0 in the struct stands for "adaptive".
Codec<Index> trials()
{
    const auto codec = valueOr(Json("adaptive"), whole(kLeastTrials, kMostTrials));
    const auto read = [codec](const JsonAt &at) -> Result<Index> {
        return codec.read(at).map([](const std::optional<Index> &v) { return v.value_or(0); });
    };
    const auto write = [codec](const Index &value) {
        return codec.write(value > 0 ? std::optional(value) : std::nullopt);
    };
    return {codec.needs, read, write};
}

Codec<UncertaintySettings> uncertaintyCodec()
{
    using S = UncertaintySettings;
    return object<S>({
        field("budget", DYNCAL_TEXT("RecipeLabel", "uncertainty budget"), &S::budget,
            list(budgetEntry())),
        field("correlations", DYNCAL_TEXT("RecipeLabel", "correlations in the budget"),
            &S::correlations, list(correlationEntry())),
        field("cmc", DYNCAL_TEXT("RecipeLabel", "least uncertainty of the laboratory (CMC)"),
            &S::cmc, list(capabilityEntry())),
        field("monte_carlo_trials", DYNCAL_TEXT("RecipeLabel", "Monte Carlo trials"),
            &S::monteCarloTrials, trials()),
        field("seed", DYNCAL_TEXT("RecipeLabel", "seed"), &S::seed, whole(0, kLargestSeed)),
        field("coverage", DYNCAL_TEXT("RecipeLabel", "coverage probability"), &S::coverage,
            number(0.0, 1.0, Bound::Exclusive)),
    });
}

} // namespace

std::vector<Field<Recipe>> uncertaintySections()
{
    return {field("uncertainty", DYNCAL_TEXT("RecipeLabel", "uncertainty"), &Recipe::uncertainty,
        uncertaintyCodec())};
}

} // namespace dyncal

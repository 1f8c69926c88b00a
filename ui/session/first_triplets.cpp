// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/first_triplets.h"

#include <algorithm>

namespace dyncal {

namespace {

/// Number of samples in all series from which 120 triplets take more than a quarter of a second
/// (three series of 4000; docs/benchmarks.md).
constexpr Index kLongInput = 12'000;
/// With fewer rows than this the matrix is decomposed as a whole, or nearly as quickly.
constexpr Index kManyRows = 1000;

} // namespace

Recipe withFirstTriplets(Recipe recipe)
{
    recipe.realization.maxOrder = std::min(recipe.realization.maxOrder, kFirstTriplets);
    return recipe;
}

bool firstTripletsComeEarlier(const ModelInput &input, const RealizationSettings &settings)
{
    const Index rows = settings.rows.value.value_or(input.samples / 2 - 1);
    return settings.maxOrder > kFirstTriplets && settings.order.value.value_or(1) <= kFirstTriplets
        && rows > kManyRows && input.samples * std::ssize(input.series) >= kLongInput;
}

Index wholeSetSize(const HankelDecomposition &first, const RealizationSettings &settings)
{
    return std::min({settings.maxOrder, first.rows - 1, first.columns});
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

namespace dyncal {

/// Number of singular triplets of a long model input that are shown before the rest is computed:
/// the order is nearly always among them, and they take a third of the time of 120.
inline constexpr Index kFirstTriplets = 40;

/// The recipe with at most the first triplets; everything else as it is. Its results are only for
/// the screen: reports and files are made from the recipe itself.
Recipe withFirstTriplets(Recipe recipe);

/// Whether the first triplets of this input are ready noticeably earlier than all, and suffice for
/// the recipe's order.
bool firstTripletsComeEarlier(const ModelInput &input, const RealizationSettings &settings);

/// Number of triplets that the whole set will have, known from a decomposition of the first ones.
Index wholeSetSize(const HankelDecomposition &first, const RealizationSettings &settings);

} // namespace dyncal

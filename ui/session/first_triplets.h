// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

namespace dyncal {

/// So many singular triplets of a long model input are shown before the rest of them is there: the
/// order is nearly always among them, and they take a third of the time of 120.
inline constexpr Index kFirstTriplets = 40;

/// The recipe with at most the first triplets; everything else as it is. What it gives is for
/// looking at: reports and files are of the recipe itself.
Recipe withFirstTriplets(Recipe recipe);

/// Whether the first triplets of this input are there noticeably earlier than all, and serve the
/// recipe's order.
bool firstTripletsComeEarlier(const ModelInput &input, const RealizationSettings &settings);

/// Orders that the whole set will serve, by a decomposition of the first triplets.
Index wholeSetSize(const HankelDecomposition &first, const RealizationSettings &settings);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/curves/candidate_curves.h"
#include "ui/stages/candidates/candidate_text.h"

namespace dyncal {

class Session;

/// The order of the recipe, or the one that "auto" has given.
Index chosenOrder(const Session &session);

/// The order chosen, where it was adopted (has a reason).
std::optional<Index> adoptedOrder(const Session &session);

/// One row per pinned order, as the recipe has them; up to kMostOverlaid are drawn.
std::vector<CandidateRow> candidateRows(const Session &session);

/// The models of those rows that are drawn, in their styles.
std::vector<OverlaidModel> overlaidModels(const Session &session);

} // namespace dyncal

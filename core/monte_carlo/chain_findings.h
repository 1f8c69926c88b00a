// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/monte_carlo/full_refits.h"
#include "core/monte_carlo/row_draws.h"

#include <vector>

namespace dyncal {

/// UNC-003: a caution where the law of propagation gives a U that is too small by more than
/// kExpandedDiffers, a note where it is too large, and where it is too small because nobody stated
/// the front: its range is then an assumption of the program's, of every such calibration. Each
/// names the value for which it is worst and says how many there are. What the number of trials
/// leaves open is not told.
Findings judgeChain(const std::vector<DrawnValue> &values, const std::vector<DrawnRow> &rows,
    const std::vector<DrawnRow> &rowsAtMarks);

/// UNC-006: full refits do not agree with the draws of the model's parameters, or failed; the value
/// that differs most is named. Nothing where there were no refits.
Findings judgeRefits(const RefitCheck &check);

} // namespace dyncal

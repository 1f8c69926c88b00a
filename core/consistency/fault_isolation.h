// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/consistency/compared_shots.h"

#include <vector>

namespace dyncal {

/// A cause that explains the differences, with what it leaves of them.
struct ExplainedBy
{
    FindingCause cause = FindingCause::Rate;
    double chiSquare = 0.0; ///< of what is left
    std::vector<bool> moves; ///< per row: whether this cause changes it at all
};

/// Which single fault explains the contradictions: each is taken back by a size of its own (the
/// same in all shots; a typed value shot by shot) that leaves the least chi-square, a generalised
/// likelihood ratio test (Willsky and Jones 1976). A fault explains them where that is likely
/// (p > 0.1 %) or 2 % of the whole; faults beyond what occurs (a temperature 60 K off, a humidity
/// outside 0 to 1) do not count. Likeliest first; where none explains them alone, the one that
/// leaves the least.
std::vector<ExplainedBy> explanations(const ComparedShots &shots);

} // namespace dyncal

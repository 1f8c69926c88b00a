// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/realization/hankel/hankel_decomposition.h"

namespace dyncal {

/// Whether order n cuts an oscillating pair in two (ORD-001): the next singular value is above the
/// noise, and order n + 1 has one oscillating pair more, where order n has a real pole. The
/// singular values do not show it: those of a pair differ by more than 5 % if it decays within the
/// Hankel matrix.
bool splitsPair(const HankelDecomposition &decomposition, Index order);

/// ORD-002: no singular value above the noise exceeds the next by more than a factor of 3.
Findings judgeGap(const HankelDecomposition &decomposition);

} // namespace dyncal

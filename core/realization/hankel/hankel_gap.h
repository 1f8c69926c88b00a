// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/realization/hankel/hankel_decomposition.h"

namespace dyncal {

/// Whether order n cuts an oscillating pair in two (ORD-001): the next singular value is above the
/// noise, and with it one pole more oscillates; order n has a real pole in the pair's place. Their
/// singular values do not tell: those of a pair differ by more than 5 % where it decays within the
/// Hankel matrix.
bool splitsPair(const HankelDecomposition &decomposition, Index order);

/// ORD-002: no singular value above the noise stands out of the next by more than a factor of 3.
Findings judgeGap(const HankelDecomposition &decomposition);

} // namespace dyncal

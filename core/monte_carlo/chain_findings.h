// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/monte_carlo/chain_monte_carlo.h"

namespace dyncal {

/// UNC-003: a caution where the law of propagation gives a U that is too small by more than
/// kExpandedDiffers, a note where it is too large; each names the value for which it is worst and
/// says how many there are. What the number of trials leaves open is not told.
Findings judgeChain(const ChainMonteCarlo &drawn);

} // namespace dyncal

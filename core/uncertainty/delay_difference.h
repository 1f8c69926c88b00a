// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/uncertainty/transducer_comparison.h"

#include <optional>

namespace dyncal {

/// By how much later than stated the step reaches the reference transducer, as the phases of the
/// DUT's own model have it.
struct DelayDifference
{
    double delay_s = 0.0;
    double u_s = 0.0; ///< of the stated delay, both phases, and what no delay explains
};

/// The slope over 2 pi f of the phase against the transducer less the model's, which knows the
/// onset of its own record; weighted rows up to a quarter of the model's rate, each next one on the
/// branch nearest to the slope so far. Empty with fewer than three such rows, or where the u of no
/// phase is known. docs/method/comparison.md.
std::optional<DelayDifference> delayDifference(const UncertainResponse &byTransducer);

/// CMP-005, a caution: the difference exceeds 3.6 u. `stated_s` is the delay that was typed.
Findings judgeDelay(const DelayDifference &difference, double stated_s);

} // namespace dyncal

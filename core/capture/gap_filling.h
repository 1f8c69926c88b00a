// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/raw_samples.h"

namespace dyncal {

/// Fills gaps of at most `longest` invalid samples on a straight line between their neighbours and
/// returns how many samples that were. Gaps at the ends of the record stay, and integer samples are
/// always valid. Samples are only replaced if something was filled; then they are in memory.
Index fillGaps(RawSamples &samples, Index longest);

} // namespace dyncal

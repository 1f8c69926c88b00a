// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/raw_samples.h"

namespace dyncal {

/// Fills gaps of at most `longest` invalid samples by straight lines between their neighbours and
/// returns the number of samples filled. Gaps at the ends of the record stay; integer samples are
/// always valid. If anything was filled, `samples` is then a copy in memory.
Index fillGaps(RawSamples &samples, Index longest);

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/monte_carlo/coverage_interval.h"

#include <vector>

namespace dyncal {

/// JCGM 101, 7.9.4: whether so many batches of trials are enough. `batches`: for each batch what
/// it says of every quantity. Stable once twice the standard deviation of the means over the
/// batches, of mean, u and both ends, is at most the numerical tolerance of u to `digits`
/// significant digits, for every quantity; one that does not exist in some trial does not count.
/// Never with fewer than two batches.
bool areStable(const std::vector<std::vector<DrawnQuantity>> &batches, int digits);

} // namespace dyncal

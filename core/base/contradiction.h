// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace dyncal {

/// Two ways to one quantity that differ by more than this many combined standard uncertainties
/// contradict each other: by chance in 1 of 3000 comparisons of normal errors; a fault of 4.9 is
/// found in 90 %.
inline constexpr double kContradiction = 3.6;

} // namespace dyncal

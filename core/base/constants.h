// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <limits>
#include <numbers>

namespace dyncal {

inline constexpr double kTwoPi = 2.0 * std::numbers::pi;
inline constexpr double kCelsiusZero_K = 273.15; ///< 0 degrees Celsius
/// Stands in the place of a number that is not known; the files say null.
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

} // namespace dyncal

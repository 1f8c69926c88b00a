// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cmath>

namespace dyncal {

/// Place of the first digit of a number above 0: 2 of 345, -1 of 0.3.
inline int firstPlace(double magnitude)
{
    return static_cast<int>(std::floor(std::log10(magnitude) + 1e-12));
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cmath>

namespace dyncal::testing {

/// Within a share of what is expected.
inline bool isNear(double found, double expected, double relative = 1e-9)
{
    return std::abs(found - expected) <= relative * std::abs(expected);
}

} // namespace dyncal::testing

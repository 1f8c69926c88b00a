// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <functional>

namespace dyncal {

/// Root of a sign change of `f` between a and b, by bisection to full precision.
inline double bisect(const std::function<double(double)> &f, double a, double b)
{
    const bool negative = f(a) < 0.0;
    for (int i = 0; i < 100 && a != b; ++i) {
        const double middle = 0.5 * (a + b);
        if (middle == a || middle == b)
            break;
        ((f(middle) < 0.0) == negative ? a : b) = middle;
    }
    return 0.5 * (a + b);
}

} // namespace dyncal

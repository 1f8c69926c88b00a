// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace dyncal::testing::level5 {

// What the tests of MATLAB files put into them.

inline std::vector<double> signal(std::size_t count = 20)
{
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k)
        values.push_back(
            std::sin(0.7 * static_cast<double>(k)) + 1e-3 * static_cast<double>(k * k));
    return values;
}

inline std::vector<double> axis(double first, double step, std::size_t count = 20)
{
    std::vector<double> values;
    for (std::size_t k = 0; k < count; ++k)
        values.push_back(first + step * static_cast<double>(k));
    return values;
}

inline std::vector<double> joined(std::vector<double> a, const std::vector<double> &b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

} // namespace dyncal::testing::level5

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/onset.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr int kSteps = 600;
constexpr double kStillLow = 0.25; ///< of the plateau: separates the onset from the first peak

/// Root of the k-th derivative nearest to 0 within +-search where the response is still low, by
/// scan and bisection.
std::optional<double> nearestRoot(const ExponentialSum &response, int k, double search_s)
{
    std::optional<double> nearest;
    const double step = 2.0 * search_s / kSteps;
    double left = -search_s;
    double valueLeft = response.derivative(left, k);
    for (int i = 0; i < kSteps; ++i) {
        const double right = left + step;
        const double valueRight = response.derivative(right, k);
        if ((valueLeft < 0.0) != (valueRight < 0.0)) {
            double a = left;
            double b = right;
            for (int halving = 0; halving < 60; ++halving) {
                const double middle = 0.5 * (a + b);
                ((response.derivative(middle, k) < 0.0) == (valueLeft < 0.0) ? a : b) = middle;
            }
            const bool isLow
                = std::abs(response.value(a)) <= kStillLow * std::abs(response.constant);
            if (isLow && (!nearest || std::abs(a) < std::abs(*nearest)))
                nearest = a;
        }
        left = right;
        valueLeft = valueRight;
    }
    return nearest;
}

/// Largest size of the k-th derivative in the search range, the reference for "vanishes".
double largest(const ExponentialSum &response, int k, double search_s)
{
    double top = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        const double t = search_s * (2.0 * i / kSteps - 1.0);
        top = std::max(top, std::abs(response.derivative(t, k)));
    }
    return top;
}

/// A first-order lag, alone or with a drift.
bool isLag(const ExponentialSum &response)
{
    const auto &s = response.poles_rad_s;
    if (s.size() != 2 || s[0].imag() != 0.0)
        return s.size() < 2;
    const Index slower = std::abs(s[0]) < std::abs(s[1]) ? 0 : 1;
    return std::abs(response.amplitudes[slower]) < std::abs(response.amplitudes[1 - slower]);
}

} // namespace

std::optional<double> findOnset_s(const ExponentialSum &response, double search_s)
{
    if (isLag(response))
        return nearestRoot(response, 0, search_s);
    if (response.poles_rad_s.size() % 2 == 1) {
        // Degree three: slope and curvature vanish together. Noise turns the double root of the
        // slope into two roots or none; the simple root of the curvature hardly moves.
        constexpr double kVanishes = 0.05;
        const auto flat = nearestRoot(response, 2, search_s);
        if (flat
            && std::abs(response.derivative(*flat, 1)) < kVanishes * largest(response, 1, search_s))
            return flat;
    }
    return nearestRoot(response, 1, search_s);
}

} // namespace dyncal

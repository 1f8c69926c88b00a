// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/onset.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dyncal {
namespace {

constexpr int kSteps = 600;
constexpr double kStillLow = 0.25; ///< of the plateau: separates the onset from the first peak

/// The k-th derivative at the ends of even stretches of +-search, computed where it is asked for.
class DerivativeScan
{
public:
    DerivativeScan(const ExponentialSum &response, int k, double search_s)
        : m_response(response)
        , m_k(k)
    {
        const double step = 2.0 * search_s / kSteps;
        double t_s = -search_s;
        for (double &one : m_times_s) {
            one = t_s;
            t_s += step;
        }
    }

    /// Of the i-th stretch from time 0.
    double distance_s(int i) const { return std::max({0.0, at(i), -at(i + 1)}); }

    /// Where the derivative changes its sign in the i-th stretch, if the response is still low
    /// there.
    std::optional<double> lowRoot(int i)
    {
        const bool isNegative = value(i) < 0.0;
        if (isNegative == (value(i + 1) < 0.0))
            return std::nullopt;
        double a = at(i);
        double b = at(i + 1);
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (a + b);
            ((m_response.derivative(middle, m_k) < 0.0) == isNegative ? a : b) = middle;
        }
        const bool isLow
            = std::abs(m_response.value(a)) <= kStillLow * std::abs(m_response.constant);
        return isLow ? std::optional(a) : std::nullopt;
    }

private:
    double at(int i) const { return m_times_s[static_cast<std::size_t>(i)]; }
    double value(int i)
    {
        std::optional<double> &known = m_values[static_cast<std::size_t>(i)];
        if (!known)
            known = m_response.derivative(at(i), m_k);
        return *known;
    }

    const ExponentialSum &m_response;
    int m_k;
    std::array<double, kSteps + 1> m_times_s;
    std::array<std::optional<double>, kSteps + 1> m_values;
};

/// Of two as near, the earlier one.
bool isNearer(double a, double b)
{
    return std::abs(a) != std::abs(b) ? std::abs(a) < std::abs(b) : a < b;
}

/// Root of the k-th derivative nearest to 0 within +-search where the response is still low, by
/// scan and bisection: from time 0 outwards, as a Monte Carlo asks for this in every trial and most
/// roots are near.
std::optional<double> nearestRoot(const ExponentialSum &response, int k, double search_s)
{
    DerivativeScan scan(response, k, search_s);
    std::optional<double> nearest;
    int before = kSteps / 2 - 1;
    int after = kSteps / 2;
    while (before >= 0 || after < kSteps) {
        const bool isAfter
            = before < 0 || (after < kSteps && scan.distance_s(after) < scan.distance_s(before));
        const int i = isAfter ? after++ : before--;
        if (nearest && scan.distance_s(i) > std::abs(*nearest))
            break; // so is all that is left
        const auto root = scan.lowRoot(i);
        if (root && (!nearest || isNearer(*root, *nearest)))
            nearest = root;
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

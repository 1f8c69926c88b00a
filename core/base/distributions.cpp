// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/distributions.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dyncal {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// ln Gamma(a), a > 0, by Stirling's series after shifting a beyond 10.
double logGamma(double a)
{
    constexpr std::array kTerms{1.0 / 12.0, -1.0 / 360.0, 1.0 / 1260.0, -1.0 / 1680.0, 1.0 / 1188.0,
        -691.0 / 360360.0, 1.0 / 156.0};
    double shift = 0.0;
    for (; a < 10.0; a += 1.0)
        shift += std::log(a);
    double series = 0.0, power = 1.0 / a;
    for (const double term : kTerms) {
        series += term * power;
        power /= a * a;
    }
    return (a - 0.5) * std::log(a) - a + 0.5 * std::log(2.0 * std::numbers::pi) + series - shift;
}

/// P(a, x) without the factor x^a e^-x / Gamma(a).
double lowerSeries(double a, double x)
{
    double term = 1.0 / a, sum = term;
    for (double n = a + 1.0; term > kEpsilon * sum; n += 1.0) {
        term *= x / n;
        sum += term;
    }
    return sum;
}

/// Q(a, x) without the same factor.
double upperFraction(double a, double x)
{
    constexpr int kLargestDepth = 100000; // converges within a few sqrt(a) steps for x > a + 1
    double b = x + 1.0 - a, c = 1e300, d = 1.0 / b, h = d;
    for (int i = 1; i < kLargestDepth; ++i) {
        const double step = -i * (i - a);
        b += 2.0;
        d = 1.0 / (step * d + b);
        c = b + step / c;
        h *= c * d;
        if (std::abs(c * d - 1.0) < kEpsilon)
            break;
    }
    return h;
}

} // namespace

double upperGammaRatio(double a, double x)
{
    if (!(x > 0.0))
        return 1.0;
    if (std::isinf(x))
        return 0.0;
    const double factor = std::exp(a * std::log(x) - x - logGamma(a));
    return x < a + 1.0 ? 1.0 - factor * lowerSeries(a, x) : factor * upperFraction(a, x);
}

double chiSquareSurvival(double x, double degrees)
{
    return upperGammaRatio(0.5 * degrees, 0.5 * x);
}

double normalQuantile(double p)
{
    // By symmetry the smaller tail is solved, where nothing cancels; start: A&S 26.2.23.
    const double tail = p < 0.5 ? p : 1.0 - p;
    const double t = std::sqrt(-2.0 * std::log(tail));
    double z = t
        - (2.515517 + t * (0.802853 + t * 0.010328))
            / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    for (int i = 0; i < 3; ++i) { // Halley: 4e-4 becomes rounding in two steps
        const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
        const double ratio = (0.5 * std::erfc(z / std::numbers::sqrt2) - tail) / density;
        z += ratio / (1.0 - 0.5 * z * ratio);
    }
    return p < 0.5 ? -z : z;
}

} // namespace dyncal

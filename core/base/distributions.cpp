// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/distributions.h"

#include "core/base/portable_math.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dyncal {
namespace {

using Coefficients = std::array<double, 8>; ///< ascending powers

// M. J. Wichura, Algorithm AS 241, Applied Statistics 37 (1988) 477-484, PPND16.
constexpr Coefficients kCentreAbove{3.3871328727963666080e0, 1.3314166789178437745e2,
    1.9715909503065514427e3, 1.3731693765509461125e4, 4.5921953931549871457e4,
    6.7265770927008700853e4, 3.3430575583588128105e4, 2.5090809287301226727e3};
constexpr Coefficients kCentreBelow{1.0, 4.2313330701600911252e1, 6.8718700749205790830e2,
    5.3941960214247511077e3, 2.1213794301586595867e4, 3.9307895800092710610e4,
    2.8729085735721942674e4, 5.2264952788528545610e3};
constexpr Coefficients kMiddleAbove{1.42343711074968357734e0, 4.63033784615654529590e0,
    5.76949722146069140550e0, 3.64784832476320460504e0, 1.27045825245236838258e0,
    2.41780725177450611770e-1, 2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr Coefficients kMiddleBelow{1.0, 2.05319162663775882187e0, 1.67638483018380384940e0,
    6.89767334985100004550e-1, 1.48103976427480074590e-1, 1.51986665636164571966e-2,
    5.47593808499534494600e-4, 1.05075007164441684324e-9};
constexpr Coefficients kFarAbove{6.65790464350110377720e0, 5.46378491116411436990e0,
    1.78482653991729133580e0, 2.96560571828504891230e-1, 2.65321895265761230930e-2,
    1.24266094738807843860e-3, 2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr Coefficients kFarBelow{1.0, 5.99832206555887937690e-1, 1.36929880922735805310e-1,
    1.48753612908506148525e-2, 7.86869131145613259100e-4, 1.84631831751005468180e-5,
    1.42151175831644588870e-7, 2.04426310338993978564e-15};

double polynomial(const Coefficients &c, double x)
{
    double value = c[7];
    for (std::size_t i = 7; i-- > 0;)
        value = value * x + c[i];
    return value;
}

double tailQuantile(double tailProbability)
{
    const double r = std::sqrt(-portableLog(tailProbability)); // the same on every machine
    if (r <= 5.0)
        return polynomial(kMiddleAbove, r - 1.6) / polynomial(kMiddleBelow, r - 1.6);
    return polynomial(kFarAbove, r - 5.0) / polynomial(kFarBelow, r - 5.0);
}

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

constexpr double kStirling = 10.0; ///< from here on the series below is exact to rounding

/// ln Gamma(a) - (a - 1/2) ln a + a - ln(2 pi)/2 for a >= kStirling.
double stirlingSeries(double a)
{
    constexpr std::array kTerms{1.0 / 12.0, -1.0 / 360.0, 1.0 / 1260.0, -1.0 / 1680.0, 1.0 / 1188.0,
        -691.0 / 360360.0, 1.0 / 156.0};
    double series = 0.0, power = 1.0 / a;
    for (const double term : kTerms) {
        series += term * power;
        power /= a * a;
    }
    return series;
}

/// ln(x^a e^-x / Gamma(a)), a > 0. For large a the terms would cancel, so they are combined first.
double logGammaDensity(double a, double x)
{
    double shift = 0.0;
    for (; a < kStirling; a += 1.0)
        shift += std::log(a / x);
    const double beside = (x - a) / a;
    return -a * (beside - std::log1p(beside)) + 0.5 * std::log(a / (2.0 * std::numbers::pi))
        - stirlingSeries(a) + shift;
}

/// ln(Gamma(a + 1/2) / Gamma(a)), a > 0.
double logHalfStep(double a)
{
    double shift = 0.0;
    for (; a < kStirling; a += 1.0)
        shift += std::log1p(-0.5 / (a + 0.5)); // a / (a + 1/2)
    return shift + a * std::log1p(0.5 / a) - 0.5 + 0.5 * std::log(a) + stirlingSeries(a + 0.5)
        - stirlingSeries(a);
}

/// P(a, x) over x^a e^-x / Gamma(a).
double lowerSeries(double a, double x)
{
    double term = 1.0 / a, sum = term;
    for (double n = a + 1.0; term > kEpsilon * sum; n += 1.0) {
        term *= x / n;
        sum += term;
    }
    return sum;
}

/// Q(a, x) over the same factor.
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

/// Continued fraction of the regularised incomplete beta function I_x(a, b), for x below the mean,
/// by Lentz's method (Abramowitz and Stegun 26.5.8).
double betaFraction(double a, double b, double x)
{
    constexpr double kTiny = 1e-300;
    double c = 1.0;
    double d = 1.0 - (a + b) * x / (a + 1.0);
    d = 1.0 / (std::abs(d) < kTiny ? kTiny : d);
    double h = d;
    for (int m = 1; m < 10000; ++m) {
        const double n = m;
        for (const double term : {n * (b - n) * x / ((a + 2.0 * n - 1.0) * (a + 2.0 * n)),
                 -(a + n) * (a + b + n) * x / ((a + 2.0 * n) * (a + 2.0 * n + 1.0))}) {
            d = 1.0 + term * d;
            d = 1.0 / (std::abs(d) < kTiny ? kTiny : d);
            c = 1.0 + term / c;
            c = std::abs(c) < kTiny ? kTiny : c;
            h *= d * c;
        }
        if (std::abs(d * c - 1.0) < kEpsilon)
            break;
    }
    return h;
}

/// I_x(a, 1/2) with x = 1/(1 + ratio).
double betaRatio(double a, double ratio)
{
    const double x = 1.0 / (1.0 + ratio), complement = ratio / (1.0 + ratio);
    const double front
        = std::exp(logHalfStep(a) - 0.5 * std::log(std::numbers::pi) - a * std::log1p(ratio))
        * std::sqrt(complement);
    if (x < (a + 1.0) / (a + 2.5))
        return front * betaFraction(a, 0.5, x) / a;
    return 1.0 - front * betaFraction(0.5, a, complement) / 0.5;
}

constexpr double kNormalDof = 1e8; ///< t differs from z by less than 1e-8 beyond
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

double upperGammaRatio(double a, double x)
{
    if (!(a > 0.0) || std::isnan(x))
        return kNan;
    if (x <= 0.0)
        return 1.0;
    if (std::isinf(x))
        return 0.0;
    const double factor = std::exp(logGammaDensity(a, x));
    return x < a + 1.0 ? 1.0 - factor * lowerSeries(a, x) : factor * upperFraction(a, x);
}

double chiSquareSurvival(double x, double degrees)
{
    return upperGammaRatio(0.5 * degrees, 0.5 * x);
}

double normalQuantile(double probability)
{
    if (!(probability > 0.0 && probability < 1.0))
        return probability == 0.0 ? -kInfinity : probability == 1.0 ? kInfinity : kNan;
    const double q = probability - 0.5;
    if (std::abs(q) <= 0.425) {
        const double r = 0.180625 - q * q;
        return q * polynomial(kCentreAbove, r) / polynomial(kCentreBelow, r);
    }
    return q < 0.0 ? -tailQuantile(probability) : tailQuantile(1.0 - probability);
}

double studentSurvival(double t, double dof)
{
    if (!(dof > 0.0) || std::isnan(t))
        return kNan;
    if (t < 0.0)
        return 1.0 - studentSurvival(-t, dof);
    if (dof > kNormalDof)
        return 0.5 * std::erfc(t / std::numbers::sqrt2);
    if (t == 0.0)
        return 0.5;
    if (std::isinf(t / dof * t)) // x^(dof/2) of A&S 26.5.8 without its square
        return 0.5 / (0.5 * dof)
            * std::exp(logHalfStep(0.5 * dof) - 0.5 * std::log(std::numbers::pi)
                + dof * (0.5 * std::log(dof) - std::log(t)));
    return 0.5 * betaRatio(0.5 * dof, t / dof * t);
}

double studentQuantile(double probability, double dof)
{
    if (!(probability > 0.0 && probability < 1.0 && dof > 0.0))
        return kNan;
    if (dof > kNormalDof)
        return normalQuantile(probability);
    const bool isBelow = probability < 0.5;
    const double tail = isBelow ? probability : 1.0 - probability; // neither loses digits
    double low = 0.0, high = 1.0;
    while (studentSurvival(high, dof) > tail && high < 1e300)
        high *= 2.0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle == low || middle == high)
            break;
        (studentSurvival(middle, dof) > tail ? low : high) = middle;
    }
    const double t = 0.5 * (low + high);
    return isBelow ? -t : t;
}

} // namespace dyncal

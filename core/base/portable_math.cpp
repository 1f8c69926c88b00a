// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/portable_math.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace dyncal {
namespace {

// ln 2 and pi/2 in parts: the leading ones end in zeros, so that small multiples are exact.
constexpr double kLn2High = 0x1.62e42feep-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
constexpr double kHalfPi1 = 0x1.921fb544p0;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34;
constexpr double kHalfPi3 = 0x1.3198a2e037073p-69;
constexpr double kPerLn2 = 1.4426950408889634;
constexpr double kPerHalfPi = 0.63661977236758134;

constexpr int kFractionBits = 52;
constexpr std::int64_t kExponentBias = 1023;

std::int64_t nearestInteger(double x)
{
    return static_cast<std::int64_t>(x < 0.0 ? x - 0.5 : x + 0.5);
}

/// 2^exponent for -1022 <= exponent <= 1023.
double powerOfTwo(std::int64_t exponent)
{
    return std::bit_cast<double>(
        static_cast<std::uint64_t>(exponent + kExponentBias) << kFractionBits);
}

/// 1/0!, 1/1!, 1/2!, ...
template <std::size_t count>
constexpr std::array<double, count> inverseFactorials()
{
    std::array<double, count> inverse{};
    double factorial = 1.0; // exact up to 18!
    for (std::size_t n = 0; n < count; ++n) {
        factorial *= n > 0 ? static_cast<double>(n) : 1.0;
        inverse[n] = 1.0 / factorial;
    }
    return inverse;
}

constexpr std::array<double, 18> kInverseFactorial = inverseFactorials<18>();

/// sin of |r| <= pi/4 by its series up to r^17.
double sineSeries(double r)
{
    const double r2 = r * r;
    double sum = 0.0;
    for (std::size_t n = 17; n >= 3; n -= 2)
        sum = -(sum + kInverseFactorial[n]) * r2;
    return r + r * sum;
}

/// cos of |r| <= pi/4 by its series up to r^16.
double cosineSeries(double r)
{
    const double r2 = r * r;
    double sum = 0.0;
    for (std::size_t n = 16; n >= 2; n -= 2)
        sum = -(sum + kInverseFactorial[n]) * r2;
    return 1.0 + sum;
}

} // namespace

double portableExp(double x)
{
    if (!(x >= -708.0))
        return x < -708.0 ? 0.0 : x; // NaN stays NaN
    if (x > 709.0)
        return std::numeric_limits<double>::infinity();
    const std::int64_t exponent = nearestInteger(x * kPerLn2);
    const double k = static_cast<double>(exponent);
    const double r = (x - k * kLn2High) - k * kLn2Low; // |r| <= ln(2)/2
    double sum = 0.0;
    for (std::size_t n = 14; n >= 1; --n)
        sum = (sum + kInverseFactorial[n]) * r;
    return (1.0 + sum) * powerOfTwo(exponent);
}

double portableLog(double x)
{
    constexpr std::uint64_t kFractionMask = (std::uint64_t{1} << kFractionBits) - 1;
    constexpr double kRootTwo = 1.4142135623730951;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    std::int64_t exponent = static_cast<std::int64_t>(bits >> kFractionBits) - kExponentBias;
    double mantissa = std::bit_cast<double>(
        (bits & kFractionMask) | (std::uint64_t{kExponentBias} << kFractionBits));
    if (mantissa > kRootTwo) {
        mantissa *= 0.5;
        ++exponent;
    }
    // log m = 2 atanh((m-1)/(m+1)); the argument is at most 0.172.
    const double f = mantissa - 1.0;
    const double s = f / (2.0 + f);
    const double s2 = s * s;
    double sum = 0.0;
    for (int n = 21; n >= 3; n -= 2)
        sum = (sum + 1.0 / n) * s2;
    const double k = static_cast<double>(exponent);
    return k * kLn2High + (2.0 * s + (2.0 * s * sum + k * kLn2Low));
}

SineCosine portableSineCosine(double x)
{
    const std::int64_t quadrant = nearestInteger(x * kPerHalfPi);
    const double k = static_cast<double>(quadrant);
    const double r = ((x - k * kHalfPi1) - k * kHalfPi2) - k * kHalfPi3;
    const double sine = sineSeries(r);
    const double cosine = cosineSeries(r);
    switch (quadrant & 3) {
    case 0:
        return {sine, cosine};
    case 1:
        return {cosine, -sine};
    case 2:
        return {-sine, -cosine};
    default:
        return {-cosine, sine};
    }
}

} // namespace dyncal

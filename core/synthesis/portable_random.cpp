// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/portable_random.h"

#include "core/synthesis/portable_math.h"

#include <bit>
#include <cmath>

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
    const double r = std::sqrt(-portableLog(tailProbability)); // correctly rounded everywhere
    if (r <= 5.0)
        return polynomial(kMiddleAbove, r - 1.6) / polynomial(kMiddleBelow, r - 1.6);
    return polynomial(kFarAbove, r - 5.0) / polynomial(kFarBelow, r - 5.0);
}

/// One step of splitmix64: `state` moves on, the mixed value is returned.
std::uint64_t splitMix(std::uint64_t &state)
{
    state += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

} // namespace

double normalQuantile(double probability)
{
    const double q = probability - 0.5;
    if (std::abs(q) <= 0.425) {
        const double r = 0.180625 - q * q;
        return q * polynomial(kCentreAbove, r) / polynomial(kCentreBelow, r);
    }
    return q < 0.0 ? -tailQuantile(probability) : tailQuantile(1.0 - probability);
}

RandomStream::RandomStream(std::uint64_t seed, Index shot, Index stream)
{
    std::uint64_t state = seed;
    state = splitMix(state) ^ static_cast<std::uint64_t>(shot);
    state = splitMix(state) ^ static_cast<std::uint64_t>(stream);
    for (std::uint64_t &word : m_state)
        word = splitMix(state);
}

std::uint64_t RandomStream::nextBits()
{
    auto &s = m_state;
    const std::uint64_t result = std::rotl(s[0] + s[3], 23) + s[0];
    const std::uint64_t shifted = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= shifted;
    s[3] = std::rotl(s[3], 45);
    return result;
}

double RandomStream::nextUniform()
{
    return (static_cast<double>(nextBits() >> 12) + 0.5) * 0x1p-52;
}

void RandomStream::addNormal(std::span<double> values, double deviation)
{
    for (double &value : values)
        value += deviation * nextNormal();
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/exponential_gram.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace dyncal {
namespace {

using Complex = std::complex<double>;

/// Whether e^(exponent k) hardly changes over `count` samples. Its rate is then felt in the last
/// digits of the powers only, which squaring them from one another would lose.
bool isSlow(Complex exponent, Index count)
{
    return exponent.imag() == 0.0 && exponent.real() != 0.0
        && std::abs(exponent.real()) * static_cast<double>(count) <= 1.0;
}

/// powerSums() of q = e^exponent, every power by itself.
std::array<Complex, 3> slowPowerSums(double exponent, Index count)
{
    double s0 = 0.0;
    double s1 = 0.0;
    double s2 = 0.0;
    double n = 0.0;
    const auto bits = static_cast<std::uint64_t>(count);
    for (auto bit = static_cast<int>(std::bit_width(bits)) - 1; bit >= 0; --bit) {
        const double power = std::exp(exponent * n);
        s2 += power * (s2 + 2.0 * n * s1 + n * n * s0);
        s1 += power * (s1 + n * s0);
        s0 += power * s0;
        n *= 2.0;
        if ((bits >> bit) & 1U) {
            const double next = std::exp(exponent * n);
            s0 += next;
            s1 += n * next;
            s2 += n * n * next;
            n += 1.0;
        }
    }
    return {s0, s1, s2};
}

/// Sums of k^a e^(exponent k) over the samples of all ranges.
std::array<Complex, 3> powerSumsOver(Complex exponent, const std::vector<SampleRange> &ranges)
{
    std::array<Complex, 3> total{};
    for (const SampleRange &range : ranges) {
        const auto b = static_cast<double>(range.begin);
        const auto [s0, s1, s2] = isSlow(exponent, range.end)
            ? slowPowerSums(exponent.real(), range.size())
            : powerSums(std::exp(exponent), range.size());
        const Complex begin = std::exp(exponent * b);
        total[0] += begin * s0;
        total[1] += begin * (s1 + b * s0);
        total[2] += begin * (s2 + 2.0 * b * s1 + b * b * s0);
    }
    return total;
}

} // namespace

std::array<Complex, 3> powerSums(Complex q, Index count)
{
    // Sums over 0 .. n-1 and q^n, for the leading bits of count taken one after the other.
    Complex s0 = 0.0;
    Complex s1 = 0.0;
    Complex s2 = 0.0;
    Complex power = 1.0;
    double n = 0.0;
    const auto bits = static_cast<std::uint64_t>(count);
    for (auto bit = static_cast<int>(std::bit_width(bits)) - 1; bit >= 0; --bit) {
        s2 += power * (s2 + 2.0 * n * s1 + n * n * s0);
        s1 += power * (s1 + n * s0);
        s0 += power * s0;
        power *= power;
        n *= 2.0;
        if ((bits >> bit) & 1U) {
            s0 += power;
            s1 += n * power;
            s2 += n * n * power;
            power *= q;
            n += 1.0;
        }
    }
    return {s0, s1, s2};
}

ExponentialGram::ExponentialGram(
    const std::vector<Complex> &exponents, const std::vector<SampleRange> &ranges)
    : m_modes(exponents.size())
    , m_sums(m_modes * m_modes)
{
    for (std::size_t a = 0; a < m_modes; ++a) {
        for (std::size_t b = 0; b <= a; ++b)
            m_sums[a * m_modes + b] = {powerSumsOver(exponents[a] + exponents[b], ranges),
                powerSumsOver(exponents[a] + std::conj(exponents[b]), ranges)};
    }
}

double ExponentialGram::product(
    const ExponentialColumn &a, const ExponentialColumn &b, double dt) const
{
    if (b.mode > a.mode)
        return product(b, a, dt);
    // Re(a) Re(b) = (Re(a b) + Re(a conj b)) / 2
    const Pair &sums = m_sums[a.mode * m_modes + b.mode];
    const std::size_t order = a.order + b.order;
    const Complex both = a.factor * b.factor * sums.straight[order]
        + a.factor * std::conj(b.factor) * sums.conjugate[order];
    return 0.5 * both.real() * (order == 0 ? 1.0 : order == 1 ? dt : dt * dt);
}

} // namespace dyncal

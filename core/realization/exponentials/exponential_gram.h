// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/signal/window_bands.h"

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

namespace dyncal {

/// Sums of k^a q^k for k = 0 .. count-1 and a = 0, 1, 2. Built by doubling, with additions only, so
/// that they stay exact where the closed forms 1/(1-q)^a lose all digits (q near 1). O(log count).
std::array<std::complex<double>, 3> powerSums(std::complex<double> q, Index count);

/// Values (k dt)^order Re(factor e^(exponent k)) at samples k, the exponent that of a mode.
struct ExponentialColumn
{
    std::complex<double> factor;
    std::size_t mode;
    std::size_t order; ///< 0 or 1
};

/// Sums over samples of products of two columns, by powerSums: the time hardly grows with the
/// number of samples.
class ExponentialGram
{
public:
    /// `exponents`: s dt, one per mode.
    ExponentialGram(
        const std::vector<std::complex<double>> &exponents, const std::vector<SampleRange> &ranges);

    double product(const ExponentialColumn &a, const ExponentialColumn &b, double dt) const;

private:
    struct Pair
    {
        std::array<std::complex<double>, 3> straight;
        std::array<std::complex<double>, 3> conjugate;
    };

    std::size_t m_modes;
    std::vector<Pair> m_sums;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/portable_random.h"

#include <span>
#include <vector>

namespace dyncal {

enum class NoiseColour { White, Autoregressive, Flicker };

struct NoiseKind
{
    NoiseColour colour = NoiseColour::White;
    double phi = 0.0; ///< of Autoregressive: x_k = phi x_(k-1) + e_k, -1 < phi < 1
};

/// Normal noise of standard deviation 1, stationary from the first sample on. Flicker: power per
/// hertz as 1/f between 1/(2 count) and 1/2 of the rate, as the sum of first-order processes of
/// equal variance with corners at 1/2, 1/8, 1/32 ... of the rate (ripple below 0.5 % between).
class NoiseSource
{
public:
    /// `count`: samples of the record, at least 1.
    NoiseSource(const NoiseKind &kind, Index count, RandomStream random);

    /// Adds the next values.size() values times `deviation`.
    void addTo(std::span<double> values, double deviation);

private:
    struct Process
    {
        double phi;
        double innovation; ///< standard deviation of e_k
        double state;
    };

    void addProcess(double phi);

    RandomStream m_random;
    std::vector<Process> m_processes; ///< none: white
    double m_weight = 1.0; ///< of each process
};

} // namespace dyncal

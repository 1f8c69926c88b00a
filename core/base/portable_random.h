// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/distributions.h"
#include "core/base/index.h"

#include <array>
#include <cstdint>
#include <span>

namespace dyncal {

/// Random numbers that are the same on every machine: xoshiro256++, seeded from seed, shot and
/// stream by splitmix64, so that the numbers of a record do not depend on what else is drawn, or in
/// which order.
class RandomStream
{
public:
    RandomStream(std::uint64_t seed, Index shot, Index stream);

    std::uint64_t nextBits();

    /// (k + 1/2) / 2^52 with k uniform in 0 .. 2^52 - 1: never 0 or 1, symmetric about 1/2.
    double nextUniform();

    /// Standard normal, by inversion: one uniform number each.
    double nextNormal() { return normalQuantile(nextUniform()); }

    /// Adds independent normal numbers of the given standard deviation.
    void addNormal(std::span<double> values, double deviation);

private:
    std::array<std::uint64_t, 4> m_state;
};

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/portable_random.h"

#include <bit>

namespace dyncal {
namespace {

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

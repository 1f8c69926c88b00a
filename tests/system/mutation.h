// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace dyncal::testing {

/// Damages bytes as disks, links, other programs and attackers do. The same seed gives the same
/// damage.
class Mutation
{
public:
    explicit Mutation(std::uint64_t seed)
        : m_random(seed)
    {
    }

    /// One to four damages of one file; `other` is what is spliced in.
    std::string of(std::string bytes, const std::string &other)
    {
        for (std::size_t left = 1 + below(4); left > 0; --left)
            damage(bytes, other);
        return bytes;
    }

    std::size_t below(std::size_t end)
    {
        return end == 0 ? 0 : static_cast<std::size_t>(m_random() % end);
    }

private:
    /// Headers decide most, so half of all damage is there.
    std::size_t place(const std::string &bytes)
    {
        constexpr std::size_t kHead = 2048;
        return below(below(2) == 0 ? std::min(bytes.size(), kHead) : bytes.size());
    }

    void damage(std::string &bytes, const std::string &other)
    {
        const std::size_t at = place(bytes);
        switch (below(8)) {
        case 0:
            return flip(bytes, at);
        case 1:
            return bytes.resize(at);
        case 2:
            bytes.insert(at, randomBytes(1 + below(64)));
            return;
        case 3:
            bytes.erase(at, 1 + below(64));
            return;
        case 4:
        case 5:
            return setNumber(bytes, at);
        case 6:
            return splice(bytes, at, other);
        default:
            return repeat(bytes, at);
        }
    }

    void flip(std::string &bytes, std::size_t at)
    {
        if (at < bytes.size())
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
    }

    std::string randomBytes(std::size_t count)
    {
        std::string bytes(count, '\0');
        for (char &byte : bytes)
            byte = static_cast<char>(m_random());
        return bytes;
    }

    /// A length or count of 2, 4 or 8 bytes becomes one that programs stumble over.
    void setNumber(std::string &bytes, std::size_t at)
    {
        constexpr std::array<std::uint64_t, 10> kNumbers{0, 1, 0x7F, 0xFF, 0x7FFF, 0xFFFF,
            0x7FFFFFFF, 0xFFFFFFFF, 0x7FFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF};
        const std::uint64_t number = kNumbers[below(kNumbers.size())];
        const std::size_t width = std::size_t(2) << below(3);
        const bool big = below(4) == 0;
        for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i) {
            const std::size_t byte = big ? width - 1 - i : i;
            bytes[at + i] = static_cast<char>(number >> (8 * byte));
        }
    }

    void splice(std::string &bytes, std::size_t at, const std::string &other)
    {
        constexpr std::size_t kMost = 4096;
        const std::size_t from = below(other.size());
        const std::string piece = other.substr(from, 1 + below(kMost));
        bytes.replace(at, below(2) == 0 ? piece.size() : 0, piece);
    }

    void repeat(std::string &bytes, std::size_t at)
    {
        constexpr std::size_t kMost = 256;
        const std::string piece = bytes.substr(at, 1 + below(kMost));
        for (std::size_t times = 1 + below(64); times > 0; --times)
            bytes.insert(at, piece);
    }

    std::mt19937_64 m_random;
};

} // namespace dyncal::testing

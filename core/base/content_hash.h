// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace dyncal {

/// SHA-256 of bytes that come in pieces.
class Sha256
{
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256 &) = delete;
    Sha256 &operator=(const Sha256 &) = delete;

    void add(std::span<const std::byte> bytes);

    /// 64 lower-case hexadecimal digits. Ends the hash: call it once.
    std::string hex();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

inline constexpr std::size_t kSha256Digits = 64;

/// SHA-256 as 64 lower-case hexadecimal digits.
std::string sha256Hex(std::span<const std::byte> bytes);
std::string sha256Hex(std::string_view text);

/// Whether a text has the form of a hash: 64 lower-case hexadecimal digits.
bool isSha256Hex(std::string_view text);

/// SHA-256 of a file's bytes, read in blocks; empty if it cannot be read. `goOn` gets the bytes
/// done after each block; where it returns false, reading ends and the result is empty.
std::string sha256OfFile(
    const std::string &path, const std::function<bool(std::uintmax_t)> &goOn = {});

} // namespace dyncal

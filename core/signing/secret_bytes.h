// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <memory>

namespace dyncal {

/// A passphrase or PIN. Its bytes lie in one place of memory only and are wiped at the end; it is
/// moved, never copied, and is no part of any message.
class SecretBytes
{
public:
    static constexpr std::size_t kMost = 1024; ///< bytes

    /// None: nothing was given.
    SecretBytes() = default;
    ~SecretBytes();
    SecretBytes(SecretBytes &&other) noexcept;
    SecretBytes &operator=(SecretBytes &&other) noexcept;

    /// Reads up to the first line break or the end, 1 to kMost bytes, from an open file descriptor.
    /// Fails (Usage) where it cannot be read, is empty, longer, or has a zero byte.
    static Result<SecretBytes> readFrom(int descriptor);

    bool isGiven() const { return m_bytes != nullptr; }
    std::size_t size() const { return m_size; }
    /// Ends with a zero byte; "" if none was given.
    const char *text() const { return m_bytes ? m_bytes.get() : ""; }

private:
    void wipe();

    std::unique_ptr<char[]> m_bytes; ///< kMost + 1 bytes
    std::size_t m_size = 0;
};

} // namespace dyncal

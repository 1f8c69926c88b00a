// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/free_memory.h"

#include <atomic>
#include <cstddef>

namespace dyncal {

/// Memory reserved for one thread. Pieces are handed out one after the other; their room is used
/// again only when all have been given back.
class MemoryReserve
{
public:
    explicit MemoryReserve(std::size_t bytes) noexcept;

    bool isHeld() const noexcept { return m_block.isHeld(); }
    bool holds(const void *piece) const noexcept;

    /// Aligned to 16 bytes; null if the reserve is full. Only the owning thread may call it.
    void *take(std::size_t bytes) noexcept;
    static std::size_t sizeOf(const void *piece) noexcept;
    void giveBack() noexcept; ///< one piece, from any thread

    /// Whether a piece was taken since the last call.
    bool wasUsed() noexcept { return m_used.exchange(false); }

private:
    MemoryBlock m_block;
    std::size_t m_bytes;
    std::size_t m_next = 0; ///< from there on it is free
    std::atomic<std::size_t> m_pieces = 0;
    std::atomic<bool> m_used = false;
};

} // namespace dyncal

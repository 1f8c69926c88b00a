// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/free_memory.h"

#include <atomic>
#include <cstddef>

namespace dyncal {

/// Memory kept back for one thread. Pieces are handed out one behind the other; the room of those
/// given back is used again once all are.
class MemoryReserve
{
public:
    explicit MemoryReserve(std::size_t bytes) noexcept;

    bool isHeld() const noexcept { return m_block.isHeld(); }
    bool holds(const void *piece) const noexcept;

    /// Aligned to 16 bytes; null where it is full. For the one thread only.
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

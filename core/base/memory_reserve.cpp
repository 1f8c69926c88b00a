// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/memory_reserve.h"

#include <cstring>
#include <functional>

namespace dyncal {
namespace {

constexpr std::size_t kAlignment
    = 16; ///< as malloc's; the unit before each piece holds the piece's size

} // namespace

MemoryReserve::MemoryReserve(std::size_t bytes) noexcept
    : m_block(bytes)
    , m_bytes(bytes)
{
}

bool MemoryReserve::holds(const void *piece) const noexcept
{
    const std::less<const void *> isBefore;
    const auto *begin = static_cast<const std::byte *>(m_block.begin());
    return begin != nullptr && !isBefore(piece, begin) && isBefore(piece, begin + m_bytes);
}

void *MemoryReserve::take(std::size_t bytes) noexcept
{
    if (!isHeld() || bytes > m_bytes)
        return nullptr;
    if (m_pieces.load(std::memory_order_acquire) == 0)
        m_next = 0;
    const std::size_t whole = kAlignment + (bytes + kAlignment - 1) / kAlignment * kAlignment;
    if (whole > m_bytes - m_next)
        return nullptr;
    std::byte *head = static_cast<std::byte *>(m_block.begin()) + m_next;
    std::memcpy(head, &bytes, sizeof bytes);
    m_next += whole;
    m_pieces.fetch_add(1, std::memory_order_relaxed);
    m_used = true;
    return head + kAlignment;
}

std::size_t MemoryReserve::sizeOf(const void *piece) noexcept
{
    std::size_t bytes;
    std::memcpy(&bytes, static_cast<const std::byte *>(piece) - kAlignment, sizeof bytes);
    return bytes;
}

void MemoryReserve::giveBack() noexcept
{
    m_pieces.fetch_sub(1, std::memory_order_release);
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/free_memory.h"

#include <sys/mman.h>

#include <utility>

namespace dyncal {

MemoryBlock::MemoryBlock(std::size_t bytes) noexcept
    : m_bytes(bytes)
{
    take();
}

bool MemoryBlock::take() noexcept
{
    if (m_begin != nullptr)
        return true;
    void *begin
        = ::mmap(nullptr, m_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    m_begin = begin != MAP_FAILED ? begin : nullptr;
    return isHeld();
}

void MemoryBlock::release() noexcept
{
    if (m_begin != nullptr)
        ::munmap(std::exchange(m_begin, nullptr), m_bytes);
}

} // namespace dyncal

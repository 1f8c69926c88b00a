// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>

namespace dyncal {

/// Address space that is reserved at once and given back by release() or the destructor. It uses no
/// memory until somebody writes to it, but counts against the limits of the process.
class MemoryBlock
{
public:
    explicit MemoryBlock(std::size_t bytes) noexcept;
    ~MemoryBlock() { release(); }
    MemoryBlock(const MemoryBlock &) = delete;
    MemoryBlock &operator=(const MemoryBlock &) = delete;

    bool isHeld() const noexcept { return m_begin != nullptr; }
    void *begin() const noexcept { return m_begin; }
    bool take() noexcept; ///< again; false if there is no room
    void release() noexcept;

private:
    void *m_begin = nullptr;
    std::size_t m_bytes;
};

/// Whether so much memory is available now. Ask before calls into libraries that crash without it.
inline bool isMemoryLeft(std::size_t bytes)
{
    return MemoryBlock(bytes).isHeld();
}

} // namespace dyncal

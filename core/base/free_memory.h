// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>

namespace dyncal {

/// A stretch of memory that is taken at once and given back when this goes, or sooner; it costs no
/// memory as long as nobody writes to it, but counts against the limits of the process.
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

/// Whether so much memory could be had now. For work in libraries that do not survive its lack.
inline bool isMemoryLeft(std::size_t bytes)
{
    return MemoryBlock(bytes).isHeld();
}

} // namespace dyncal

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/window_memory.h"

#include "core/base/free_memory.h"

#include <cstddef>
#include <new>

namespace dyncal {
namespace {

/// What the window's thread gets when nothing is left: enough to end what it is drawing and to say
/// so.
constexpr std::size_t kReserve = std::size_t(64) << 20U;
/// What an empty window takes, fonts and drivers of the display included.
constexpr std::size_t kEmptyWindow = std::size_t(192) << 20U;

constinit thread_local bool t_isWindow = false;
MemoryBlock *s_reserve = nullptr;

/// Whether trying again is worth while.
bool releaseReserve() noexcept
{
    if (!t_isWindow || s_reserve == nullptr || !s_reserve->isHeld())
        return false;
    s_reserve->release();
    return true;
}

void onNewFailed()
{
    if (!releaseReserve())
        throw std::bad_alloc();
}

} // namespace

bool keepMemoryForWindow()
{
    if (!isMemoryLeft(kEmptyWindow + kReserve))
        return false;
    static MemoryBlock reserve(kReserve);
    s_reserve = &reserve;
    t_isWindow = true;
    std::set_new_handler(&onNewFailed);
    return reserve.isHeld();
}

bool wasWindowMemoryUsed()
{
    if (s_reserve == nullptr || s_reserve->isHeld())
        return false;
    s_reserve->take();
    return true;
}

} // namespace dyncal

// Qt's strings, lists and pictures come from malloc, which has no handler: its own names are the
// only place to try again (glibc manual, "Replacing malloc"). Sanitizers bring their own.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

extern "C" {
void *__libc_malloc(std::size_t size);
void *__libc_calloc(std::size_t count, std::size_t size);
void *__libc_realloc(void *old, std::size_t size);

void *malloc(std::size_t size) noexcept
{
    void *memory = __libc_malloc(size);
    return memory == nullptr && dyncal::releaseReserve() ? __libc_malloc(size) : memory;
}

void *calloc(std::size_t count, std::size_t size) noexcept
{
    void *memory = __libc_calloc(count, size);
    return memory == nullptr && dyncal::releaseReserve() ? __libc_calloc(count, size) : memory;
}

void *realloc(void *old, std::size_t size) noexcept
{
    void *memory = __libc_realloc(old, size);
    return memory == nullptr && size > 0 && dyncal::releaseReserve() ? __libc_realloc(old, size)
                                                                     : memory;
}
}

#endif

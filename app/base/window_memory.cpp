// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/window_memory.h"

#include "core/base/memory_reserve.h"

#include <malloc.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace dyncal {
namespace {

/// What the window's thread gets when nothing else is left: enough to finish what it is drawing and
/// to report the shortage.
constexpr std::size_t kReserve = std::size_t(64) << 20U;
/// What an empty window takes, fonts and drivers of the display included.
constexpr std::size_t kEmptyWindow = std::size_t(192) << 20U;

constinit thread_local bool t_isWindow = false;
constinit MemoryReserve *s_reserve
    = nullptr; ///< never deleted: pieces of it may be in use to the very end

} // namespace

bool keepMemoryForWindow()
{
    if (!isMemoryLeft(kEmptyWindow + kReserve))
        return false;
    s_reserve = new MemoryReserve(kReserve);
    t_isWindow = true;
    return s_reserve->isHeld();
}

bool wasWindowMemoryUsed()
{
    return s_reserve != nullptr && s_reserve->wasUsed();
}

} // namespace dyncal

// Qt's strings, lists and pictures come from malloc, so malloc itself is replaced here (glibc
// manual, "Replacing malloc"). If the part were freed instead, any thread could take it: glibc
// reserves 64 MiB for each new thread. Sanitizers bring their own malloc.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

// NOLINTBEGIN(bugprone-reserved-identifier): glibc's own names.
extern "C" {
void *__libc_malloc(std::size_t size);
void *__libc_calloc(std::size_t count, std::size_t size);
void *__libc_realloc(void *old, std::size_t size);
void __libc_free(void *memory);
}
// NOLINTEND(bugprone-reserved-identifier)

namespace dyncal {
namespace {

void *fromReserve(std::size_t size) noexcept
{
    return t_isWindow ? s_reserve->take(size) : nullptr;
}

bool isOfReserve(const void *memory) noexcept
{
    return s_reserve != nullptr && s_reserve->holds(memory);
}

/// Moves a block to a new place, because it cannot grow in the old one.
void *moved(void *old, std::size_t oldSize, void *place, std::size_t size) noexcept
{
    if (place != nullptr) {
        std::memcpy(place, old, std::min(oldSize, size));
        free(old);
    }
    return place;
}

} // namespace
} // namespace dyncal

extern "C" {

void *malloc(std::size_t size) noexcept
{
    void *memory = __libc_malloc(size);
    return memory != nullptr ? memory : dyncal::fromReserve(size);
}

void *calloc(std::size_t count, std::size_t size) noexcept
{
    void *memory = __libc_calloc(count, size);
    std::size_t bytes = 0;
    if (memory != nullptr || __builtin_mul_overflow(count, size, &bytes))
        return memory;
    memory = dyncal::fromReserve(bytes);
    return memory != nullptr ? std::memset(memory, 0, bytes) : nullptr;
}

void *realloc(void *old, std::size_t size) noexcept
{
    if (old != nullptr && dyncal::isOfReserve(old))
        return dyncal::moved(old, dyncal::MemoryReserve::sizeOf(old), malloc(size), size);
    void *memory = __libc_realloc(old, size);
    if (memory != nullptr || size == 0)
        return memory;
    if (old == nullptr)
        return dyncal::fromReserve(size);
    return dyncal::moved(old, malloc_usable_size(old), dyncal::fromReserve(size), size);
}

void free(void *memory) noexcept
{
    if (memory != nullptr && dyncal::isOfReserve(memory))
        dyncal::s_reserve->giveBack();
    else
        __libc_free(memory);
}
}

#endif

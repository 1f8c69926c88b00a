// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/compact_heap.h"

#include <cstdlib> // says which C library it is

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace dyncal {

void keepHeapCompact()
{
#if defined(__GLIBC__)
    constexpr int kBlockOfItsOwn = 4 << 20; // bytes; stated, it does not grow with what is freed
    constexpr int kHeaps = 2;
    mallopt(M_MMAP_THRESHOLD, kBlockOfItsOwn);
    mallopt(M_ARENA_MAX, kHeaps);
#endif
}

} // namespace dyncal

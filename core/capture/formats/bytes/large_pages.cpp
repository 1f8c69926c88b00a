// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/bytes/large_pages.h"

#include <sys/mman.h>

#include <memory>

namespace dyncal {

void preferLargePages(void *memory, std::size_t bytes)
{
    void *first = memory;
    std::size_t left = bytes;
    if (memory != nullptr && std::align(kLargePage, kLargePage, first, left) != nullptr)
        madvise(first, left / kLargePage * kLargePage, MADV_HUGEPAGE);
}

} // namespace dyncal

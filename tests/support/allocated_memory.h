// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <malloc.h>

namespace dyncal::testing {

/// What is allocated, in all arenas and mapped regions: a leak raises it, fragments do not.
inline double allocated_MiB()
{
    const struct mallinfo2 all = ::mallinfo2();
    return static_cast<double>(all.uordblks + all.hblkhd) / (1024.0 * 1024.0);
}

} // namespace dyncal::testing

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

// Kernels are written once and compiled twice: for every amd64 processor and for those with AVX2.
// Both have four partial sums, so that both round alike.
#if defined(__x86_64__)
#define DYNCAL_AVX2 __attribute__((target("avx2")))
#else
#define DYNCAL_AVX2
#endif
#define DYNCAL_INLINE inline __attribute__((always_inline))

namespace dyncal {

/// Four doubles that need not be aligned to 32 bytes. The attributes stand before the equals sign:
/// of a type behind it, clang drops the alignment without a word.
using Lanes __attribute__((vector_size(32), aligned(8), may_alias)) = double;
static_assert(alignof(Lanes) == alignof(double));
inline constexpr Index kLanes = 4;

DYNCAL_INLINE const Lanes *lanes(const double *data)
{
    return reinterpret_cast<const Lanes *>(data);
}

DYNCAL_INLINE Lanes *lanes(double *data)
{
    return reinterpret_cast<Lanes *>(data);
}

inline bool hasAvx2()
{
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

#if defined(__x86_64__)
__attribute__((target("avx"), noinline)) inline void zeroUpperLanes()
{
    __builtin_ia32_vzeroupper();
}
#endif

/// To be called by a new thread. It inherits the vector registers of the thread that started it; as
/// long as the upper halves of any are in use, the processor merges them with what every
/// instruction on the lower halves gives: complex exponentials took three times as long.
inline void freeUpperLanes()
{
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx"))
        zeroUpperLanes();
#endif
}

} // namespace dyncal

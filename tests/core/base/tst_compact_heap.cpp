// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/compact_heap.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace dyncal;

/// A block that the compiler cannot leave out.
static void *touched(std::size_t bytes)
{
    void *block = std::malloc(bytes);
    *static_cast<volatile char *>(block) = 1;
    return block;
}

class TestCompactHeap : public QObject
{
    Q_OBJECT

private slots:
    /// A large block that was freed does not make the next ones part of the heap.
    void largeBlocks_areTheirOwn()
    {
#if defined(__GLIBC__)
        keepHeapCompact();
        constexpr std::size_t kLarge = 16 << 20, kNext = 8 << 20;
        std::free(touched(kLarge));
        const std::size_t before = ::mallinfo2().hblkhd;
        void *next = touched(kNext);
        QVERIFY(::mallinfo2().hblkhd >= before + kNext);
        std::free(next);
        QVERIFY(::mallinfo2().hblkhd <= before);
#else
        keepHeapCompact();
#endif
    }
};

DYNCAL_TEST(TestCompactHeap)
#include "tst_compact_heap.moc"

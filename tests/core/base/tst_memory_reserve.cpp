// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/memory_reserve.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cstdint>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

using dyncal::MemoryReserve;

namespace {

constexpr std::size_t kMiB = std::size_t(1) << 20U;
constexpr unsigned kSeed = 20261122;

/// A piece and the byte that fills it.
struct Piece
{
    unsigned char *begin;
    std::size_t bytes;
    unsigned char filling;

    bool isWhole() const
    {
        for (std::size_t i = 0; i < bytes; ++i) {
            if (begin[i] != filling)
                return false;
        }
        return MemoryReserve::sizeOf(begin) == bytes;
    }
};

} // namespace

class TestMemoryReserve : public QObject
{
    Q_OBJECT

private slots:
    void pieces_areAlignedApartAndKept()
    {
        MemoryReserve reserve(kMiB);
        std::mt19937 random(kSeed);
        for (int round = 0; round < 50; ++round) {
            std::vector<Piece> pieces;
            for (int i = 0; i < 200; ++i) {
                const std::size_t bytes = random() % 6000;
                auto *begin = static_cast<unsigned char *>(reserve.take(bytes));
                if (begin == nullptr)
                    break;
                QVERIFY(reserve.holds(begin));
                QCOMPARE(reinterpret_cast<std::uintptr_t>(begin) % 16, std::uintptr_t(0));
                pieces.push_back({begin, bytes, static_cast<unsigned char>(random())});
                std::memset(begin, pieces.back().filling, bytes);
            }
            QVERIFY(pieces.size() > 100);
            for (const Piece &piece : pieces) {
                QVERIFY(piece.isWhole());
                reserve.giveBack();
            }
        }
    }

    void full_givesNothing_andAllAgainOnceAllIsBack()
    {
        MemoryReserve reserve(kMiB);
        int first = 0;
        while (reserve.take(1000) != nullptr)
            ++first;
        QVERIFY(first > 900);
        reserve.giveBack();
        QVERIFY(reserve.take(1000) == nullptr); // one back is not all
        for (int i = 1; i < first; ++i)
            reserve.giveBack();
        int again = 0;
        while (reserve.take(1000) != nullptr)
            ++again;
        QCOMPARE(again, first);
    }

    void hugePiece_isRefused()
    {
        MemoryReserve reserve(kMiB);
        QVERIFY(reserve.take(kMiB) == nullptr); // its size needs room too
        QVERIFY(reserve.take(SIZE_MAX) == nullptr);
        QVERIFY(reserve.take(SIZE_MAX - 15) == nullptr);
        QVERIFY(reserve.take(kMiB - 16) != nullptr);
    }

    void holds_itsOwnOnly()
    {
        MemoryReserve reserve(kMiB);
        MemoryReserve other(kMiB);
        const std::vector<char> foreign(100);
        void *own = other.take(100);
        QVERIFY(!reserve.holds(foreign.data()) && !reserve.holds(own) && !reserve.holds(nullptr));
        QVERIFY(other.holds(own));
    }

    void wasUsed_sinceTheLastCall()
    {
        MemoryReserve reserve(kMiB);
        QVERIFY(!reserve.wasUsed());
        QVERIFY(reserve.take(1) != nullptr);
        QVERIFY(reserve.wasUsed());
        QVERIFY(!reserve.wasUsed());
    }

    /// Given back by other threads while the one takes.
    void giveBack_fromOtherThreads()
    {
        MemoryReserve reserve(64 * kMiB);
        for (int round = 0; round < 20; ++round) {
            for (int i = 0; i < 1000; ++i)
                QVERIFY(reserve.take(100) != nullptr);
            std::vector<std::jthread> threads;
            for (int t = 0; t < 4; ++t)
                threads.emplace_back([&reserve] {
                    for (int i = 0; i < 250; ++i)
                        reserve.giveBack();
                });
        }
        int pieces = 0;
        while (reserve.take(kMiB - 16) != nullptr)
            ++pieces;
        QCOMPARE(pieces, 64);
    }
};

DYNCAL_TEST(TestMemoryReserve)
#include "tst_memory_reserve.moc"

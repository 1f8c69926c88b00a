// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Where samples lie in a file: files are laid out here by hand, block by block in any order, and
// must be read as the table that was put in.

#include "core/capture/formats/hdf5/hdf5_places.h"
#include "tests/support/memory_file.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using Extents = std::vector<std::uint64_t>;

/// A number as it lies in a file.
std::vector<std::byte> stored(double value, SampleType type, bool bigEndian)
{
    std::vector<std::byte> bytes;
    const auto as = [&](auto number) {
        bytes.resize(sizeof number);
        std::memcpy(bytes.data(), &number, sizeof number);
    };
    switch (type) {
    case SampleType::Int8:
        as(static_cast<std::int8_t>(value));
        break;
    case SampleType::UInt8:
        as(static_cast<std::uint8_t>(value));
        break;
    case SampleType::UInt16:
        as(static_cast<std::uint16_t>(value));
        break;
    case SampleType::Int16:
        as(static_cast<std::int16_t>(value));
        break;
    case SampleType::Int32:
        as(static_cast<std::int32_t>(value));
        break;
    case SampleType::Float32:
        as(static_cast<float>(value));
        break;
    case SampleType::Float64:
        as(value);
    }
    if (bigEndian) // this machine is little endian, as all that the program is built for
        std::ranges::reverse(bytes);
    return bytes;
}

/// What stands in a row and column of the table; fits every type.
double valueAt(std::uint64_t row, std::uint64_t column)
{
    return static_cast<double>((row * 31 + column * 7 + 3) % 100);
}

std::uint64_t at(const Extents &extents, std::size_t d)
{
    return d < extents.size() ? extents[d] : 1;
}

/// A table put into a file in blocks, and its description.
struct LaidTable
{
    Hdf5Dataset dataset;
    std::vector<std::byte> bytes;
};

/// Blocks lie in the order of `order`, each behind a gap; what sticks out of the table is filled
/// with what must never be read.
LaidTable lay(const Extents &shape, const Extents &block, SampleType type, bool bigEndian,
    std::mt19937 &random, bool closely = false)
{
    LaidTable laid;
    laid.dataset.obstacle = Hdf5Obstacle::None;
    laid.dataset.storage = Hdf5Storage::InFile;
    laid.dataset.shape = shape;
    laid.dataset.blockShape = block;
    laid.dataset.type = type;
    laid.dataset.bigEndian = bigEndian ? 1 : 0;
    const auto along
        = [&](std::size_t d) { return (at(shape, d) + at(block, d) - 1) / at(block, d); };
    std::vector<std::uint64_t> order(along(0) * along(1));
    std::iota(order.begin(), order.end(), 0);
    if (!closely)
        std::shuffle(order.begin(), order.end(), random);
    laid.dataset.blockOffsets.resize(order.size());
    for (const std::uint64_t number : order) {
        laid.bytes.resize(laid.bytes.size() + (closely ? 0 : random() % 9));
        laid.dataset.blockOffsets[number] = laid.bytes.size();
        const std::uint64_t row = number / along(1) * at(block, 0);
        const std::uint64_t column = number % along(1) * at(block, 1);
        for (std::uint64_t r = row; r < row + at(block, 0); ++r)
            for (std::uint64_t c = column; c < column + at(block, 1); ++c) {
                const bool inside = r < at(shape, 0) && c < at(shape, 1);
                const auto value = stored(inside ? valueAt(r, c) : 111.0, type, bigEndian);
                laid.bytes.insert(laid.bytes.end(), value.begin(), value.end());
            }
    }
    return laid;
}

/// Whether every column, read from the file, is that of the table.
bool isReadBack(const LaidTable &laid, Index axis)
{
    const MemoryFile memory(laid.bytes.data(), laid.bytes.size());
    const auto file = SampleFile::open(memory.path());
    const Hdf5Wish wish{&laid.dataset, 0, "x", axis};
    const auto extents = extentsOf(wish);
    if (!file || !extents
        || static_cast<std::uint64_t>(extents->samples * extents->columns)
            != laid.dataset.elements())
        return false;
    for (Index column = 0; column < extents->columns; ++column) {
        const auto layout = layoutOfColumn(wish, column);
        const auto samples = layout ? samplesInFile(*file, *layout) : std::nullopt;
        if (!samples || samples->size() != extents->samples)
            return false;
        for (Index i = 0; i < extents->samples; ++i) {
            const auto row = static_cast<std::uint64_t>(axis == 0 ? i : column);
            const auto other = static_cast<std::uint64_t>(axis == 0 ? column : i);
            if (samples->at(i) != valueAt(row, other))
                return false;
        }
    }
    return true;
}

} // namespace

class TestHdf5Places : public QObject
{
    Q_OBJECT

private slots:
    void tablesInBlocksOfAnySize_areReadBack()
    {
        std::mt19937 random(7);
        const auto upTo = [&](std::uint64_t most) { return 1 + random() % most; };
        for (int trial = 0; trial < 600; ++trial) {
            const std::size_t rank = trial % 3;
            Extents shape;
            Extents block;
            for (std::size_t d = 0; d < rank; ++d) {
                shape.push_back(upTo(25));
                block.push_back(upTo(11));
            }
            const auto type = static_cast<SampleType>(random() % 7);
            const bool bigEndian = random() % 2 == 0;
            const LaidTable laid = lay(shape, block, type, bigEndian, random);
            for (const Index axis : {0, 1})
                QVERIFY2(isReadBack(laid, axis), qPrintable(QString("trial %1").arg(trial)));
        }
    }

    /// One stretch is one read: a record in a million pieces would be read a million times.
    void blocksThatFollowEachOther_areOneStretch()
    {
        std::mt19937 random(7);
        for (const Extents &block : {Extents{100}, Extents{10}, Extents{7}, Extents{1}}) {
            const LaidTable laid = lay({100}, block, SampleType::Int16, false, random, true);
            const auto layout = layoutOfColumn({&laid.dataset, 0, "x", 0}, 0);
            QVERIFY(layout);
            QCOMPARE(layout->extents.size(), std::size_t(1));
            QCOMPARE(layout->extents[0].count, Index(100));
            QVERIFY(isReadBack(laid, 0));
        }
        LaidTable apart = lay({100}, {50}, SampleType::Int16, false, random, true);
        std::swap(apart.dataset.blockOffsets[0], apart.dataset.blockOffsets[1]);
        QCOMPARE(layoutOfColumn({&apart.dataset, 0, "x", 0}, 0)->extents.size(), std::size_t(2));
        const LaidTable table = lay({20, 3}, {20, 3}, SampleType::Float64, true, random, true);
        for (Index column = 0; column < 3; ++column) {
            const auto layout = layoutOfColumn({&table.dataset, 0, "x", 0}, column);
            QCOMPARE(layout->extents.size(), std::size_t(1));
            QCOMPARE(layout->stride, Index(24));
            QCOMPARE(layout->extents[0].offset, std::uint64_t(8 * column));
        }
    }

    void absurdExtents_areNotReckonedWith()
    {
        Hdf5Dataset dataset;
        dataset.storage = Hdf5Storage::InFile;
        const auto extents = [&](const Extents &shape, Index axis) {
            dataset.shape = shape;
            return extentsOf({&dataset, 0, "x", axis});
        };
        constexpr std::uint64_t kMost = std::uint64_t(1) << 48;
        QCOMPARE(extents({kMost}, 0)->samples, Index(kMost));
        QVERIFY(!extents({kMost + 1}, 0));
        QVERIFY(!extents({~std::uint64_t(0)}, 0));
        QCOMPARE(extents({5, 4096}, 0)->columns, Index(4096));
        QCOMPARE(extents({4096, 5}, 1)->columns, Index(4096));
        QVERIFY(!extents({5, 4097}, 0) && extents({5, 4097}, 1));
        QVERIFY(!extents({5, 5, 5}, 0));
        QVERIFY(!extents({5}, -1) && !extents({5}, 2));
        QCOMPARE(extents({}, 0)->samples, Index(1)); // a single value
        QCOMPARE(extents({0}, 0)->samples, Index(0));
        dataset.storage = Hdf5Storage::Nowhere;
        QVERIFY(!extents({5}, 0));
    }

    /// The description comes from a process that a damaged file may have led astray.
    void descriptionsThatContradictThemselves_giveNoLayoutOrAWholeOne()
    {
        std::mt19937_64 random(11);
        const std::vector<std::uint64_t> odd{0, 1, 2, 3, 5, 8, 100, 4096, std::uint64_t(1) << 32,
            std::uint64_t(1) << 48, std::uint64_t(1) << 63, ~std::uint64_t(0)};
        const auto any = [&] { return odd[random() % odd.size()]; };
        int whole = 0;
        for (int trial = 0; trial < 200000; ++trial) {
            Hdf5Dataset dataset;
            dataset.storage = Hdf5Storage::InFile;
            dataset.type = static_cast<SampleType>(random() % 7);
            for (std::uint64_t d = random() % 4; d > 0; --d)
                dataset.shape.push_back(any());
            for (std::uint64_t d = random() % 4; d > 0; --d)
                dataset.blockShape.push_back(any());
            for (std::uint64_t d = random() % 6; d > 0; --d)
                dataset.blockOffsets.push_back(any());
            const Hdf5Wish wish{&dataset, 0, "x", static_cast<Index>(random() % 2)};
            const auto extents = extentsOf(wish);
            if (!extents || extents->columns == 0)
                continue;
            const auto layout = layoutOfColumn(
                wish, static_cast<Index>(random() % static_cast<std::uint64_t>(extents->columns)));
            if (!layout)
                continue;
            Index samples = 0;
            for (const SampleExtent &extent : layout->extents) {
                QVERIFY(extent.count > 0);
                samples += extent.count;
            }
            QCOMPARE(samples, extents->samples);
            QVERIFY(layout->extents.size() <= dataset.blockOffsets.size());
            whole += samples > 0 ? 1 : 0;
        }
        QVERIFY(whole > 100);
    }

    void blocksThatAreTooFewOrTooMany_giveNoLayout()
    {
        std::mt19937 random(3);
        const LaidTable whole = lay({20, 6}, {7, 4}, SampleType::Int32, false, random);
        QCOMPARE(whole.dataset.blockOffsets.size(), std::size_t(6));
        for (std::size_t blocks = 0; blocks < 14; ++blocks) {
            LaidTable laid = whole;
            laid.dataset.blockOffsets.resize(blocks);
            for (const Index axis : {0, 1})
                QCOMPARE(layoutOfColumn({&laid.dataset, 0, "x", axis}, 0).has_value(), blocks == 6);
        }
        for (const Extents &block : {Extents{7}, Extents{7, 4, 1}, Extents{0, 4}, Extents{7, 0}}) {
            LaidTable laid = whole;
            laid.dataset.blockShape = block;
            QVERIFY(!layoutOfColumn({&laid.dataset, 0, "x", 0}, 0));
        }
    }
};

DYNCAL_TEST(TestHdf5Places)
#include "tst_hdf5_places.moc"

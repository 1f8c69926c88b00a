// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the helper process unpacks, byte by byte in the order in which it must arrive, and what it
// refuses to; and the blocks that are written.

#include "core/capture/formats/hdf5/hdf5_describe.h"
#include "core/capture/formats/hdf5/hdf5_helper.h"
#include "core/capture/formats/hdf5/hdf5_samples.h"
#include "tests/core/capture/formats/hdf5/hdf5_test_file.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cstring>
#include <numeric>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr std::size_t kCache = 16U << 20U;

struct Unpacked
{
    bool isDone = false; ///< all that was ordered
    std::vector<double> values;
};

/// Runs the orders as the readers do and takes what arrives as doubles.
Unpacked unpacked(const std::string &path, const std::vector<UnpackOrder> &orders)
{
    std::vector<std::byte> bytes;
    const auto work = [&](GuardedOutput &output) {
        const bool done = unpackDatasets(path, orders, kCache, output);
        output.write(done ? "y" : "n");
    };
    const auto receive = [&](std::span<const std::byte> piece) {
        bytes.insert(bytes.end(), piece.begin(), piece.end());
        return true;
    };
    const GuardedLimits limits{256U << 20U, std::chrono::seconds(5)};
    if (!runHdf5Helper(path, work, receive, limits, {}) || bytes.empty())
        qFatal("the helper process ended");
    Unpacked result{bytes.back() == static_cast<std::byte>('y'), {}};
    result.values.resize(bytes.size() / sizeof(double));
    if (!result.values.empty())
        std::memcpy(result.values.data(), bytes.data(), result.values.size() * sizeof(double));
    return result;
}

std::uint64_t addressOf(const std::string &path, const std::string &object)
{
    const Hdf5Handle file = openHdf5File(path, 0);
    H5O_info_t info;
    if (H5Oget_info_by_name2(file.id(), object.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) < 0)
        qFatal("no such object");
    return info.addr;
}

UnpackOrder order(std::uint64_t address, Index axis, Index samples, Index columns)
{
    return {address, SampleType::Float64, axis, samples, columns, 0};
}

std::vector<double> counted(std::size_t size)
{
    std::vector<double> values(size);
    std::iota(values.begin(), values.end(), 0.0);
    return values;
}

} // namespace

class TestHdf5Samples : public QObject
{
    Q_OBJECT

private:
    ScratchFolder m_folder;
    static constexpr Index kRows = 400'000; // more than one piece, and no whole number of them
    static constexpr Index kColumns = 3;

    std::string path() const { return m_folder.file("samples.h5"); }

private slots:
    void initTestCase()
    {
        silenceHdf5();
        const Hdf5TestFile file(path());
        const std::vector<double> table = counted(static_cast<std::size_t>(kRows * kColumns));
        const std::vector<std::int16_t> counts{5, -6, 7};
        file.dataset("/table", {kRows, kColumns}, {H5T_IEEE_F64BE, {1000, 2}, true, 1},
            H5T_NATIVE_DOUBLE, table.data());
        file.dataset("/wide", {kColumns, kRows}, {H5T_IEEE_F32LE, {1, 4096}}, H5T_NATIVE_DOUBLE,
            table.data());
        file.dataset("/long", {kRows * kColumns}, {H5T_STD_I32LE, {10007}, false, 1},
            H5T_NATIVE_DOUBLE, table.data());
        file.dataset("/counts", {3}, {H5T_STD_I16BE, {}}, H5T_NATIVE_INT16, counts.data());
        file.dataset("/cube", {1, 1, 3}, {H5T_STD_I16BE, {}}, H5T_NATIVE_INT16, counts.data());
        file.dataset("/one", {}, {H5T_STD_I16BE, {}}, H5T_NATIVE_INT16, counts.data());
        file.group("/group");
    }

    void table_arrivesPieceByPieceColumnBehindColumn()
    {
        for (const Index axis : {0, 1}) {
            const std::string name = axis == 0 ? "/table" : "/wide";
            const UnpackOrder wish = order(addressOf(path(), name), axis, kRows, kColumns);
            const Unpacked result = unpacked(path(), {wish});
            QVERIFY(result.isDone);
            QCOMPARE(std::ssize(result.values), kRows * kColumns);
            std::size_t next = 0;
            for (Index begin = 0; begin < kRows; begin += wish.samplesPerPiece())
                for (Index column = 0; column < kColumns; ++column)
                    for (Index i = begin; i < std::min(kRows, begin + wish.samplesPerPiece());
                         ++i) {
                        const Index place = axis == 0 ? i * kColumns + column : column * kRows + i;
                        if (result.values[next++] != static_cast<double>(place))
                            QFAIL(qPrintable(QString("%1 of axis %2").arg(next - 1).arg(axis)));
                    }
        }
    }

    void orders_areFulfilledOneBehindTheOther()
    {
        const Index size = kRows * kColumns;
        const Unpacked result = unpacked(path(),
            {order(addressOf(path(), "/counts"), 0, 3, 1),
                order(addressOf(path(), "/long"), 0, size, 1),
                order(addressOf(path(), "/one"), 0, 1, 1),
                order(addressOf(path(), "/counts"), 1, 1, 3)});
        QVERIFY(result.isDone);
        std::vector<double> wanted{5, -6, 7};
        const std::vector<double> middle = counted(static_cast<std::size_t>(size));
        wanted.insert(wanted.end(), middle.begin(), middle.end());
        wanted.insert(wanted.end(), {5, 5, -6, 7});
        QVERIFY(result.values == wanted);
    }

    void type_isThatOfTheOrder()
    {
        UnpackOrder wish = order(addressOf(path(), "/counts"), 0, 3, 1);
        for (const SampleType type : {SampleType::Int16, SampleType::Int32, SampleType::Float32,
                 SampleType::Float64, SampleType::Int8}) {
            wish.type = type;
            std::vector<std::byte> bytes;
            const auto work = [&](GuardedOutput &output) {
                (void)unpackDatasets(path(), {wish}, kCache, output);
            };
            const auto receive = [&](std::span<const std::byte> piece) {
                bytes.insert(bytes.end(), piece.begin(), piece.end());
                return true;
            };
            QVERIFY(runHdf5Helper(path(), work, receive, kDescribingLimits, {}));
            QCOMPARE(std::ssize(bytes), 3 * bytesPerSample(type));
        }
    }

    /// The description and the file are two things: another file may have the name by now.
    void ordersThatTheFileDoesNotFulfil_areRefused()
    {
        const std::uint64_t counts = addressOf(path(), "/counts");
        const std::uint64_t table = addressOf(path(), "/table");
        const std::vector<UnpackOrder> wrong{order(counts, 0, 4, 1), order(counts, 0, 2, 1),
            order(counts, 0, 3, 2), order(counts, 1, 3, 1), order(counts, 2, 3, 1),
            order(table, 1, kRows, kColumns), order(table, 0, kRows - 1, kColumns),
            order(table, 0, kRows, kColumns + 1), order(table, 0, kRows * kColumns, 1),
            order(addressOf(path(), "/cube"), 0, 3, 1), order(addressOf(path(), "/group"), 0, 3, 1),
            order(0, 0, 3, 1), order(7, 0, 3, 1), order(~std::uint64_t(0), 0, 3, 1),
            order(addressOf(path(), "/one"), 0, 2, 1), order(counts, 0, -1, 1)};
        for (std::size_t i = 0; i < wrong.size(); ++i) {
            const Unpacked result = unpacked(path(), {wrong[i]});
            QVERIFY2(!result.isDone && result.values.empty(), qPrintable(QString::number(i)));
        }
        const Unpacked half = unpacked(path(), {order(counts, 0, 3, 1), order(counts, 0, 4, 1)});
        QVERIFY(!half.isDone);
        QCOMPARE(half.values, (std::vector<double>{5, -6, 7}));
        QVERIFY(!unpacked(m_folder.file("none.h5"), {order(counts, 0, 3, 1)}).isDone);
    }

    void pieces_holdAtMostABlockAndAtLeastASample()
    {
        for (const Index columns : {Index(0), Index(1), Index(2), Index(7), RawSamples::kBlock - 1,
                 RawSamples::kBlock, RawSamples::kBlock + 1, Index(1) << 40}) {
            const Index samples = order(0, 0, 1, columns).samplesPerPiece();
            QVERIFY(samples >= 1);
            QVERIFY(samples == 1 || samples * columns <= RawSamples::kBlock);
            QVERIFY((samples + 1) * std::max<Index>(columns, 1) > RawSamples::kBlock);
        }
    }

    void types_areAsLargeInFileAndMemoryAsASample()
    {
        for (int i = 0; i < 7; ++i) {
            const auto type = static_cast<SampleType>(i);
            const SampleTypes types = sampleTypes(type);
            for (const hid_t id : {types.stored, types.memory}) {
                QCOMPARE(static_cast<Index>(H5Tget_size(id)), bytesPerSample(type));
                const bool isInteger = RawSamples(nullptr, type, 0).isInteger();
                QCOMPARE(H5Tget_class(id), isInteger ? H5T_INTEGER : H5T_FLOAT);
                const bool isUnsigned = type == SampleType::UInt8 || type == SampleType::UInt16;
                QVERIFY(!isInteger || (H5Tget_sign(id) == H5T_SGN_NONE) == isUnsigned);
            }
            QVERIFY(H5Tget_size(types.stored) == 1 || H5Tget_order(types.stored) == H5T_ORDER_LE);
        }
    }

    void blocks_areWrittenInAnyOrderAndNotBeyondTheEnd()
    {
        const std::string file = m_folder.file("written.h5");
        constexpr hsize_t kSize = 1000;
        {
            const Hdf5TestFile made(file);
            made.claim("/x", {kSize}, {H5T_STD_I16LE, {64}});
            const Hdf5Handle dataset(H5Dopen2(made.id(), "/x", H5P_DEFAULT), &H5Dclose);
            std::vector<hsize_t> begins{0, 100, 163, 164, 500, 999};
            std::shuffle(begins.begin(), begins.end(), std::mt19937(1));
            for (const hsize_t begin : begins) {
                const auto next = std::ranges::min(
                    begins, {}, [&](hsize_t other) { return other > begin ? other : kSize + 1; });
                const hsize_t count = (next > begin ? next : kSize) - begin;
                std::vector<std::int16_t> values(count);
                std::iota(values.begin(), values.end(), static_cast<std::int16_t>(begin));
                QVERIFY(writeSampleBlock(dataset.id(), H5T_NATIVE_INT16, begin,
                    std::as_bytes(std::span(values)), count));
            }
            const std::vector<std::int16_t> two{1, 2};
            const auto bytes = std::as_bytes(std::span(two));
            for (const hsize_t begin : {kSize - 1, kSize, ~hsize_t(0)})
                QVERIFY(!writeSampleBlock(dataset.id(), H5T_NATIVE_INT16, begin, bytes, 2));
            QVERIFY(!writeSampleBlock(-1, H5T_NATIVE_INT16, 0, bytes, 2));
        }
        const Unpacked result = unpacked(file, {order(addressOf(file, "/x"), 0, kSize, 1)});
        QVERIFY(result.isDone && result.values == counted(kSize));
    }
};

DYNCAL_TEST(TestHdf5Samples)
#include "tst_hdf5_samples.moc"

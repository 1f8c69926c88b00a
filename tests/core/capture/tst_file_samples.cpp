// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/channel.h"
#include "core/capture/file_samples.h"
#include "tests/support/same_samples.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>

using namespace dyncal;

/// Samples read from a file when they are asked for are those that lie there, or nothing.
class TestFileSamples : public QObject
{
    Q_OBJECT

private slots:
    void extents_joined_giveTheSamplesInOrder();
    void stride_oneOfSeveralInterleaved_isPicked();
    void bigEndian_isTurned();
    void claims_beyondTheFile_areRefused();
    void fileChanged_isNotReadAnyMore();
    void fileChangedWithItsTimeKept_isNotReadAnyMore();
    void blocks_ofALongRecord_coverItOnce();
    void inMemory_copiesExactly();

private:
    QString write(const QByteArray &bytes)
    {
        const QString path = m_folder.filePath(QString("f%1").arg(++m_files));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write");
        return path;
    }

    template <typename T>
    static QByteArray bytesOf(const std::vector<T> &values)
    {
        return {reinterpret_cast<const char *>(values.data()),
            static_cast<qsizetype>(values.size() * sizeof(T))};
    }

    static std::optional<RawSamples> opened(const QString &path, SampleLayout layout)
    {
        auto file = SampleFile::open(path.toStdString());
        return file ? samplesInFile(*file, std::move(layout)) : std::nullopt;
    }

    QTemporaryDir m_folder;
    int m_files = 0;
};

void TestFileSamples::extents_joined_giveTheSamplesInOrder()
{
    const QString path = write(bytesOf<std::int16_t>({9, 1, 2, 3, 9, 4, 5, 9, 6}));
    const auto samples = opened(
        path, {SampleType::Int16, std::endian::little, 0, {{2, 3}, {10, 2}, {0, 0}, {16, 1}}});
    QVERIFY(samples.has_value());
    QCOMPARE(samples->size(), Index(6));
    for (Index i = 0; i < 6; ++i)
        QCOMPARE(samples->at(i), double(i + 1));
    for (Index begin = 0; begin < 6; ++begin) {
        for (Index end = begin; end <= 6; ++end) {
            Index next = begin;
            QVERIFY(samples->visitBlocks(begin, end, [&](auto values, Index first) {
                QCOMPARE(first, next);
                for (const auto value : values)
                    QCOMPARE(static_cast<Index>(value), ++next);
            }));
            QCOMPARE(next, end);
        }
    }
}

void TestFileSamples::stride_oneOfSeveralInterleaved_isPicked()
{
    std::vector<std::int16_t> rows;
    for (std::int16_t i = 0; i < 1000; ++i)
        rows.insert(rows.end(), {i, std::int16_t(-i), std::int16_t(7)});
    const QString path = write(bytesOf(rows));
    const auto samples = opened(path, {SampleType::Int16, std::endian::little, 6, {{2, 1000}}});
    QVERIFY(samples.has_value());
    for (Index i = 0; i < 1000; ++i)
        QCOMPARE(samples->at(i), double(-i));
    QVERIFY(!opened(path, {SampleType::Int16, std::endian::little, 1, {{0, 3}}}));
}

void TestFileSamples::bigEndian_isTurned()
{
    const QString path = write(QByteArray::fromHex("0102fffe3ff0000000000000"));
    const auto counts = opened(path, {SampleType::Int16, std::endian::big, 0, {{0, 2}}});
    QVERIFY(counts && counts->at(0) == 258.0 && counts->at(1) == -2.0);
    const auto value = opened(path, {SampleType::Float64, std::endian::big, 0, {{4, 1}}});
    QVERIFY(value && value->at(0) == 1.0);
}

void TestFileSamples::claims_beyondTheFile_areRefused()
{
    const QString path = write(QByteArray(100, 'x'));
    const auto refused = [&](Index stride, SampleExtent extent) {
        return !opened(path, {SampleType::Int16, std::endian::little, stride, {extent}})
                    .has_value();
    };
    QVERIFY(!refused(0, {0, 50}));
    QVERIFY(refused(0, {0, 51}));
    QVERIFY(refused(0, {2, 50}));
    QVERIFY(refused(0, {0, -1}));
    QVERIFY(refused(0, {101, 0}));
    QVERIFY(refused(0, {~std::uint64_t(0) - 4, 4}));
    QVERIFY(refused(0, {0, std::numeric_limits<Index>::max()}));
    QVERIFY(!refused(49, {0, 3})); // the last row needs only its own sample
    QVERIFY(refused(50, {0, 3}));
    QVERIFY(!SampleFile::open(m_folder.path().toStdString()));
    QVERIFY(!SampleFile::open(m_folder.filePath("missing").toStdString()));
}

void TestFileSamples::fileChanged_isNotReadAnyMore()
{
    const QString path = write(bytesOf<std::int16_t>({1, 2, 3, 4}));
    Channel channel;
    channel.samples = *opened(path, {SampleType::Int16, std::endian::little, 0, {{0, 4}}});
    QCOMPARE(physicalValues(channel, 0, 4)[3], 4.0);
    std::filesystem::resize_file(path.toStdString(), 6);
    QVERIFY(std::isnan(channel.samples.at(3)));
    QVERIFY(std::isnan(physicalValues(channel, 0, 2)[0])); // shorter now: nothing of it is trusted
    QVERIFY(sha256OfSamples(channel.samples).empty());
    QCOMPARE(channel.samples.inMemory().size(), Index(0));
}

void TestFileSamples::fileChangedWithItsTimeKept_isNotReadAnyMore()
{
    const QString path = write(bytesOf<std::int16_t>({1, 2, 3, 4}));
    const auto samples = opened(path, {SampleType::Int16, std::endian::little, 0, {{0, 4}}});
    QVERIFY(samples && samples->at(3) == 4.0);
    const auto time = std::filesystem::last_write_time(path.toStdString());
    QTest::qWait(20); // file systems count time in ticks
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite) && file.write(bytesOf<std::int16_t>({7})) == 2);
    file.close();
    std::filesystem::last_write_time(path.toStdString(), time);
    QVERIFY(std::isnan(samples->at(3)));
}

void TestFileSamples::blocks_ofALongRecord_coverItOnce()
{
    std::vector<std::uint8_t> values(RawSamples::kBlock * 2 + 5);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<std::uint8_t>(i * 31 % 251);
    const RawSamples held{RawSamples::Counts(values)};
    const auto filed = opened(write(bytesOf(values)),
        {SampleType::UInt8, std::endian::little, 0, {{0, std::ssize(values)}}});
    QVERIFY(filed && !filed->isInMemory() && held.isInMemory());
    QVERIFY(testing::sameSamples(held, *filed));
    int calls = 0;
    filed->visitBlocks(0, filed->size(), [&](auto, Index) { return ++calls < 2; });
    QCOMPARE(calls, 2);
}

void TestFileSamples::inMemory_copiesExactly()
{
    std::vector<float> values(3000);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(i) / 3.0F;
    const auto filed = opened(
        write(bytesOf(values)), {SampleType::Float32, std::endian::little, 0, {{0, 3000}}});
    QVERIFY(testing::sameSamples(filed->inMemory(), RawSamples{RawSamples::Counts(values)}));
    const RawSamples part = filed->inMemory(10, 5);
    QVERIFY(part.isInMemory() && part.size() == 5 && part.at(0) == double(values[10]));
}

DYNCAL_TEST(TestFileSamples)
#include "tst_file_samples.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/matlab/mat.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/formats/bytes/binary_test_support.h"
#include "tests/core/capture/formats/matlab/mat_test_file.h"
#include "tests/core/capture/formats/matlab/mat_test_signals.h"

using namespace dyncal;
using namespace dyncal::testing;
using namespace testing::level5;

namespace {

/// One matrix of a level 4 file.
template <typename T>
QByteArray mat4(const QByteArray &name, int code, const std::vector<T> &values, std::int32_t rows,
    std::endian order = std::endian::little, bool complex = false)
{
    ByteWriter out(order);
    const auto columns = static_cast<std::int32_t>(values.size()) / rows;
    out.put(static_cast<std::int32_t>(code + (order == std::endian::big ? 1000 : 0)));
    out.put(rows).put(columns).put<std::int32_t>(complex);
    out.put(static_cast<std::int32_t>(name.size() + 1)).raw(name).zeros(1).putAll(values);
    return complex ? out.putAll(values).bytes() : out.bytes();
}

} // namespace

/// MATLAB files of the levels 4 and 5: exact numbers, and no damage that is believed.
class TestMat : public QObject
{
    Q_OBJECT

private slots:
    void numbers_ofEveryType_areExact_data();
    void numbers_ofEveryType_areExact();
    void matrix_columnsAreChannels_orRowsIfWide();
    void smallElement_isRead();
    void longIntegers_thatDoubleCannotHold_areRefused();
    void level4_everyNumberAndOrder_isExact();
    void notSignals_areLeftOut();
    void unreadable_isRefusedBySentence_data();
    void unreadable_isRefusedBySentence();
    void bombs_areRefusedAtOnce();
    void truncated_anywhere_isRefused();
    void mutants_neverCrash();

private:
    BytesReader readBytes{"mat"};
    QTemporaryDir m_folder;
};

void TestMat::numbers_ofEveryType_areExact_data()
{
    QTest::addColumn<bool>("big");
    QTest::addColumn<bool>("compressed");
    for (const bool big : {false, true}) {
        for (const bool compressed : {false, true})
            QTest::addRow("%d %d", big, compressed) << big << compressed;
    }
}

void TestMat::numbers_ofEveryType_areExact()
{
    QFETCH(bool, big);
    QFETCH(bool, compressed);
    Mat5 file(big ? std::endian::big : std::endian::little);
    const std::vector<int> whole{0, 1, 100, 127, 3, 2, 1, 99, 5, 7};
    const auto add = [&]<typename T>(const char *name, std::uint32_t number, T) {
        std::vector<T> values(whole.begin(), whole.end());
        values[0] = std::numeric_limits<T>::lowest();
        values[1] = std::numeric_limits<T>::max();
        if (sizeof(T) == 8 && std::is_integral_v<T>) // the largest that a double holds
            values[0] = values[1] = static_cast<T>(9007199254740992);
        file.add(name, number, values, {}, kDouble, compressed);
        return values;
    };
    const auto i8 = add("i8", kMiInt8, std::int8_t());
    const auto u8 = add("u8", kMiUInt8, std::uint8_t());
    const auto i16 = add("i16", kMiInt16, std::int16_t());
    const auto u16 = add("u16", kMiUInt16, std::uint16_t());
    const auto i32 = add("i32", kMiInt32, std::int32_t());
    const auto u32 = add("u32", kMiUInt32, std::uint32_t());
    const auto f32 = add("f32", kMiSingle, float());
    const auto f64 = add("f64", kMiDouble, double());
    const auto i64 = add("i64", kMiInt64, std::int64_t());
    const auto set = readBytes(file.bytes());
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->inputs[0].format, std::string("mat"));
    QVERIFY(set->findings.empty());
    const auto check = [&](const char *name, SampleType type, const auto &values) {
        const Channel *channel = channelNamed(set->shots[0], name);
        QVERIFY2(channel != nullptr, name);
        QCOMPARE(channel->samples.type(), type);
        QCOMPARE(channel->samples.size(), std::ssize(values));
        for (Index k = 0; k < std::ssize(values); ++k)
            QCOMPARE(channel->samples.at(k), double(values[static_cast<std::size_t>(k)]));
        QCOMPARE(channel->sampleRate_Hz, 0.0);
        QCOMPARE(channel->unit, std::string("1"));
    };
    check("i8", SampleType::Int8, i8);
    check("u8", SampleType::UInt8, u8);
    check("i16", SampleType::Int16, i16);
    check("u16", SampleType::UInt16, u16);
    check("i32", SampleType::Int32, i32);
    check("u32", SampleType::Float64, u32);
    check("f32", SampleType::Float32, f32);
    check("f64", SampleType::Float64, f64);
    check("i64", SampleType::Float64, i64);
    QCOMPARE(channelNamed(set->shots[0], "f64")->samples.isInMemory(), compressed);
}

void TestMat::matrix_columnsAreChannels_orRowsIfWide()
{
    std::vector<double> values;
    for (int k = 0; k < 36; ++k)
        values.push_back(k * k % 17);
    for (const bool compressed : {false, true}) {
        const QByteArray file = Mat5()
                                    .add("tall", kMiDouble, values, {12, 3}, kDouble, compressed)
                                    .add("wide", kMiDouble, values, {3, 12}, kDouble, compressed)
                                    .bytes();
        const auto set = readBytes(file);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(6));
        for (std::size_t c = 0; c < 3; ++c) {
            const Channel *tall = channelNamed(set->shots[0], "tall " + std::to_string(c + 1));
            const Channel *wide = channelNamed(set->shots[0], "wide " + std::to_string(c + 1));
            QVERIFY(tall != nullptr && wide != nullptr);
            for (std::size_t k = 0; k < 12; ++k) {
                QCOMPARE(tall->samples.at(static_cast<Index>(k)), values[12 * c + k]);
                QCOMPARE(wide->samples.at(static_cast<Index>(k)), values[3 * k + c]);
            }
        }
    }
}

void TestMat::smallElement_isRead()
{
    const auto set = readBytes(Mat5().add<std::int8_t>("y", kMiInt8, {1, -2, 3}).bytes());
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots[0].channels[0].samples.at(1), -2.0);
}

void TestMat::longIntegers_thatDoubleCannotHold_areRefused()
{
    const auto set
        = readBytes(Mat5().add<std::int64_t>("y", kMiInt64, {1, (1LL << 53) + 2, 3}).bytes());
    QCOMPARE(findingId(set), std::string("CAP-001"));
    QVERIFY(contains(sentence(set), "64-bit"));
}

void TestMat::level4_everyNumberAndOrder_isExact()
{
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        const QByteArray file = mat4<double>("d", 0, {1.5, -2.0, 1e300, 4.0}, 4, order)
            + mat4<float>("f", 10, {1.5F, -2.0F}, 1, order)
            + mat4<std::int32_t>("i", 20, {1, -7}, 2, order)
            + mat4<std::int16_t>("s", 30, {1, -8}, 2, order)
            + mat4<std::uint16_t>("w", 40, {1, 65535}, 2, order)
            + mat4<std::uint8_t>("b", 50, {1, 255}, 2, order)
            + mat4<double>("word", 1, {72, 105}, 1, order)
            + mat4<double>("sparse", 2, {1, 1, 1, 2, 2, 1}, 2, order)
            + mat4<double>("z", 0, {1, 2}, 2, order, true) + mat4<double>("fs", 0, {5e6}, 1, order);
        const auto set = readBytes(file);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels.size(), std::size_t(6));
        const auto last = [&](const char *name) {
            const Channel *channel = channelNamed(set->shots[0], name);
            return channel->samples.at(channel->samples.size() - 1);
        };
        QCOMPARE(channelNamed(set->shots[0], "d")->samples.at(2), 1e300);
        QCOMPARE(last("f"), -2.0);
        QCOMPARE(last("i"), -7.0);
        QCOMPARE(last("s"), -8.0);
        QCOMPARE(last("w"), 65535.0);
        QCOMPARE(last("b"), 255.0);
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 5e6);
        QCOMPARE(set->findings.size(), std::size_t(1));
        QVERIFY(contains(english(set->findings[0].message), "word, sparse, z"));
    }
}

void TestMat::notSignals_areLeftOut()
{
    Mat5 file;
    file.add("y", kMiDouble, signal());
    file.add("z", kMiDouble, signal(4), {}, kDouble | kComplexFlag);
    file.add<std::uint8_t>("on", kMiUInt8, std::vector<std::uint8_t>(20, 1), {}, 9 | kLogicalFlag);
    file.add<std::uint16_t>("name", kMiUInt16, {65, 66, 67}, {1, 3}, kChar);
    file.add("meta", kMiDouble, signal(3), {1, 1}, kStruct);
    file.add("sp", kMiDouble, signal(3), {3, 3}, kSparse);
    file.add("cube", kMiDouble, signal(24), {4, 3, 2});
    file.add("gains", kMiDouble, signal(3));
    file.add("image", kMiDouble, std::vector<double>(257 * 300), {300, 257});
    file.add<double>("none", kMiDouble, {}, {0, 0});
    const auto set = readBytes(file.bytes());
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots[0].channels.size(), std::size_t(1));
    QCOMPARE(set->findings.size(), std::size_t(1));
    QCOMPARE(set->findings[0].id, std::string("CAP-026"));
    const std::string text = english(set->findings[0].message);
    for (const char *word : {"complex", "logical", "text", "struct", "sparse matrix",
             "3 dimensions", "few values", "256 columns"})
        QVERIFY2(contains(text, word), text.c_str());
    QVERIFY2(!contains(text, "none"), text.c_str());
}

void TestMat::unreadable_isRefusedBySentence_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("says");
    const QByteArray whole = Mat5().add("y", kMiDouble, signal()).bytes();
    const QByteArray packed = Mat5().add("y", kMiDouble, signal(2000), {}, kDouble, true).bytes();
    QTest::newRow("cut") << whole.chopped(1) << "CAP-018"
                         << "within its variable number 1";
    QTest::newRow("cut stream") << packed.chopped(1) << "CAP-018"
                                << "within its variable";
    QByteArray flipped = packed;
    flipped[flipped.size() - 1] = static_cast<char>(flipped.back() ^ 1); // of the checksum
    QTest::newRow("checksum") << flipped << "CAP-018"
                              << "does not expand";
    QTest::newRow("sizes") << Mat5().add("y", kMiDouble, signal(), {21, 1}).bytes() << "CAP-018"
                           << "contradicts itself";
    QTest::newRow("negative size")
        << Mat5().add("y", kMiDouble, signal(), {-20, -1}).bytes() << "CAP-018"
        << "contradicts itself";
    QTest::newRow("no number") << Mat5().add("y", 77, signal()).bytes() << "CAP-018"
                               << "contradicts itself";
    QTest::newRow("element") << patched<std::uint32_t>(whole, 128, 99) << "CAP-018"
                             << "contradicts itself";
    QTest::newRow("header only") << Mat5().bytes() << "CAP-001"
                                 << "nothing that is a sampled signal";
    QTest::newRow("only a struct")
        << Mat5().add("m", kMiDouble, signal(1), {1, 1}, kStruct).bytes() << "CAP-001"
        << "nothing that is a sampled signal";
}

void TestMat::unreadable_isRefusedBySentence()
{
    checkRefusal(readBytes);
}

void TestMat::bombs_areRefusedAtOnce()
{
    QElapsedTimer timer;
    timer.start();
    const std::vector<std::vector<std::int32_t>> claims{{0x7FFFFFFF, 0x7FFFFFFF}, {0x7FFFFFFF, 1},
        {1 << 28, 1}, {1 << 16, 1 << 16, 1 << 16, 1 << 16}};
    for (const auto &sizes : claims) {
        for (const bool compressed : {false, true}) {
            const auto set = readBytes(
                Mat5().add("y", kMiDouble, signal(), sizes, kDouble, compressed).bytes());
            QCOMPARE(findingId(set), std::string("CAP-018"));
        }
    }
    // 400 MB of zeros in 400 kB.
    const QByteArray zeros(200 << 20, '\0');
    ByteWriter content;
    content.put<std::uint32_t>(kMiUInt32).put<std::uint32_t>(8).put<std::uint32_t>(kDouble);
    content.put<std::uint32_t>(0).put<std::uint32_t>(kMiInt32).put<std::uint32_t>(8);
    content.put<std::int32_t>(200 << 17).put<std::int32_t>(1);
    content.put<std::uint32_t>(1 << 16 | kMiInt8).raw("y").zeros(3);
    content.put<std::uint32_t>(kMiDouble).put<std::uint32_t>(200 << 20).raw(zeros);
    const QByteArray bomb = Mat5().addMatrix(content.bytes(), true).bytes();
    QVERIFY(bomb.size() < (1 << 20));
    timer.start(); // making it took longer than refusing it
    QCOMPARE(findingId(readBytes(bomb)), std::string("CAP-018"));
    QCOMPARE(
        findingId(readBytes(mat4<double>("y", 0, {1, 2}, 2).replace(4, 4, "\xFF\xFF\xFF\x7F"))),
        std::string("CAP-018"));
    QVERIFY(timer.elapsed() < kSlow_ms);
}

void TestMat::truncated_anywhere_isRefused()
{
    const QByteArray whole = Mat5()
                                 .add("y", kMiDouble, signal(9))
                                 .add<double>("fs", kMiDouble, {1e6}, {}, kDouble, true)
                                 .bytes();
    const qsizetype firstEnd = Mat5().add("y", kMiDouble, signal(9)).bytes().size();
    const Storm storm = truncateEverywhere(&readMat, whole, m_folder.filePath("cut.mat"));
    QCOMPARE(storm.wrong, 0);
    QCOMPARE(storm.read, 1); // exactly between the two variables nothing tells
    QVERIFY(readMat(write(m_folder.filePath("cut.mat"), whole.left(firstEnd)), {}, {}));
    const QByteArray old = mat4<double>("y", 0, signal(5), 5) + mat4<double>("fs", 0, {1e6}, 1);
    const Storm old4 = truncateEverywhere(&readMat, old, m_folder.filePath("cut.mat"));
    QCOMPARE(old4.wrong, 0);
    QCOMPARE(old4.read, 1);
}

void TestMat::mutants_neverCrash()
{
    const QList<QByteArray> seeds{
        Mat5()
            .add("t", kMiDouble, axis(0.0, 1e-6))
            .add("y", kMiInt16, std::vector<std::int16_t>(20, 5))
            .add("M", kMiDouble, joined(signal(), axis(0.0, 1e-3)), {20, 2})
            .bytes(),
        Mat5(std::endian::big).add("y", kMiDouble, signal(300), {100, 3}, kDouble, true).bytes(),
        mat4<double>("y", 0, signal(), 10) + mat4<double>("fs", 0, {1e6}, 1)};
    const Storm storm = mutate(&readMat, seeds, kMutants, m_folder.filePath("mutant.mat"));
    qInfo("%d read, %d refused, slowest %lld ms", storm.read, storm.refused,
        static_cast<long long>(storm.slowest_ms));
    QCOMPARE(storm.wrong, 0);
    QVERIFY(storm.slowest_ms < kSlow_ms);
    QVERIFY(storm.refused > kMutants / 10);
}

DYNCAL_TEST(TestMat)
#include "tst_mat.moc"

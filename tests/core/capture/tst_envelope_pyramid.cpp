// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/envelope_pyramid.h"
#include "core/capture/file_samples.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace dyncal;

namespace {

/// Extremes of `columns` stretches that divide [begin, end) evenly: column k begins at
/// begin + floor(k (end - begin) / columns).
std::optional<std::vector<SampleExtremes>> query(
    const EnvelopePyramid &pyramid, Index begin, Index end, Index columns)
{
    if (columns <= 0)
        return std::vector<SampleExtremes>();
    std::vector<Index> edges;
    edges.reserve(static_cast<std::size_t>(columns) + 1);
    // Quotient and remainder apart: k (end - begin) may be more than an Index holds.
    const Index whole = (end - begin) / columns;
    const Index rest = (end - begin) % columns;
    for (Index k = 0; k <= columns; ++k)
        edges.push_back(begin + k * whole + k * rest / columns);
    return pyramid.stretches(edges);
}

constexpr int kWindows = 10000;
constexpr Index kLevelTwo = EnvelopePyramid::kBaseBlock * EnvelopePyramid::kFanOut;
/// Not a multiple of any block, more than one block of a file that is read in blocks.
constexpr Index kLength = RawSamples::kBlock + 3 * kLevelTwo + 37;

/// Looks at every sample of the stretch.
template <typename T>
SampleExtremes bruteForce(const std::vector<T> &values, Index begin, Index end)
{
    SampleExtremes found;
    for (Index i = begin; i < end; ++i) {
        const auto value = static_cast<double>(values[static_cast<std::size_t>(i)]);
        if (!std::isfinite(value)) {
            found.invalid = true;
            continue;
        }
        found.min = found.any ? std::min(found.min, value) : value;
        found.max = found.any ? std::max(found.max, value) : value;
        found.any = true;
    }
    return found;
}

bool same(const SampleExtremes &a, const SampleExtremes &b)
{
    return a.any == b.any && a.invalid == b.invalid && a.min == b.min && a.max == b.max;
}

template <typename T>
std::vector<T> randomSamples(Index count, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::vector<T> values(static_cast<std::size_t>(count));
    for (T &value : values) {
        if constexpr (std::is_integral_v<T>)
            value = static_cast<T>(random()); // the whole range with both rails
        else
            value = static_cast<T>(std::normal_distribution<double>(0.0, 1e3)(random));
    }
    return values;
}

/// Single NaN and infinities, and runs of NaN that fill whole blocks.
template <typename T>
void spoil(std::vector<T> &values, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<std::size_t> where(0, values.size() - 1);
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const T infinity = std::numeric_limits<T>::infinity();
    for (int i = 0; i < 300; ++i) {
        values[where(random)] = nan;
        values[where(random)] = infinity;
        values[where(random)] = -infinity;
    }
    for (int run = 0; run < 20; ++run) {
        const std::size_t first = where(random);
        const std::size_t end = std::min(values.size(), first + where(random) % 3000);
        std::fill(values.begin() + static_cast<Index>(first),
            values.begin() + static_cast<Index>(end), run % 2 == 0 ? nan : infinity);
    }
}

} // namespace

/// The pyramid says of any stretch exactly what looking at each of its samples says.
class TestEnvelopePyramid : public QObject
{
    Q_OBJECT

private slots:
    void randomWindows_equalBruteForce_data();
    void randomWindows_equalBruteForce();
    void everyWindow_ofAShortRecord_equalsBruteForce();
    void columns_divideTheWindowEvenly();
    void spike_ofOneSample_isInItsColumnOnly();
    void spike_atBlockEdges_isFoundFromBothSides();
    void rails_ofEveryIntegerType_areKept();
    void notFiniteBlocks_areNoNumbers();
    void record_empty_givesNothing();
    void edges_emptyAndSingle_giveEmptyStretches();
    void edgesAtBlocks_readNothing();
    void memory_isFivePercentAtMost();
    void build_stopped_isCancelled();
    void build_progress_risesToOne();
    void file_changed_saysSo();

private:
    QString write(const void *data, Index bytes)
    {
        const QString path = m_folder.filePath(QString("f%1").arg(++m_files));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly)
            || file.write(static_cast<const char *>(data), bytes) != bytes)
            qFatal("cannot write");
        return path;
    }

    template <typename T>
    RawSamples inFile(const std::vector<T> &values)
    {
        const SampleType type = RawSamples(values).type();
        const QString path
            = write(values.data(), std::ssize(values) * static_cast<Index>(sizeof(T)));
        const auto file = SampleFile::open(path.toStdString());
        return *samplesInFile(
            *file, {type, std::endian::little, 0, {{0, static_cast<Index>(values.size())}}});
    }

    template <typename T>
    void compareWindows(const std::vector<T> &values, const RawSamples &samples, unsigned seed);
    template <typename T>
    void compareRecord(bool file, bool spoiled);

    QTemporaryDir m_folder;
    int m_files = 0;
};

template <typename T>
void TestEnvelopePyramid::compareWindows(
    const std::vector<T> &values, const RawSamples &samples, unsigned seed)
{
    const auto pyramid = EnvelopePyramid::build(samples);
    QVERIFY(pyramid.has_value());
    QVERIFY(same(pyramid->extremes(), bruteForce(values, 0, pyramid->size())));
    std::mt19937_64 random(seed);
    const auto below
        = [&](Index n) { return std::uniform_int_distribution<Index>(0, n - 1)(random); };
    int mismatches = 0;
    for (int window = 0; window < kWindows; ++window) {
        // Lengths of all orders of magnitude, with a few columns each.
        const Index longest = std::max<Index>(1, pyramid->size() >> (2 + below(19)));
        const Index begin = below(pyramid->size());
        const Index end = std::min(pyramid->size(), begin + below(longest) + (window % 5 != 0));
        const Index columns = 1 + below(4);
        const auto found = query(*pyramid, begin, end, columns);
        QVERIFY(found.has_value());
        QCOMPARE(std::ssize(*found), columns);
        for (Index k = 0; k < columns; ++k) {
            const Index from = begin + k * (end - begin) / columns;
            const Index to = begin + (k + 1) * (end - begin) / columns;
            const auto column = static_cast<std::size_t>(k);
            mismatches += same((*found)[column], bruteForce(values, from, to)) ? 0 : 1;
        }
    }
    QCOMPARE(mismatches, 0);
}

template <typename T>
void TestEnvelopePyramid::compareRecord(bool file, bool spoiled)
{
    std::vector<T> values = randomSamples<T>(kLength, 7);
    if constexpr (std::is_floating_point_v<T>) {
        if (spoiled)
            spoil(values, 8);
    }
    compareWindows(values, file ? inFile(values) : RawSamples(values), 9);
}

void TestEnvelopePyramid::randomWindows_equalBruteForce_data()
{
    QTest::addColumn<int>("type");
    QTest::addColumn<bool>("file");
    QTest::addColumn<bool>("spoiled");
    const auto add = [](const char *name, SampleType type, bool spoiled) {
        QTest::addRow("%s in memory", name) << static_cast<int>(type) << false << spoiled;
        QTest::addRow("%s in a file", name) << static_cast<int>(type) << true << spoiled;
    };
    add("int16", SampleType::Int16, false);
    add("int8", SampleType::Int8, false);
    add("uint8", SampleType::UInt8, false);
    add("uint16", SampleType::UInt16, false);
    add("int32", SampleType::Int32, false);
    add("float", SampleType::Float32, false);
    add("float with NaN and infinities", SampleType::Float32, true);
    add("double", SampleType::Float64, false);
    add("double with NaN and infinities", SampleType::Float64, true);
}

void TestEnvelopePyramid::randomWindows_equalBruteForce()
{
    QFETCH(int, type);
    QFETCH(bool, file);
    QFETCH(bool, spoiled);
    switch (static_cast<SampleType>(type)) {
    case SampleType::Int16:
        return compareRecord<std::int16_t>(file, spoiled);
    case SampleType::Int8:
        return compareRecord<std::int8_t>(file, spoiled);
    case SampleType::UInt8:
        return compareRecord<std::uint8_t>(file, spoiled);
    case SampleType::UInt16:
        return compareRecord<std::uint16_t>(file, spoiled);
    case SampleType::Int32:
        return compareRecord<std::int32_t>(file, spoiled);
    case SampleType::Float32:
        return compareRecord<float>(file, spoiled);
    case SampleType::Float64:
        return compareRecord<double>(file, spoiled);
    }
}

void TestEnvelopePyramid::everyWindow_ofAShortRecord_equalsBruteForce()
{
    for (const Index count : {Index(1), Index(2), Index(63), Index(64), Index(65), Index(300)}) {
        const auto values = randomSamples<std::int16_t>(count, static_cast<unsigned>(count));
        const auto pyramid = EnvelopePyramid::build(RawSamples(values));
        QVERIFY(pyramid.has_value());
        for (Index begin = 0; begin <= count; ++begin)
            for (Index end = begin; end <= count; ++end)
                QVERIFY(
                    same(query(*pyramid, begin, end, 1)->front(), bruteForce(values, begin, end)));
    }
}

void TestEnvelopePyramid::columns_divideTheWindowEvenly()
{
    // As many columns as a screen has, of a window of no even length.
    const auto values = randomSamples<std::int16_t>(kLength, 3);
    const auto pyramid = EnvelopePyramid::build(RawSamples(values));
    const Index begin = 12345;
    const Index end = kLength - 4321;
    constexpr Index kColumns = 1600;
    const auto found = query(*pyramid, begin, end, kColumns);
    QCOMPARE(std::ssize(*found), kColumns);
    Index covered = begin;
    for (Index k = 0; k < kColumns; ++k) {
        const Index to = begin + (k + 1) * (end - begin) / kColumns;
        QVERIFY(same((*found)[static_cast<std::size_t>(k)], bruteForce(values, covered, to)));
        covered = to;
    }
    QCOMPARE(covered, end);
    // More columns than samples: each sample is in one, the others are empty.
    const auto few = query(*pyramid, 100, 103, 10);
    QCOMPARE(std::ranges::count_if(*few, [](const SampleExtremes &e) { return e.any; }), 3);
}

void TestEnvelopePyramid::spike_ofOneSample_isInItsColumnOnly()
{
    constexpr Index kColumns = 100;
    for (const Index spike : {Index(0), Index(777777), kLength - 1}) {
        std::vector<std::int16_t> values(static_cast<std::size_t>(kLength), 5);
        values[static_cast<std::size_t>(spike)] = 1000;
        const auto pyramid = EnvelopePyramid::build(RawSamples(values));
        QCOMPARE(pyramid->extremes().max, 1000.0);
        const auto found = *query(*pyramid, 0, kLength, kColumns);
        QCOMPARE(std::ranges::count(found, 1000.0, &SampleExtremes::max), 1);
        for (Index k = 0; k < kColumns; ++k) {
            const bool inside
                = k * kLength / kColumns <= spike && spike < (k + 1) * kLength / kColumns;
            QCOMPARE(found[static_cast<std::size_t>(k)].max, inside ? 1000.0 : 5.0);
        }
    }
}

void TestEnvelopePyramid::spike_atBlockEdges_isFoundFromBothSides()
{
    std::vector<std::int16_t> values(static_cast<std::size_t>(kLength), 0);
    constexpr Index kCoarse = kLevelTwo * EnvelopePyramid::kFanOut;
    for (const Index block : {EnvelopePyramid::kBaseBlock, kLevelTwo, kCoarse}) {
        for (const Index spike : {5 * block - 1, 5 * block, 5 * block + 1}) {
            values[static_cast<std::size_t>(spike)] = -9;
            const auto pyramid = EnvelopePyramid::build(inFile(values));
            for (Index begin = spike - 2; begin <= spike + 2; ++begin) {
                const bool inside = begin <= spike;
                QCOMPARE(query(*pyramid, begin, kLength, 1)->front().min, inside ? -9.0 : 0.0);
                QCOMPARE(query(*pyramid, 0, begin, 1)->front().min, inside ? 0.0 : -9.0);
            }
            values[static_cast<std::size_t>(spike)] = 0;
        }
    }
}

void TestEnvelopePyramid::rails_ofEveryIntegerType_areKept()
{
    const auto check = [this]<typename T>(T) {
        // The least number alone is what an empty range of maxima begins with.
        for (const T rail : {std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max()}) {
            const std::vector<T> values(200, rail);
            const auto pyramid = EnvelopePyramid::build(inFile(values));
            for (const auto &[begin, end] : {std::pair<Index, Index>{0, 200}, {3, 5}, {64, 128}}) {
                const SampleExtremes found = query(*pyramid, begin, end, 1)->front();
                QVERIFY(found.any && !found.invalid);
                QCOMPARE(found.min, static_cast<double>(rail));
                QCOMPARE(found.max, static_cast<double>(rail));
            }
        }
    };
    check(std::int8_t());
    check(std::uint8_t());
    check(std::int16_t());
    check(std::uint16_t());
    check(std::int32_t());
}

void TestEnvelopePyramid::notFiniteBlocks_areNoNumbers()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values(1000, nan);
    values[700] = 2.5;
    const auto pyramid = EnvelopePyramid::build(RawSamples(values));
    const auto found = *pyramid->stretches(std::vector<Index>{0, 64, 640, 704, 1000});
    QVERIFY(!found[0].any && found[0].invalid);
    QVERIFY(!found[1].any && found[1].invalid);
    QVERIFY(found[2].any && found[2].invalid);
    QCOMPARE(found[2].min, 2.5);
    QCOMPARE(found[2].max, 2.5);
    QVERIFY(!found[3].any);
}

void TestEnvelopePyramid::record_empty_givesNothing()
{
    for (const RawSamples &samples : {RawSamples(), RawSamples(std::vector<double>())}) {
        const auto pyramid = EnvelopePyramid::build(samples);
        QVERIFY(pyramid.has_value());
        QVERIFY(!pyramid->extremes().any);
        QCOMPARE(pyramid->memory_bytes(), Index(0));
        QVERIFY(!query(*pyramid, 0, 0, 1)->front().any);
    }
    QVERIFY(!EnvelopePyramid().extremes().any);
    QVERIFY(EnvelopePyramid().stretches({})->empty());
}

void TestEnvelopePyramid::edges_emptyAndSingle_giveEmptyStretches()
{
    const auto pyramid = EnvelopePyramid::build(RawSamples(randomSamples<std::int16_t>(500, 1)));
    QVERIFY(pyramid->stretches({})->empty());
    QVERIFY(pyramid->stretches(std::vector<Index>{7})->empty());
    QVERIFY(query(*pyramid, 0, 500, 0)->empty());
    const auto found = *pyramid->stretches(std::vector<Index>{0, 0, 64, 64, 70, 70, 500, 500});
    QCOMPARE(found.size(), std::size_t(7));
    for (const std::size_t empty : {0, 2, 4, 6})
        QVERIFY(!found[empty].any);
    for (const std::size_t full : {1, 3, 5})
        QVERIFY(found[full].any);
}

void TestEnvelopePyramid::edgesAtBlocks_readNothing()
{
    // The file goes away after the pyramid is built: what needs no reading is still answered.
    const auto values = randomSamples<std::int16_t>(1000, 2);
    const RawSamples samples = inFile(values);
    const auto pyramid = EnvelopePyramid::build(samples);
    QVERIFY(QFile(m_folder.filePath(QString("f%1").arg(m_files))).resize(10));
    const auto found = pyramid->stretches(std::vector<Index>{0, 128, 640, 1000});
    QVERIFY(found.has_value());
    QVERIFY(same(found->back(), bruteForce(values, 640, 1000)));
    QVERIFY(same(pyramid->extremes(), bruteForce(values, 0, 1000)));
    QVERIFY(!pyramid->stretches(std::vector<Index>{0, 129}).has_value());
}

void TestEnvelopePyramid::memory_isFivePercentAtMost()
{
    const auto check = []<typename T>(T) {
        const auto pyramid = EnvelopePyramid::build(RawSamples(randomSamples<T>(kLength, 4)));
        const double raw = static_cast<double>(kLength) * sizeof(T);
        QVERIFY(static_cast<double>(pyramid->memory_bytes()) <= 0.05 * raw + 256.0);
    };
    check(std::int8_t());
    check(std::int16_t());
    check(float());
    check(double());
}

void TestEnvelopePyramid::build_stopped_isCancelled()
{
    const auto values = randomSamples<std::int16_t>(3 * RawSamples::kBlock, 5);
    for (const RawSamples &samples : {RawSamples(values), inFile(values)}) {
        std::stop_source stop;
        double reached = 0.0;
        const auto pyramid
            = EnvelopePyramid::build(samples, {stop.get_token(), [&](double fraction) {
                                                   reached = fraction;
                                                   stop.request_stop();
                                               }});
        QVERIFY(!pyramid.has_value());
        QCOMPARE(pyramid.error().kind, ErrorKind::Cancelled);
        QVERIFY(reached < 0.5); // not at the end only
    }
}

void TestEnvelopePyramid::build_progress_risesToOne()
{
    std::vector<double> fractions;
    const auto pyramid
        = EnvelopePyramid::build(RawSamples(std::vector<std::int8_t>(5 * RawSamples::kBlock)),
            {{}, [&](double fraction) { fractions.push_back(fraction); }});
    QVERIFY(pyramid.has_value());
    QVERIFY(fractions.size() >= 5);
    QVERIFY(std::ranges::is_sorted(fractions));
    QCOMPARE(fractions.back(), 1.0);
}

void TestEnvelopePyramid::file_changed_saysSo()
{
    const RawSamples samples = inFile(randomSamples<std::int16_t>(1000, 6));
    QVERIFY(QFile(m_folder.filePath(QString("f%1").arg(m_files))).resize(500));
    const auto pyramid = EnvelopePyramid::build(samples);
    QVERIFY(!pyramid.has_value());
    QCOMPARE(pyramid.error().kind, ErrorKind::FileUnreadable);
    QCOMPARE(pyramid.error().findingId, std::string("CAP-018"));
}

DYNCAL_TEST(TestEnvelopePyramid)
#include "tst_envelope_pyramid.moc"

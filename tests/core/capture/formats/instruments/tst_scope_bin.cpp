// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/instruments/scope_bin.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/formats/bytes/binary_test_support.h"
#include "tests/core/capture/formats/instruments/scope_bin_test_file.h"

using namespace dyncal;
using namespace dyncal::testing;
using namespace testing::scope_bin;

namespace {

/// Facts of the sample files as their screens' settings (.txt twins) and RigolWFM's tables of
/// expected values state them.
struct Known
{
    const char *name;
    std::size_t channels;
    Index points;
    double rate_Hz, t0_s;
    const char *model;
};
constexpr Known kKnown[] = {
    {"agilent_1.bin", 1, 2000, 2e6, -0.5e-3, "DSO-X 1102G"},
    {"agilent_2.bin", 1, 20000, 1e9, -10e-6, "DSO-X 1102G"},
    {"agilent_3.bin", 2, 4000, 2e9, -1e-6, "DSO-X 1102G"},
    {"DHO824-ch1.bin", 1, 10000, 2.5e6, -2e-3, "DHO824"},
    {"DHO824-ch12.bin", 2, 10000, 2.5e6, -2e-3, "DHO824"},
    {"DHO824-ch1234.bin", 4, 10000, 2.5e6, -2e-3, "DHO824"},
    {"MSO5000-A.bin", 4, 1000, 200e3, -2.5e-3, "MSO5XXX"},
};

/// Times in the headers carry single precision.
constexpr double kTimeTolerance = 1e-6;

} // namespace

/// Binary waveforms of Keysight and Rigol oscilloscopes.
class TestScopeBin : public QObject
{
    Q_OBJECT

private slots:
    void waveforms_ofEveryVersion_areExact_data();
    void waveforms_ofEveryVersion_areExact();
    void origin_ofRigol_isTheDistanceToTheTrigger();
    void interval_inSinglePrecision_isTheDecimalMeant();
    void segments_areShots();
    void sameLabelTwice_getsANumber();
    void headerLongerThanKnown_ofKeysight_isSkipped();
    void notSignals_areLeftOutByName();
    void impossibleInterval_isNoRate();
    void unreadable_isRefusedBySentence_data();
    void unreadable_isRefusedBySentence();
    void bombs_areRefusedAtOnce();
    void truncated_anywhere_isRefused();
    void mutants_neverCrash();
    void corpus_isReadOrRefused();

private:
    BytesReader readBytes{"bin"};
    QTemporaryDir m_folder;
};

void TestScopeBin::waveforms_ofEveryVersion_areExact_data()
{
    QTest::addColumn<QByteArray>("tag");
    QTest::addColumn<QString>("format");
    for (const char *tag : {"AG01", "AG03", "AG10"})
        QTest::newRow(tag) << QByteArray(tag) << "keysight-bin";
    for (const char *tag : {"RG01", "RG03"})
        QTest::newRow(tag) << QByteArray(tag) << "rigol-bin";
}

void TestScopeBin::waveforms_ofEveryVersion_areExact()
{
    QFETCH(QByteArray, tag);
    QFETCH(QString, format);
    Waveform second;
    second.label = "2";
    second.yUnit = 4;
    second.type = 3; // average
    second.buffers[0].values = {1.0F, 2.0F, 3.0F};
    const auto set = readBytes(file(tag, {Waveform{}, second}));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->inputs[0].format, format.toStdString());
    QVERIFY(set->findings.empty());
    QCOMPARE(set->instruments.at("oscilloscope").at("model"), std::string("DSO-X 3034T"));
    QCOMPARE(set->instruments.at("oscilloscope").at("serial"), std::string("MY12345678"));
    QCOMPARE(set->shots.size(), std::size_t(1));
    QCOMPARE(set->shots[0].notes.at("recorded"), std::string("12 NOV 2025 11:22:33"));
    const auto &channels = set->shots[0].channels;
    QCOMPARE(channels.size(), std::size_t(2));
    QCOMPARE(channels[0].name, std::string("1"));
    QCOMPARE(channels[0].unit, std::string("V"));
    QCOMPARE(channels[1].unit, std::string("A"));
    QCOMPARE(channels[0].sampleRate_Hz, 1e8);
    QCOMPARE(channels[0].samples.type(), SampleType::Float32);
    QVERIFY(!channels[0].samples.isInMemory());
    const Waveform first;
    for (Index k = 0; k < 4; ++k)
        QCOMPARE(physicalValues(channels[0], k, 1)[0],
            double(first.buffers[0].values[static_cast<std::size_t>(k)]));
    QCOMPARE(channels[1].samples.size(), Index(3));
    QCOMPARE(channels[1].samples.at(2), 3.0);
}

void TestScopeBin::origin_ofRigol_isTheDistanceToTheTrigger()
{
    Waveform wave;
    wave.origin_s = 0.002;
    const auto rigol = readBytes(file("RG03", {wave}));
    const auto keysight = readBytes(file("AG10", {wave}));
    QVERIFY(rigol && keysight);
    QCOMPARE(rigol->shots[0].channels[0].t0_s, -0.002);
    QCOMPARE(keysight->shots[0].channels[0].t0_s, 0.002);
}

void TestScopeBin::interval_inSinglePrecision_isTheDecimalMeant()
{
    Waveform wave;
    wave.interval_s = double(4e-7F); // 3.99999998990097e-07
    const auto set = readBytes(file("RG03", {wave}));
    QVERIFY(set.has_value());
    QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 1.0 / 4e-7);
}

void TestScopeBin::segments_areShots()
{
    std::vector<Waveform> waves;
    for (std::uint32_t segment = 1; segment <= 3; ++segment) {
        for (const char *label : {"1", "3"}) {
            Waveform wave;
            wave.segment = segment;
            wave.label = label;
            wave.buffers[0].values = {float(segment), 0.0F};
            waves.push_back(wave);
        }
    }
    const auto set = readBytes(file("AG10", waves));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) {
        QCOMPARE(set->shots[i].channels.size(), std::size_t(2));
        QCOMPARE(set->shots[i].channels[1].name, std::string("3"));
        QCOMPARE(set->shots[i].channels[0].samples.at(0), double(i + 1));
        QVERIFY(contains(set->shots[i].label, ", segment " + std::to_string(i + 1)));
    }
}

void TestScopeBin::sameLabelTwice_getsANumber()
{
    Waveform none;
    none.label = "";
    const auto set = readBytes(file("AG10", {Waveform{}, Waveform{}, none}));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    const auto &channels = set->shots[0].channels;
    QCOMPARE(channels[1].name, std::string("1 (2)"));
    QCOMPARE(channels[2].name, std::string("channel 3"));
}

void TestScopeBin::headerLongerThanKnown_ofKeysight_isSkipped()
{
    Waveform wave;
    wave.headerBytes = 156;
    const auto set = readBytes(file("AG10", {wave, wave}));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots[0].channels[1].samples.at(3), 7.0);
}

void TestScopeBin::notSignals_areLeftOutByName()
{
    Waveform digital;
    digital.label = "POD1";
    digital.type = 6;
    digital.buffers[0].type = 6;
    Waveform spectrum;
    spectrum.label = "FFT";
    spectrum.xUnit = 6;
    const auto set = readBytes(file("AG10", {digital, Waveform{}, spectrum}));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots[0].channels.size(), std::size_t(1));
    QCOMPARE(set->findings.size(), std::size_t(2));
    QCOMPARE(set->findings[0].id, std::string("CAP-026"));
    QCOMPARE(set->findings[0].channel, std::string("POD1"));
    QCOMPARE(set->findings[1].channel, std::string("FFT"));
    QCOMPARE(findingId(readBytes(file("AG10", {digital}))), std::string("CAP-001"));
}

void TestScopeBin::impossibleInterval_isNoRate()
{
    for (const double interval : {0.0, -1e-6, std::nan(""), 1e-320}) {
        Waveform wave;
        wave.interval_s = interval;
        const auto set = readBytes(file("AG10", {wave}));
        QVERIFY(set && hasFinding(set->findings, "CAP-016"));
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
    }
}

void TestScopeBin::unreadable_isRefusedBySentence_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("says");
    Waveform wave;
    wave.type = 2;
    QTest::newRow("peak detect") << file("AG10", {wave}) << "CAP-001"
                                 << "peak detect";
    wave = {};
    wave.headerBytes = 144;
    QTest::newRow("MSO5074") << file("RG01", {wave}) << "CAP-001"
                             << "144 bytes";
    wave = {};
    wave.points = 5;
    QTest::newRow("points") << file("AG10", {wave}) << "CAP-018"
                            << "number of points";
    wave = {};
    wave.points = 0;
    wave.buffers[0].values.clear();
    QTest::newRow("no points") << file("AG10", {wave}) << "CAP-018"
                               << "number of points";
    wave = {};
    wave.buffers[0].bytesPerPoint = 2;
    QTest::newRow("width") << file("AG10", {wave}) << "CAP-018"
                           << "bytes per point";
    wave = {};
    wave.origin_s = std::numeric_limits<double>::infinity();
    QTest::newRow("origin") << file("AG10", {wave}) << "CAP-018"
                            << "first point";
    QTest::newRow("channels") << file("AG10", std::vector<Waveform>(65)) << "CAP-018"
                              << "number of waveforms";
    QTest::newRow("nothing") << file("AG10", {}) << "CAP-001"
                             << "nothing that is a sampled signal";
    QTest::newRow("cut") << file("AG10", {Waveform{}}).chopped(5) << "CAP-018"
                         << "after 2 of the 4 samples of channel 1";
    QTest::newRow("tag only") << QByteArray("AG10") << "CAP-018"
                              << "before its first sample";
    QTest::newRow("RG10") << file("RG10", {Waveform{}}) << "CAP-001"
                          << "RG10";
}

void TestScopeBin::unreadable_isRefusedBySentence()
{
    checkRefusal(readBytes);
}

void TestScopeBin::bombs_areRefusedAtOnce()
{
    QElapsedTimer timer;
    timer.start();
    for (const char *tag : {"AG10", "AG03"}) {
        for (const std::uint64_t bytes : {0xFFFFFFFCULL, 1ULL << 46, 1ULL << 63, ~0ULL}) {
            Waveform wave;
            wave.points = 0xFFFFFFFF;
            wave.buffers[0].bytes = bytes;
            const auto set = readBytes(file(tag, {wave}));
            QCOMPARE(findingId(set), std::string("CAP-018"));
        }
    }
    const QByteArray many = patched<std::uint32_t>(file("AG10", {Waveform{}}), 8, 0xFFFFFFFF);
    QCOMPARE(findingId(readBytes(many)), std::string("CAP-018"));
    const QByteArray buffers = patched<std::uint32_t>(file("AG10", {Waveform{}}), 20, 0xFFFFFFFF);
    QCOMPARE(findingId(readBytes(buffers)), std::string("CAP-018"));
    QVERIFY(timer.elapsed() < kSlow_ms);
}

void TestScopeBin::truncated_anywhere_isRefused()
{
    const auto cut = [&](Reader reader, const QByteArray &whole) {
        const Storm storm = truncateEverywhere(reader, whole, m_folder.filePath("cut.bin"));
        QCOMPARE(storm.wrong, 0);
        QCOMPARE(storm.read, 0);
    };
    cut(&readKeysightBin, file("AG10", {Waveform{}, Waveform{}}));
    cut(&readRigolBin, file("RG03", {Waveform{}, Waveform{}}));
}

void TestScopeBin::mutants_neverCrash()
{
    Waveform segment;
    segment.segment = 2;
    const auto storm = [&](Reader reader, const QList<QByteArray> &seeds) {
        const Storm result = mutate(reader, seeds, kMutants, m_folder.filePath("mutant.bin"));
        qInfo("%d read, %d refused, slowest %lld ms", result.read, result.refused,
            static_cast<long long>(result.slowest_ms));
        QCOMPARE(result.wrong, 0);
        QVERIFY(result.slowest_ms < kSlow_ms);
        QVERIFY(result.refused > kMutants / 10);
    };
    storm(&readKeysightBin,
        {file("AG10", {Waveform{}, Waveform{}}), file("AG03", {Waveform{}, segment})});
    storm(&readRigolBin, {file("RG01", {Waveform{}}), file("RG03", {Waveform{}, Waveform{}})});
}

void TestScopeBin::corpus_isReadOrRefused()
{
    const QStringList files = corpusFiles("rigolwfm/files/bin", {".bin"});
    if (files.isEmpty())
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no folder rigolwfm: 0 files covered");
    int read = 0, refused = 0, known = 0;
    for (const QString &path : files) {
        const auto set = readCapture(path.toStdString(), {});
        if (!set) {
            QVERIFY2(
                findingId(set) == "CAP-018" || findingId(set) == "CAP-001", sentence(set).c_str());
            qInfo("refused (%s): %s", findingId(set).c_str(), sentence(set).c_str());
            ++refused;
            continue;
        }
        ++read;
        QCOMPARE(set->shots.size(), std::size_t(1));
        const auto fact = std::find_if(std::begin(kKnown), std::end(kKnown),
            [&](const Known &one) { return path.endsWith(one.name); });
        if (fact == std::end(kKnown))
            continue;
        ++known;
        QCOMPARE(set->instruments.at("oscilloscope").at("model"), std::string(fact->model));
        QCOMPARE(set->shots[0].channels.size(), fact->channels);
        const QByteArray bytes = bytesOf(path);
        const qsizetype head = bytes.startsWith("RG03") ? 16 : 12;
        const qsizetype perChannel = 140 + head + 4 * fact->points;
        for (std::size_t c = 0; c < fact->channels; ++c) {
            const Channel &channel = set->shots[0].channels[c];
            QCOMPARE(channel.samples.size(), fact->points);
            QCOMPARE(channel.sampleRate_Hz, fact->rate_Hz);
            QVERIFY(std::abs(channel.t0_s - fact->t0_s)
                <= kTimeTolerance * std::abs(fact->t0_s) + 0.5 / fact->rate_Hz);
            QCOMPARE(channel.unit, std::string("V"));
            const qsizetype end = head + qsizetype(c + 1) * perChannel;
            for (Index k = 0; k < fact->points; ++k) {
                float value = 0.0F;
                std::memcpy(&value, bytes.constData() + end - 4 * (fact->points - k), 4);
                QVERIFY(channel.samples.at(k) == double(value));
            }
        }
    }
    qInfo("Keysight and Rigol .bin: %d files, %d read (%d with known facts), %d refused",
        int(files.size()), read, known, refused);
    QCOMPARE(read + refused, int(files.size()));
    QVERIFY(known >= 3);
}

DYNCAL_TEST(TestScopeBin)
#include "tst_scope_bin.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/instruments/lecroy_trc.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/formats/bytes/binary_test_support.h"
#include "tests/core/capture/formats/instruments/lecroy_test_file.h"

using namespace dyncal;
using namespace dyncal::testing;
using namespace testing::lecroy;

namespace {

/// Values of RigolWFM's tables and of the headers' dump, converted by hand.
struct Known
{
    const char *name;
    std::size_t shots;
    Index points;
    double rate_Hz, t0_s, gain, offset;
    const char *channel, *model;
};
constexpr Known kKnown[] = {
    {"lecroy_2.trc", 1, 100002, 1e7, -0.0010000682217302932, 8.719309789739782e-07,
        0.33000001311302185, "C2", "LECROYWP254HD-MS"},
    {"lecroy_3.trc", 20, 502, 1e9, -3.645793678514268e-07, 0.00012499500007834285, 1.0, "C2",
        "LECROYWR64Xi-A"},
    {"lecroy_4.trc", 1, 502, 1e9, -1.2074500661794662e-07, 0.00012499500007834285, 1.0, "C2",
        "LECROYWR64Xi-A"},
    {"trace3.000", 1, 5002, 1e9, -1.5705740271654278e-06, 0.0001220703125, 0.7799999713897705,
        "Trace3", "LeCroy 7200 DSO"},
};

} // namespace

/// LeCroy waveforms of both templates.
class TestLecroyTrc : public QObject
{
    Q_OBJECT

private slots:
    void waveform_inEveryLayout_isExact_data();
    void waveform_inEveryLayout_isExact();
    void transferPrefix_andUserText_areSkipped();
    void sequence_segments_areShotsWithTheirOwnTrigger();
    void validPoints_only_areTaken();
    void oneFilePerChannel_isOneShot();
    void secondArray_isLeftOut();
    void impossibleInterval_isNoRate();
    void unreadable_isRefusedBySentence_data();
    void unreadable_isRefusedBySentence();
    void bombs_areRefusedAtOnce();
    void truncated_anywhere_isRefused();
    void mutants_neverCrash();
    void corpus_isReadOrRefused();

private:
    BytesReader readBytes{"trc"};
    QTemporaryDir m_folder;
};

void TestLecroyTrc::waveform_inEveryLayout_isExact_data()
{
    QTest::addColumn<QByteArray>("layout");
    QTest::addColumn<bool>("big");
    QTest::addColumn<bool>("words");
    for (const char *layout : {"LECROY_2_3", "LECROY_1_0"}) {
        for (const bool big : {false, true}) {
            for (const bool words : {false, true})
                QTest::addRow("%s %d %d", layout, big, words) << QByteArray(layout) << big << words;
        }
    }
}

void TestLecroyTrc::waveform_inEveryLayout_isExact()
{
    QFETCH(QByteArray, layout);
    QFETCH(bool, big);
    QFETCH(bool, words);
    Recipe recipe;
    recipe.layout = layout;
    recipe.order = big ? std::endian::big : std::endian::little;
    recipe.words = words;
    const auto set = readBytes(trc(recipe));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->inputs[0].format, std::string("lecroy-trc"));
    QVERIFY(set->findings.empty());
    QCOMPARE(set->shots.size(), std::size_t(1));
    QCOMPARE(set->shots[0].notes.at("recorded"), std::string("2025-02-03 14:05:07.25"));
    QCOMPARE(set->instruments.at("oscilloscope").at("model"), std::string("LECROYHDO6104"));
    QCOMPARE(set->instruments.at("oscilloscope").at("serial"), std::string("4711"));
    const Channel &channel = set->shots[0].channels.at(0);
    QCOMPARE(channel.name, std::string("C2"));
    QCOMPARE(channel.unit, std::string("V"));
    QCOMPARE(channel.sampleRate_Hz, 1.0 / 1e-9);
    QCOMPARE(channel.t0_s, -2.5e-6);
    QCOMPARE(channel.adcBits, 8);
    QVERIFY(!channel.adcMax);
    QVERIFY(!channel.samples.isInMemory());
    QCOMPARE(channel.samples.type(), words ? SampleType::Int16 : SampleType::Int8);
    QCOMPARE(channel.samples.size(), Index(6));
    for (Index k = 0; k < 6; ++k) {
        const double count = recipe.counts[static_cast<std::size_t>(k)];
        QCOMPARE(channel.samples.at(k), count);
        QCOMPARE(physicalValues(channel, k, 1)[0], double(0.001F) * count + 0.25);
    }
}

void TestLecroyTrc::transferPrefix_andUserText_areSkipped()
{
    Recipe recipe;
    recipe.prefix = "#9000000358";
    recipe.textBytes = 33;
    recipe.label = "PCB \xB5s";
    const auto set = readBytes(trc(recipe));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots[0].channels[0].samples.at(4), -128.0);
    QCOMPARE(set->shots[0].channels[0].name, std::string("PCB \xC2\xB5s"));
}

void TestLecroyTrc::sequence_segments_areShotsWithTheirOwnTrigger()
{
    Recipe recipe;
    recipe.segments = 3;
    recipe.triggers = {0.0, -1e-6, 0.5, -2e-6, 1.25, -3e-6};
    const auto set = readBytes(trc(recipe));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots.size(), std::size_t(3));
    for (std::size_t i = 0; i < 3; ++i) {
        const Channel &channel = set->shots[i].channels.at(0);
        QCOMPARE(channel.samples.size(), Index(2));
        QCOMPARE(channel.samples.at(1), double(recipe.counts[2 * i + 1]));
        QCOMPARE(channel.t0_s, recipe.triggers[2 * i + 1]);
    }
    QCOMPARE(set->shots[2].notes.at("trigger_time_s"), std::string("1.25"));
}

void TestLecroyTrc::validPoints_only_areTaken()
{
    Recipe recipe;
    recipe.firstValid = 2;
    recipe.lastValid = 4;
    const auto set = readBytes(trc(recipe));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    const Channel &channel = set->shots[0].channels[0];
    QCOMPARE(channel.samples.size(), Index(3));
    QCOMPARE(channel.samples.at(0), 100.0);
    QCOMPARE(channel.t0_s, -2.5e-6 + 2 * 1e-9);
}

void TestLecroyTrc::oneFilePerChannel_isOneShot()
{
    QStringList files;
    for (int channel = 1; channel <= 3; ++channel) {
        Recipe recipe;
        recipe.source = static_cast<std::int16_t>(channel - 1);
        recipe.counts[0] = static_cast<std::int16_t>(10 * channel);
        files << m_folder.filePath(QString("C%1Trace00012.trc").arg(channel));
        write(files.back(), trc(recipe));
    }
    const std::vector<std::string> paths{
        files[0].toStdString(), files[1].toStdString(), files[2].toStdString()};
    const auto set = readCaptures(paths, {});
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots.size(), std::size_t(1));
    QVERIFY(hasFinding(set->findings, "CAP-029"));
    for (std::size_t k = 0; k < 3; ++k) {
        const Channel &channel = set->shots[0].channels.at(k);
        QCOMPARE(channel.name, "C" + std::to_string(k + 1));
        QCOMPARE(channel.samples.at(0), 10.0 * double(k + 1));
        QVERIFY(!channel.sha256.empty() && !set->inputs[k].sha256.empty());
    }
    ImportSettings apart;
    apart.channelFiles = "apart";
    const auto shots = readCaptures(paths, apart);
    QCOMPARE(shots->shots.size(), std::size_t(3));
    QVERIFY(!hasFinding(shots->findings, "CAP-029"));
}

void TestLecroyTrc::secondArray_isLeftOut()
{
    Recipe recipe;
    recipe.wave2Bytes = 12;
    const auto set = readBytes(trc(recipe));
    QVERIFY(set && hasFinding(set->findings, "CAP-026"));
}

void TestLecroyTrc::impossibleInterval_isNoRate()
{
    for (const float interval : {0.0F, -1e-9F, std::nanf("")}) {
        Recipe recipe;
        recipe.interval = interval;
        const auto set = readBytes(trc(recipe));
        QVERIFY(set && hasFinding(set->findings, "CAP-016"));
        QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
    }
}

void TestLecroyTrc::unreadable_isRefusedBySentence_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, const char *id, const char *says, auto &&change) {
        Recipe recipe;
        change(recipe);
        QTest::newRow(name) << trc(recipe) << id << says;
    };
    row("template", "CAP-001", "template LECROY_2_2", [](Recipe &r) { r.layout = "LECROY_2_2"; });
    row("histogram", "CAP-001", "record type 2", [](Recipe &r) { r.recordType = 2; });
    row("spectrum", "CAP-001", "over \"Hz\"", [](Recipe &r) { r.horizontalUnit = "Hz"; });
    row("RIS", "CAP-001", "interleaved", [](Recipe &r) { r.risSweeps = 20; });
    row("sparse", "CAP-001", "sparse", [](Recipe &r) { r.sparsing = 4; });
    row("first point", "CAP-001", "sparse", [](Recipe &r) { r.firstPoint = 4; });
    row("offsets", "CAP-001", "two vertical offsets", [](Recipe &r) {
        r.layout = "LECROY_1_0";
        r.acquisitionOffset = 2.5F;
    });
    row("valid points of a sequence", "CAP-001", "invalid points", [](Recipe &r) {
        r.segments = 2;
        r.firstValid = 1;
    });
    row("count", "CAP-018", "WAVE_ARRAY_COUNT", [](Recipe &r) { r.count = 7; });
    row("negative", "CAP-018", "length of a block", [](Recipe &r) { r.wave1Bytes = -12; });
    row("segments", "CAP-018", "SUBARRAY_COUNT", [](Recipe &r) { r.segments = 4; });
    row("trigger times", "CAP-018", "TRIGTIME_ARRAY", [](Recipe &r) { r.segments = 2; });
    row("gain", "CAP-018", "VERTICAL_GAIN", [](Recipe &r) { r.gain = 0.0F; });
    row("valid", "CAP-018", "FIRST_VALID_PNT", [](Recipe &r) { r.lastValid = 6; });
    row("descriptor", "CAP-018", "WAVE_DESCRIPTOR", [](Recipe &r) { r.descriptorBytes = 12; });
    row("header only", "CAP-018", "after 0 of the 6 samples of channel C2", [](Recipe &r) {
        r.counts.clear();
        r.count = 6;
        r.wave1Bytes = 12;
    });
    QTest::newRow("cut") << trc({}).chopped(3) << "CAP-018"
                         << "after 4 of the 6";
}

void TestLecroyTrc::unreadable_isRefusedBySentence()
{
    checkRefusal(readBytes);
}

void TestLecroyTrc::bombs_areRefusedAtOnce()
{
    QElapsedTimer timer;
    timer.start();
    Recipe recipe;
    recipe.wave1Bytes = 0x7FFFFFFE;
    recipe.count = 0x3FFFFFFF;
    QCOMPARE(findingId(readBytes(trc(recipe))), std::string("CAP-018"));
    recipe.segments = 0x3FFFFFFF;
    recipe.triggerBytes = 0x7FFFFFFF;
    QCOMPARE(findingId(readBytes(trc(recipe))), std::string("CAP-018"));
    recipe = {};
    recipe.descriptorBytes = 0x7FFFFFFF;
    recipe.textBytes = 0;
    QCOMPARE(findingId(readBytes(trc(recipe))), std::string("CAP-018"));
    QVERIFY(timer.elapsed() < kSlow_ms);
}

void TestLecroyTrc::truncated_anywhere_isRefused()
{
    Recipe recipe;
    recipe.segments = 2;
    recipe.triggers = {0.0, -1e-6, 0.5, -2e-6};
    const Storm storm
        = truncateEverywhere(&readLecroyTrc, trc(recipe), m_folder.filePath("cut.trc"));
    QCOMPARE(storm.wrong, 0);
    QCOMPARE(storm.read, 0);
}

void TestLecroyTrc::mutants_neverCrash()
{
    Recipe old;
    old.layout = "LECROY_1_0";
    old.order = std::endian::big;
    Recipe sequence;
    sequence.segments = 2;
    sequence.triggers = {0.0, -1e-6, 0.5, -2e-6};
    const Storm storm = mutate(&readLecroyTrc, {trc({}), trc(old), trc(sequence)}, kMutants,
        m_folder.filePath("mutant.trc"));
    qInfo("%d read, %d refused, slowest %lld ms", storm.read, storm.refused,
        static_cast<long long>(storm.slowest_ms));
    QCOMPARE(storm.wrong, 0);
    QVERIFY(storm.slowest_ms < kSlow_ms);
    QVERIFY(storm.refused > kMutants / 10);
}

void TestLecroyTrc::corpus_isReadOrRefused()
{
    const QStringList files = corpusFiles("rigolwfm/files/trc", {".trc", ".000"});
    if (files.isEmpty())
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no folder rigolwfm: 0 files covered");
    int known = 0;
    const auto check = [&](const QString &path, const CaptureSet &set) {
        const auto fact = std::find_if(std::begin(kKnown), std::end(kKnown),
            [&](const Known &one) { return path.endsWith(one.name); });
        if (fact == std::end(kKnown))
            return;
        ++known;
        QCOMPARE(set.instruments.at("oscilloscope").at("model"), std::string(fact->model));
        QCOMPARE(set.shots.size(), fact->shots);
        const Channel &channel = set.shots[0].channels.at(0);
        QCOMPARE(channel.name, std::string(fact->channel));
        QCOMPARE(channel.samples.size(), fact->points);
        QCOMPARE(channel.sampleRate_Hz, fact->rate_Hz);
        QCOMPARE(channel.t0_s, fact->t0_s);
        QCOMPARE(channel.polynomial, (std::vector<double>{fact->offset, fact->gain}));
        // The samples are the last thing in these files (the old template ends with a newline).
        QByteArray bytes = bytesOf(path);
        if (bytes.size() % 2 == 1 && !path.endsWith(".trc"))
            bytes.chop(1);
        const qsizetype total = 2 * fact->points * static_cast<qsizetype>(fact->shots);
        for (std::size_t s = 0; s < fact->shots; ++s) {
            const qsizetype begin
                = bytes.size() - total + 2 * fact->points * static_cast<qsizetype>(s);
            for (Index k = 0; k < fact->points; ++k) {
                std::int16_t count = 0;
                std::memcpy(&count, bytes.constData() + begin + 2 * k, 2);
                QVERIFY(set.shots[s].channels[0].samples.at(k) == double(count));
            }
        }
    };
    readCorpus("LeCroy", files, {"CAP-001", "CAP-018"}, check);
    qInfo("LeCroy: %d with known facts", known);
    QVERIFY(known >= 2);
}

DYNCAL_TEST(TestLecroyTrc)
#include "tst_lecroy_trc.moc"

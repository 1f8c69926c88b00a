// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/instruments/wav.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/formats/bytes/binary_test_support.h"
#include "tests/core/capture/formats/instruments/wav_test_file.h"

using namespace dyncal;
using namespace dyncal::testing;
using namespace testing::riff;

/// WAV files: exact counts and scales, honest about lengths, never a guess.
class TestWav : public QObject
{
    Q_OBJECT

private slots:
    void integers_ofEveryWidth_keepTheirCounts_data();
    void integers_ofEveryWidth_keepTheirCounts();
    void floats_bothWidths_areExact();
    void validBits_fewerThanTheContainer_areTheUpperOnes();
    void longRecord_of24Bits_isReadInBlocks();
    void oddChunk_beforeTheFormat_isSkippedWithItsPad();
    void longFile_RF64_takesItsLengthFromDs64();
    void stream_withoutLength_isReadToItsEnd();
    void emptyData_inAWholeFile_isRefused();
    void cutCopy_keepsWholeFrames();
    void contradictingRate_isNoRate();
    void unreadable_isRefusedBySentence_data();
    void unreadable_isRefusedBySentence();
    void bombs_areRefusedAtOnce();
    void truncated_anywhere_neverCrashes();
    void mutants_neverCrash();
    void corpus_isReadOrRefused();

private:
    BytesReader readBytes{"wav"};
    QTemporaryDir m_folder;
};

void TestWav::integers_ofEveryWidth_keepTheirCounts_data()
{
    QTest::addColumn<QByteArray>("container");
    QTest::addColumn<int>("bytes");
    QTest::addColumn<bool>("extensible");
    for (const char *container : {"RIFF", "RIFX"}) {
        for (int bytes = 1; bytes <= 4; ++bytes) {
            for (const bool extensible : {false, true})
                QTest::addRow("%s %d %d", container, 8 * bytes, extensible)
                    << QByteArray(container) << bytes << extensible;
        }
    }
}

void TestWav::integers_ofEveryWidth_keepTheirCounts()
{
    QFETCH(QByteArray, container);
    QFETCH(int, bytes);
    QFETCH(bool, extensible);
    Recipe recipe;
    recipe.container = container;
    recipe.bytes = bytes;
    recipe.bits = 8 * bytes;
    recipe.validBits = extensible ? recipe.bits : 0;
    recipe.channels = 3;
    const auto set = readBytes(wav(recipe));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->inputs[0].format, std::string("wav"));
    QVERIFY(set->findings.empty());
    QCOMPARE(set->shots.size(), std::size_t(1));
    QCOMPARE(set->shots[0].channels.size(), std::size_t(3));
    for (int c = 0; c < 3; ++c) {
        const Channel &channel = set->shots[0].channels[static_cast<std::size_t>(c)];
        QCOMPARE(channel.name, "channel " + std::to_string(c + 1));
        QCOMPARE(channel.sampleRate_Hz, 48000.0);
        QCOMPARE(channel.samples.size(), Index(recipe.frames));
        QVERIFY(channel.samples.isInteger());
        QVERIFY(!channel.samples.isInMemory());
        QCOMPARE(channel.adcBits, 8 * bytes);
        const double zero = bytes == 1 ? 128.0 : 0.0;
        const double full = std::ldexp(1.0, 8 * bytes - 1);
        QCOMPARE(*channel.adcMin, zero - full);
        QCOMPARE(*channel.adcMax, zero + full - 1.0);
        const Eigen::VectorXd values = physicalValues(channel, 0, recipe.frames);
        for (int k = 0; k < recipe.frames; ++k) {
            const auto count = static_cast<double>(countOf(recipe, k, c));
            QCOMPARE(channel.samples.at(k), count);
            QCOMPARE(values[k], (count - zero) / full); // powers of two: exact
        }
    }
}

void TestWav::floats_bothWidths_areExact()
{
    for (const char *container : {"RIFF", "RIFX"}) {
        for (const int bytes : {4, 8}) {
            Recipe recipe;
            recipe.container = container;
            recipe.tag = kFloat;
            recipe.bytes = bytes;
            recipe.bits = 8 * bytes;
            const auto set = readBytes(wav(recipe));
            QVERIFY2(set.has_value(), sentence(set).c_str());
            for (int c = 0; c < 2; ++c) {
                const Channel &channel = set->shots[0].channels[static_cast<std::size_t>(c)];
                const SampleType type = bytes == 4 ? SampleType::Float32 : SampleType::Float64;
                QCOMPARE(channel.samples.type(), type);
                QVERIFY(!channel.adcMax);
                for (int k = 0; k < recipe.frames; ++k)
                    QCOMPARE(physicalValues(channel, k, 1)[0], floatOf(k, c));
            }
        }
    }
}

void TestWav::validBits_fewerThanTheContainer_areTheUpperOnes()
{
    Recipe recipe;
    recipe.bytes = 4;
    recipe.bits = 32;
    recipe.validBits = 20;
    const auto set = readBytes(wav(recipe));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    const Channel &channel = set->shots[0].channels[0];
    QCOMPARE(channel.adcBits, 20);
    QCOMPARE(channel.adcMax.value(), std::ldexp(1.0, 31) - 4096.0);
    QCOMPARE(channel.polynomial[1], std::ldexp(1.0, -31));
}

void TestWav::longRecord_of24Bits_isReadInBlocks()
{
    Recipe recipe;
    recipe.bytes = 3;
    recipe.bits = 24;
    recipe.channels = 2;
    recipe.frames = 400000; // more than one buffer of 1 MiB
    const auto set = readBytes(wav(recipe));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    for (int c = 0; c < 2; ++c) {
        const RawSamples &samples = set->shots[0].channels[static_cast<std::size_t>(c)].samples;
        QCOMPARE(samples.type(), SampleType::Int32);
        Index next = 7;
        bool equal = true;
        QVERIFY(samples.visitBlocks(7, 399999, [&](auto values, Index first) {
            equal = equal && first == next;
            for (const auto value : values)
                equal = equal
                    && static_cast<std::int64_t>(value)
                        == countOf(recipe, static_cast<int>(next++), c);
        }));
        QVERIFY(equal);
        QCOMPARE(next, Index(399999));
    }
}

void TestWav::oddChunk_beforeTheFormat_isSkippedWithItsPad()
{
    Recipe recipe;
    recipe.before = ByteWriter().text("LIST").put<std::uint32_t>(5).raw("12345").zeros(1).bytes();
    const auto set = readBytes(wav(recipe));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots[0].channels[0].samples.at(1), 32767.0);
}

void TestWav::longFile_RF64_takesItsLengthFromDs64()
{
    for (const char *container : {"RF64", "BW64"}) {
        Recipe recipe;
        recipe.container = container;
        recipe.riffBytes = 0xFFFFFFFF;
        recipe.dataBytes = 0xFFFFFFFF;
        recipe.longBytes = 5 * 4; // one frame less than is there
        const auto set = readBytes(wav(recipe));
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QVERIFY(set->findings.empty());
        QCOMPARE(set->shots[0].channels[1].samples.size(), Index(5));
    }
}

void TestWav::stream_withoutLength_isReadToItsEnd()
{
    Recipe never;
    never.riffBytes = 0;
    never.dataBytes = 0;
    Recipe open;
    open.riffBytes = 0xFFFFFFFF;
    open.dataBytes = 0xFFFFFFFF;
    for (const Recipe &recipe : {never, open}) {
        const auto set = readBytes(wav(recipe));
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels[0].samples.size(), Index(6));
        QVERIFY(hasFinding(set->findings, "CAP-018"));
    }
}

void TestWav::emptyData_inAWholeFile_isRefused()
{
    Recipe recipe;
    recipe.dataBytes = 0;
    const auto set = readBytes(wav(recipe));
    QCOMPARE(findingId(set), std::string("CAP-018"));
}

void TestWav::cutCopy_keepsWholeFrames()
{
    const QByteArray whole = wav({});
    const auto set = readBytes(whole.chopped(3)); // within the last frame
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots[0].channels[1].samples.size(), Index(5));
    QVERIFY(hasFinding(set->findings, "CAP-018"));
    QVERIFY(contains(english(set->findings[0].message), "5 of the 6"));
}

void TestWav::contradictingRate_isNoRate()
{
    Recipe recipe;
    recipe.byteRateFactor = 2.0;
    const auto twice = readBytes(wav(recipe));
    QVERIFY(twice && hasFinding(twice->findings, "CAP-016"));
    QCOMPARE(twice->shots[0].channels[0].sampleRate_Hz, 0.0);
    recipe = {};
    recipe.rate_Hz = 0;
    const auto none = readBytes(wav(recipe));
    QVERIFY(none && hasFinding(none->findings, "CAP-016"));
    QCOMPARE(none->shots[0].channels[0].sampleRate_Hz, 0.0);
}

void TestWav::unreadable_isRefusedBySentence_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("says");
    Recipe recipe;
    recipe.tag = 6; // A-law
    recipe.bytes = 1;
    recipe.bits = 8;
    QTest::newRow("compressed") << wav(recipe) << "CAP-001"
                                << "format tag 6";
    recipe = {};
    recipe.bytes = 5;
    recipe.bits = 36;
    QTest::newRow("36 bits") << wav(recipe) << "CAP-001"
                             << "integers of 40 bits";
    recipe = {};
    recipe.bits = 24; // in two bytes
    QTest::newRow("bits") << wav(recipe) << "CAP-018"
                          << "bits per sample";
    recipe = {};
    recipe.channels = 0;
    QTest::newRow("no channels") << wav(recipe) << "CAP-018"
                                 << "bytes per frame";
    recipe = {};
    recipe.frames = 0;
    QTest::newRow("no samples") << wav(recipe) << "CAP-018"
                                << "before its first sample";
    recipe = {};
    recipe.channels = 257;
    QTest::newRow("channels") << wav(recipe) << "CAP-018"
                              << "number of channels";
    QByteArray noFormat = wav({});
    noFormat.replace("fmt ", "fmx ");
    QTest::newRow("no format") << noFormat << "CAP-018"
                               << "before its first sample";
    QTest::newRow("other RIFF") << QByteArray("RIFF\x10\0\0\0AVI LIST", 16) << "CAP-001"
                                << "RIFF";
}

void TestWav::unreadable_isRefusedBySentence()
{
    checkRefusal(readBytes);
}

void TestWav::bombs_areRefusedAtOnce()
{
    Recipe recipe;
    recipe.container = "RF64";
    recipe.dataBytes = 0xFFFFFFFF;
    recipe.longBytes = ~0ULL; // 16 EiB
    QElapsedTimer timer;
    timer.start();
    const auto set = readBytes(wav(recipe));
    QVERIFY(
        set && hasFinding(set->findings, "CAP-018")); // a cut copy of a huge file: what is there
    QCOMPARE(set->shots[0].channels[0].samples.size(), Index(6));
    QByteArray chunks;
    for (int i = 0; i < 20000; ++i)
        chunks += ByteWriter().text("JUNK").put<std::uint32_t>(0).bytes();
    recipe = {};
    recipe.before = chunks;
    QCOMPARE(findingId(readBytes(wav(recipe))), std::string("CAP-018"));
    QVERIFY(timer.elapsed() < kSlow_ms);
}

void TestWav::truncated_anywhere_neverCrashes()
{
    const Storm storm = truncateEverywhere(&readWav, wav({}), m_folder.filePath("cut.wav"));
    QCOMPARE(storm.wrong, 0);
    QCOMPARE(storm.read, 20); // from the first whole frame (4 bytes) on, 6 frames
    QVERIFY(storm.refused > 40);
}

void TestWav::mutants_neverCrash()
{
    QList<QByteArray> seeds{wav({})};
    Recipe recipe;
    recipe.container = "RIFX";
    recipe.bytes = 3;
    recipe.bits = 24;
    recipe.validBits = 20;
    seeds += wav(recipe);
    recipe = {};
    recipe.container = "RF64";
    recipe.dataBytes = 0xFFFFFFFF;
    recipe.longBytes = 24;
    seeds += wav(recipe);
    const Storm storm = mutate(&readWav, seeds, kMutants, m_folder.filePath("mutant.wav"));
    qInfo("%d read, %d refused, slowest %lld ms", storm.read, storm.refused,
        static_cast<long long>(storm.slowest_ms));
    QCOMPARE(storm.wrong, 0);
    QVERIFY(storm.slowest_ms < kSlow_ms);
    QVERIFY(storm.refused > kMutants / 10);
}

/// Values of the files by scipy (independent), as the physical full scale of 1; the others by name.
void TestWav::corpus_isReadOrRefused()
{
    const QStringList files = corpusFiles("wav_corpus", {".wav"});
    if (files.isEmpty())
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no folder wav_corpus: 0 files covered");
    const QString script = R"(
import sys, warnings, numpy as np
warnings.simplefilter('ignore')
from scipy.io import wavfile
rate, data = wavfile.read(sys.argv[1])
data = data.reshape(len(data), -1)
scale = 1.0 if data.dtype.kind == 'f' else float(np.iinfo(data.dtype).max) + 1.0
zero = 128.0 if data.dtype == np.uint8 else 0.0
if data.dtype == np.uint8: scale = 128.0
with open(sys.argv[2], 'wb') as out:
    np.array([rate, data.shape[0], data.shape[1]], '<f8').tofile(out)
    ((data.T.astype(float) - zero) / scale).astype('<f8').tofile(out)
)";
    int read = 0, refused = 0, compared = 0;
    for (const QString &file : files) {
        const auto set = readCapture(file.toStdString(), {});
        if (!set) {
            QVERIFY2(
                findingId(set) == "CAP-018" || findingId(set) == "CAP-001", sentence(set).c_str());
            qInfo("refused (%s): %s", findingId(set).c_str(), sentence(set).c_str());
            ++refused;
            continue;
        }
        ++read;
        const QString out = m_folder.filePath("scipy.f64");
        if (!runPython(script, {file, out}))
            continue;
        ++compared;
        const QByteArray bytes = bytesOf(out);
        std::vector<double> expected(static_cast<std::size_t>(bytes.size()) / sizeof(double));
        std::memcpy(expected.data(), bytes.data(), expected.size() * sizeof(double));
        const Shot &shot = set->shots[0];
        QCOMPARE(shot.channels[0].sampleRate_Hz, expected[0]);
        QCOMPARE(static_cast<double>(shot.channels.size()), expected[2]);
        std::size_t next = 3;
        for (const Channel &channel : shot.channels) {
            QCOMPARE(static_cast<double>(channel.samples.size()), expected[1]);
            const Eigen::VectorXd values = physicalValues(channel, 0, channel.samples.size());
            for (const double value : values)
                QCOMPARE(value, expected[next++]); // powers of two: exact
        }
    }
    qInfo("WAV: %d files, %d read (%d compared with scipy), %d refused", int(files.size()), read,
        compared, refused);
    QCOMPARE(read + refused, int(files.size()));
    QVERIFY(read >= 5);
}

DYNCAL_TEST(TestWav)
#include "tst_wav.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/instruments/rohde_bin.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/formats/bytes/binary_test_support.h"
#include "tests/core/capture/formats/instruments/rohde_test_file.h"

using namespace dyncal;
using namespace dyncal::testing;
using namespace testing::rohde;

/// Rohde & Schwarz waveforms: two files that belong together.
class TestRohdeBin : public QObject
{
    Q_OBJECT

private slots:
    void floats_ofSeveralChannels_areExact();
    void timesAndFloats_areExact();
    void counts_areScaledByTheDivisions();
    void folder_withBothFiles_isOneShot();
    void contradictingInterval_isNoRate();
    void unreadable_isRefusedBySentence_data();
    void unreadable_isRefusedBySentence();
    void payload_missingOrOfAnother_isRefused();
    void truncated_anywhere_isRefused();
    void mutants_neverCrash();
    void corpus_isReadOrRefused();
    void twins_writtenByTheOscilloscope_agree();

private:
    QString writePair(const QByteArray &description, const QByteArray &payload)
    {
        const QString stem = m_folder.filePath(QString("f%1").arg(++m_files));
        write(stem + ".Wfm.bin", payload);
        write(stem + ".bin", description);
        return stem + ".bin";
    }
    Result<CaptureSet> readPair(const Recipe &recipe)
    {
        return readCapture(writePair(description(recipe), payload(recipe)).toStdString(), {});
    }

    QTemporaryDir m_folder;
    int m_files = 0;
};

void TestRohdeBin::floats_ofSeveralChannels_areExact()
{
    for (const int channels : {1, 2, 3}) {
        Recipe recipe;
        recipe.channels = channels;
        const auto set = readPair(recipe);
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->inputs[0].format, std::string("rohde-bin"));
        QVERIFY(set->findings.empty());
        QCOMPARE(int(set->shots[0].channels.size()), channels);
        for (int c = 0; c < channels; ++c) {
            const Channel &channel = set->shots[0].channels[std::size_t(c)];
            QCOMPARE(channel.name,
                channels == 1 ? "CH3" : std::string("C").append(std::to_string(c + 2)) + "W1");
            QCOMPARE(channel.unit, std::string("V"));
            QCOMPARE(channel.sampleRate_Hz, 1.0 / 1.25e-6);
            QCOMPARE(channel.t0_s, -1e-3);
            QCOMPARE(channel.samples.size(), Index(8));
            QVERIFY(!channel.samples.isInMemory());
            for (int k = 0; k < 8; ++k)
                QCOMPARE(channel.samples.at(k), valueOf(k + 2, c)); // behind the settling ones
        }
    }
}

void TestRohdeBin::timesAndFloats_areExact()
{
    const auto set = readPair(withTimes());
    QVERIFY2(set.has_value(), sentence(set).c_str());
    for (int c = 0; c < 2; ++c) {
        for (int k = 0; k < 8; ++k)
            QCOMPARE(set->shots[0].channels[std::size_t(c)].samples.at(k), valueOf(k + 2, c));
    }
    Recipe shifted = withTimes();
    shifted.timeShift_s = 1e-6;
    QCOMPARE(findingId(readPair(shifted)), std::string("CAP-018"));
}

void TestRohdeBin::counts_areScaledByTheDivisions()
{
    const auto set = readPair(counts());
    QVERIFY2(set.has_value(), sentence(set).c_str());
    const Channel &channel = set->shots[0].channels.at(0);
    QCOMPARE(channel.samples.type(), SampleType::Int8);
    for (int k = 0; k < 8; ++k) {
        const double expected = (k - 3) * 0.4 * 10.0 / 250.0 + 0.5 + 2.0 * 0.4;
        QVERIFY(std::abs(physicalValues(channel, k, 1)[0] - expected) < 1e-12);
    }
    Recipe several = counts();
    several.channels = 2;
    QCOMPARE(findingId(readPair(several)), std::string("CAP-001"));
}

void TestRohdeBin::folder_withBothFiles_isOneShot()
{
    QTemporaryDir folder;
    write(folder.filePath("shot.Wfm.bin"), payload({}));
    write(folder.filePath("shot.bin"), description({}));
    const auto set = readCaptures({folder.path().toStdString()}, {});
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->shots.size(), std::size_t(1));
    QCOMPARE(set->findings.size(), std::size_t(1));
    QCOMPARE(set->findings[0].severity, Severity::Info);
    const auto alone = readCapture(folder.filePath("shot.Wfm.bin").toStdString(), {});
    QVERIFY2(contains(sentence(alone), "shot.bin, which describes"), sentence(alone).c_str());
}

void TestRohdeBin::contradictingInterval_isNoRate()
{
    Recipe recipe;
    recipe.stopFactor = 2.0;
    const auto set = readPair(recipe);
    QVERIFY(set && hasFinding(set->findings, "CAP-003"));
    QCOMPARE(set->shots[0].channels[0].sampleRate_Hz, 0.0);
}

void TestRohdeBin::unreadable_isRefusedBySentence_data()
{
    QTest::addColumn<QByteArray>("description");
    QTest::addColumn<QByteArray>("payload");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, const char *id, const char *says, auto &&change) {
        Recipe recipe;
        change(recipe);
        QTest::newRow(name) << description(recipe) << payload(recipe) << id << says;
    };
    row("history", "CAP-001", "history of 500", [](Recipe &r) { r.acquisitions = "500"; });
    row("16 bits", "CAP-001", "INT16BIT", [](Recipe &r) { r.format = "INT16BIT"; });
    row("envelope", "CAP-001", "ENVELOPE", [](Recipe &r) { r.trace = "ENVELOPE"; });
    row("spectrum", "CAP-001", "over \"Hz\"", [](Recipe &r) { r.timeUnit = "Hz"; });
    row("lengths", "CAP-018", "RecordLength", [](Recipe &r) { r.length = 11; });
    row("no length", "CAP-018", "RecordLength", [](Recipe &r) { r.length = 0; });
    row("rows", "CAP-018", "SignalHardwareRecordLength", [](Recipe &r) { r.rowsText = "1e30"; });
    row("start", "CAP-018", "XStart", [](Recipe &r) { r.start_s = std::nan(""); });
    row("other payload", "CAP-018", "does not hold the samples", [](Recipe &r) { r.code = 6; });
    QTest::newRow("cut payload") << description({}) << payload({}).chopped(1) << "CAP-018"
                                 << "after 11 of the 12 samples";
}

void TestRohdeBin::unreadable_isRefusedBySentence()
{
    QFETCH(QByteArray, description);
    QFETCH(QByteArray, payload);
    QFETCH(QString, id);
    QFETCH(QString, says);
    const auto set = readCapture(writePair(description, payload).toStdString(), {});
    QCOMPARE(findingId(set), id.toStdString());
    QVERIFY2(contains(sentence(set), says.toStdString()), sentence(set).c_str());
}

void TestRohdeBin::payload_missingOrOfAnother_isRefused()
{
    const std::string path = write(m_folder.filePath("alone.bin"), description({}));
    const auto set = readCapture(path, {});
    QCOMPARE(findingId(set), std::string("CAP-018"));
    QVERIFY2(
        contains(sentence(set), "alone.Wfm.bin, which cannot be opened"), sentence(set).c_str());
    Recipe bomb;
    bomb.rows = 12;
    bomb.rowsText = "4294967295";
    const QByteArray claims = patched<std::uint32_t>(payload(bomb), 4, 0xFFFFFFFF);
    QElapsedTimer timer;
    timer.start();
    const auto huge = readCapture(writePair(description(bomb), claims).toStdString(), {});
    QCOMPARE(findingId(huge), std::string("CAP-018"));
    QVERIFY(timer.elapsed() < kSlow_ms);
}

void TestRohdeBin::truncated_anywhere_isRefused()
{
    const QString pair = writePair(description({}), payload({}));
    const Storm ofDescription = truncateEverywhere(&readRohdeBin, description({}), pair);
    QCOMPARE(ofDescription.wrong, 0);
    QCOMPARE(ofDescription.read, 0);
    const QByteArray whole = payload({});
    for (qsizetype size = 0; size < whole.size(); ++size) {
        const QString cut = writePair(description({}), whole.left(size));
        QCOMPARE(findingId(readRohdeBin(cut.toStdString(), {}, {})), std::string("CAP-018"));
    }
}

void TestRohdeBin::mutants_neverCrash()
{
    Recipe recipe;
    recipe.channels = 2;
    const QString pair = writePair(description(recipe), payload(recipe));
    const Storm storm = mutate(&readRohdeBin, {description(recipe)}, kMutants, pair);
    qInfo("%d read, %d refused, slowest %lld ms", storm.read, storm.refused,
        static_cast<long long>(storm.slowest_ms));
    QCOMPARE(storm.wrong, 0);
    QVERIFY(storm.slowest_ms < kSlow_ms);
    std::mt19937 random(7);
    rewrite(pair, description(withTimes()));
    for (int i = 0; i < kMutants; ++i) {
        const QString path = pair.chopped(4) + ".Wfm.bin";
        rewrite(path, mutant(payload(withTimes()), random));
        QVERIFY(outcomeOf(&readRohdeBin, pair.toStdString()) != Outcome::Wrong);
    }
}

void TestRohdeBin::corpus_isReadOrRefused()
{
    const QStringList files = corpusFiles("rigolwfm/files/rs", {".bin"});
    if (files.isEmpty())
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no folder rigolwfm: 0 files covered");
    const int read = readCorpus("Rohde & Schwarz", files, {"CAP-001"},
        [](const QString &, const CaptureSet &set) { QVERIFY(set.findings.empty()); });
    QVERIFY(read >= 3);
}

void TestRohdeBin::twins_writtenByTheOscilloscope_agree()
{
    int covered = 0;
    for (const QString &path : corpusFiles("rigolwfm/files/rs", {".Wfm.csv"})) {
        const auto set = readCapture((path.chopped(8) + ".bin").toStdString(), {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const auto &channels = set->shots[0].channels;
        QList<QByteArray> lines = bytesOf(path).split('\n');
        if (lines.last().trimmed().isEmpty())
            lines.removeLast();
        QCOMPARE(Index(lines.size()), channels[0].samples.size());
        for (Index k = 0; k < Index(lines.size()); ++k) {
            QList<QByteArray> cells = lines[k].trimmed().split(',');
            if (cells.size() > qsizetype(channels.size())) {
                const double time_s = cells.takeFirst().toDouble();
                QVERIFY(
                    std::abs(time_s - channels[0].timeOf_s(k)) < 1e-3 / channels[0].sampleRate_Hz);
            }
            QCOMPARE(cells.size(), qsizetype(channels.size()));
            for (std::size_t c = 0; c < channels.size(); ++c) {
                const double written = cells[qsizetype(c)].toDouble();
                const double value = physicalValues(channels[c], k, 1)[0];
                constexpr double kPrinted = 1e-5; // of six digits or more
                QVERIFY2(std::abs(value - written) <= kPrinted * std::abs(written) + 1e-12,
                    qPrintable(
                        QString("%1 row %2: %3, CSV %4").arg(path).arg(k).arg(value).arg(written)));
            }
        }
        ++covered;
    }
    qInfo("Rohde & Schwarz against the oscilloscope's CSV: %d files covered", covered);
    // The 8-bit record shows the same signal as the float one of the same settings.
    const QStringList bytes = corpusFiles("rigolwfm/files/rs", {"rs_rtp_03.bin"});
    for (const QString &path : bytes) {
        const auto set = readCapture(path.toStdString(), {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        QCOMPARE(set->shots[0].channels[0].samples.size(), Index(4000));
        QVERIFY(std::abs(set->shots[0].channels[0].polynomial[1] - 0.015810277) < 1e-9);
    }
    if (covered == 0)
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no folder rigolwfm: 0 files covered");
}

DYNCAL_TEST(TestRohdeBin)
#include "tst_rohde_bin.moc"

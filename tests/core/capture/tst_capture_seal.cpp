// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_seal.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"
#include "core/capture/file_samples.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/capture/opening/capture_open.h"
#include "tests/core/capture/capture_test_support.h"

#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

/// Three counts as little-endian bytes and the same counts in memory.
const QByteArray kBytes("\x01\x00\x02\x00\x03\x00", 6);
const std::vector<std::int16_t> kCounts{1, 2, 3};

/// One shot whose samples stay in a file of nothing but samples.
CaptureSet setInFile(const std::string &path)
{
    CaptureSet set;
    set.inputs = {stampedInput(path, "raw")};
    const auto file = SampleFile::open(path);
    SampleLayout layout;
    layout.extents = {{0, 3}};
    set.shots = {shotOf(kCounts)};
    set.shots[0].channels[0].samples = *samplesInFile(*file, layout);
    return set;
}

} // namespace

class TestCaptureSeal : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString file(const QString &name) const { return m_folder.filePath(name); }

private slots:
    void sealCaptures_samplesInAFile_hashesThemAndTheFile()
    {
        const std::string path = write(file("a.raw"), kBytes);
        const Result<CaptureSet> sealed = sealCaptures(setInFile(path));
        QVERIFY2(sealed.has_value(), sentence(sealed).c_str());
        // The file holds nothing but the samples, so both hashes are those of its bytes.
        const std::string expected = sha256Hex(std::string_view(kBytes.constData(), 6));
        QCOMPARE(sealed->shots[0].channels[0].sha256, expected);
        QCOMPARE(sealed->inputs[0].sha256, expected);
        QVERIFY(!sealed->shots[0].channels[0].samples.isInMemory());
        QVERIFY(sealed->findings.empty());
    }

    void sealCaptures_severalBlocks_isTheHashOfTheWhole()
    {
        CaptureSet set;
        set.shots = {shotOf(std::vector<std::int16_t>(RawSamples::kBlock + 5, 7))};
        const RawSamples samples = set.shots[0].channels[0].samples;
        QCOMPARE(sealCaptures(set)->shots[0].channels[0].sha256, sha256OfSamples(samples));
    }

    void sealCaptures_sealedSet_isUnchanged()
    {
        CaptureSet set;
        set.shots = {shotOf(kCounts)};
        set.shots[0].channels[0].sha256 = "known";
        QCOMPARE(sealCaptures(set)->shots[0].channels[0].sha256, std::string("known"));
    }

    void sealCaptures_statedHashAgrees_passes()
    {
        CaptureSet set;
        set.shots = {shotOf(kCounts)};
        Channel &channel = set.shots[0].channels[0];
        channel.statedSha256 = sha256OfSamples(channel.samples);
        QVERIFY(sealCaptures(set).has_value());
    }

    void sealCaptures_statedHashDiffers_isDamaged()
    {
        const std::string path = write(file("damaged.raw"), kBytes);
        CaptureSet set = setInFile(path);
        set.shots[0].channels[0].statedSha256 = std::string(64, '0');
        const Result<CaptureSet> sealed = sealCaptures(set);
        QCOMPARE(sealed.error().kind, ErrorKind::FileUnreadable);
        QCOMPARE(findingId(sealed), std::string("CAP-018"));
        QCOMPARE(sealed.error().shot, Index(1));
        QVERIFY(contains(sentence(sealed), path));
        QVERIFY(contains(sentence(sealed), "damaged"));
        QVERIFY(contains(sentence(sealed), "DUT"));
    }

    void checkStillWhole_data()
    {
        QTest::addColumn<QString>("change");
        QTest::addColumn<bool>("isWhole");
        QTest::newRow("left alone") << "" << true;
        QTest::newRow("moved") << "mv used.raw other.raw" << false;
        QTest::newRow("removed") << "rm used.raw" << false;
        QTest::newRow("permissions") << "chmod 0600 used.raw && chmod 0400 used.raw" << false;
        QTest::newRow("appended") << "printf xx >> used.raw" << false;
        QTest::newRow("in place, time kept")
            << "touch -r used.raw t && printf xx | dd of=used.raw conv=notrunc && touch -r t used.raw"
            << false;
    }

    void checkStillWhole()
    {
        QFETCH(QString, change);
        QFETCH(bool, isWhole);
        const std::string path = write(file("used.raw"), kBytes);
        const CaptureSet set = *sealCaptures(setInFile(path));
        QTest::qWait(20); // file systems count time in ticks
        QProcess shell;
        shell.setWorkingDirectory(m_folder.path());
        shell.start("sh", {"-c", change});
        QVERIFY(shell.waitForFinished());
        QCOMPARE(shell.exitCode(), 0);
        const Result<void> whole = dyncal::checkStillWhole(set);
        QCOMPARE(whole.has_value(), isWhole);
        if (isWhole)
            return;
        QCOMPARE(whole.error().kind, ErrorKind::FileUnreadable);
        QCOMPARE(whole.error().findingId, std::string("CAP-015"));
        QVERIFY(english(whole.error().message).find(path) != std::string::npos);
    }

    void checkStillWhole_samplesInMemory_needNoFile()
    {
        CaptureSet set;
        set.shots = {shotOf(kCounts)};
        QVERIFY(dyncal::checkStillWhole(set).has_value());
    }

    void checkStillWhole_aReadThatFailed_isRemembered()
    {
        class Once : public SampleSource
        {
            bool read(Index, Index count, std::byte *target) const override
            {
                std::fill_n(target, 2 * count, std::byte());
                return std::exchange(m_works, true);
            }
            mutable bool m_works = false;
        };
        CaptureSet set;
        set.inputs.resize(1);
        set.shots = {shotOf(kCounts)};
        const RawSamples samples(std::make_shared<Once>(), SampleType::Int16, 3);
        set.shots[0].channels[0].samples = samples;
        QVERIFY(std::isnan(samples.at(0)));
        QCOMPARE(samples.at(0), 0.0);
        QVERIFY(!dyncal::checkStillWhole(set).has_value());
    }

    void sealCaptures_fileChangedSinceOpened_isCap015_data()
    {
        QTest::addColumn<QByteArray>("later");
        QTest::newRow("longer") << kBytes + "\x04";
        QTest::newRow("shorter") << kBytes.left(2);
        QTest::newRow("same length") << QByteArray("\x09\x00\x02\x00\x03\x00", 6);
    }

    void sealCaptures_fileChangedSinceOpened_isCap015()
    {
        QFETCH(QByteArray, later);
        const std::string path = write(file("changing.raw"), kBytes);
        const CaptureSet set = setInFile(path);
        write(file("changing.raw"), later);
        // File systems count time in ticks; the change must be told from the writing before.
        std::filesystem::last_write_time(
            path, std::filesystem::last_write_time(path) + std::chrono::seconds(1));
        const Result<CaptureSet> sealed = sealCaptures(set);
        QCOMPARE(findingId(sealed), std::string("CAP-015"));
        QVERIFY(contains(sentence(sealed), path));
    }

    void sealCaptures_samplesInMemoryButFileChangedWithItsTimeKept_isCap015()
    {
        const std::string path = write(file("kept.csv"), "1\n2\n");
        const auto time = std::filesystem::last_write_time(path);
        CaptureSet set;
        set.inputs = {stampedInput(path, "text")};
        set.shots = {shotOf(kCounts)};
        QTest::qWait(20); // file systems count time in ticks
        write(file("kept.csv"), "1\n3\n");
        std::filesystem::last_write_time(path, time);
        QCOMPARE(findingId(sealCaptures(set)), std::string("CAP-015"));
    }

    void sealCaptures_samplesInMemoryButFileChanged_isCap015()
    {
        const std::string path = write(file("table.csv"), "1\n2\n");
        CaptureSet set;
        set.inputs = {stampedInput(path, "text")};
        set.shots = {shotOf(kCounts)};
        write(file("table.csv"), "1\n2\n3\n");
        QCOMPARE(findingId(sealCaptures(set)), std::string("CAP-015"));
    }

    void sealCaptures_fileGone_isCap015()
    {
        const std::string path = write(file("gone.raw"), kBytes);
        const CaptureSet set = setInFile(path);
        QFile::remove(file("gone.raw"));
        QCOMPARE(findingId(sealCaptures(set)), std::string("CAP-015"));
    }

    void sealCaptures_stopRequested_isCancelled()
    {
        const CaptureSet set = setInFile(write(file("stop.raw"), kBytes));
        std::stop_source source;
        source.request_stop();
        const Result<CaptureSet> sealed = sealCaptures(set, {source.get_token(), {}});
        QCOMPARE(sealed.error().kind, ErrorKind::Cancelled);
    }

    void sealCaptures_progress_risesToOne()
    {
        const CaptureSet set = setInFile(write(file("progress.raw"), kBytes));
        std::vector<double> seen;
        JobControl control;
        control.progress = [&](double fraction) { seen.push_back(fraction); };
        QVERIFY(sealCaptures(set, control).has_value());
        QVERIFY(std::is_sorted(seen.begin(), seen.end()));
        QCOMPARE(seen.back(), 1.0);
    }

    void sealCaptures_equalInputs_areOneCautionHoweverOftenSealed()
    {
        CaptureSet set = setInFile(write(file("one.raw"), kBytes));
        CaptureSet copy = setInFile(write(file("two.raw"), kBytes));
        copy.shots[0].input = 1;
        set.inputs.push_back(copy.inputs[0]);
        set.shots.push_back(copy.shots[0]);
        const Result<CaptureSet> sealed = sealCaptures(*sealCaptures(set));
        QCOMPARE(sealed->findings.size(), std::size_t(1));
        QCOMPARE(sealed->findings[0].id, std::string("CAP-011"));
        QCOMPARE(sealed->findings[0].shot, Index(2));
    }

    void sealCaptures_otherBytesThanExpected_blockOnceHoweverOftenSealed()
    {
        CaptureSet set = setInFile(write(file("expected.raw"), kBytes));
        set.inputs[0].expectedSha256 = std::string(64, '0');
        reportUnexpected(set); // not known yet
        QVERIFY(set.findings.empty());
        const Result<CaptureSet> sealed = sealCaptures(*sealCaptures(set));
        QCOMPARE(sealed->findings.size(), std::size_t(1));
        QCOMPARE(sealed->findings[0].id, std::string("CAP-015"));
        QCOMPARE(sealed->findings[0].severity, Severity::Block);
        QVERIFY(english(sealed->findings[0].message).find("expected.raw") != std::string::npos);
        set.inputs[0].expectedSha256 = sealed->inputs[0].sha256;
        QVERIFY(sealCaptures(set)->findings.empty());
    }

    void sealCaptures_samplesAndFileAtFault_saysTheSamples()
    {
        // The hash of a long file is given up once the samples are known to be damaged.
        const std::string path = write(file("both.raw"), QByteArray(64 << 20, 'x'));
        CaptureSet set = setInFile(path);
        set.shots[0].channels[0].statedSha256 = "other";
        const Result<CaptureSet> sealed = sealCaptures(set);
        QCOMPARE(findingId(sealed), std::string("CAP-018"));
    }

    void openCaptures_capture_computesNoFileHashAndSealsToTheSameAsReading()
    {
        CaptureSet set;
        set.shots = {shotOf(kCounts)};
        const std::string path = file("capture.h5").toStdString();
        QVERIFY(writeHdf5Capture(set, {path, true}, "2026-01-02T03:04:05Z", "t").has_value());
        const Result<CaptureSet> opened = openCaptures({path}, {});
        QVERIFY2(opened.has_value(), sentence(opened).c_str());
        QVERIFY(opened->inputs[0].sha256.empty());
        const Result<CaptureSet> sealed = sealCaptures(*opened);
        const Result<CaptureSet> read = readCaptures({path}, {});
        QCOMPARE(sealed->inputs[0].sha256, sha256OfFile(path));
        QVERIFY(sealed->inputs == read->inputs);
        QCOMPARE(sealed->shots[0].channels[0].sha256, read->shots[0].channels[0].sha256);
        QVERIFY(!read->shots[0].channels[0].sha256.empty());
    }
};

DYNCAL_TEST(TestCaptureSeal)
#include "tst_capture_seal.moc"

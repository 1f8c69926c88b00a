// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/instruments/rigol_wfm.h"
#include "tests/support/test_program.h"

#include "tests/core/capture/formats/bytes/binary_test_support.h"
#include "tests/core/capture/formats/instruments/rigol_test_file.h"

using namespace dyncal;
using namespace dyncal::testing;
using namespace testing::rigol;

namespace {

/// The CSV that the oscilloscope wrote of the same record: time and one column per channel.
std::vector<std::vector<double>> columnsOfCsv(const QString &path)
{
    std::vector<std::vector<double>> columns;
    for (const QByteArray &line : bytesOf(path).split('\n')) {
        std::vector<double> row;
        for (const QByteArray &cell : line.trimmed().split(',')) {
            bool isNumber = false;
            const double value = cell.trimmed().toDouble(&isNumber);
            if (isNumber)
                row.push_back(value);
        }
        if (columns.empty())
            columns.resize(row.size());
        if (row.size() < 2 || row.size() != columns.size())
            continue;
        for (std::size_t c = 0; c < row.size(); ++c)
            columns[c].push_back(row[c]);
    }
    return columns;
}

} // namespace

/// Waveform memories of the Rigol families that CSV files of the oscilloscopes prove.
class TestRigolWfm : public QObject
{
    Q_OBJECT

private slots:
    void familyE_isScaledAsOnTheScreen();
    void familyB_keepsRoomForChannelsThatAreOff();
    void unreadable_isRefusedBySentence_data();
    void unreadable_isRefusedBySentence();
    void bombs_areRefusedAtOnce();
    void truncated_anywhere_isRefused();
    void mutants_neverCrash();
    void corpus_isReadOrRefused();
    void twins_writtenByTheOscilloscope_agree();

private:
    BytesReader readBytes{"wfm"};
    QTemporaryDir m_folder;
};

void TestRigolWfm::familyE_isScaledAsOnTheScreen()
{
    const auto set = readBytes(wfm({}));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->inputs[0].format, std::string("rigol-wfm"));
    QVERIFY(set->findings.empty());
    const auto &channels = set->shots[0].channels;
    QCOMPARE(channels.size(), std::size_t(2));
    for (std::size_t c = 0; c < 2; ++c) {
        const Setting setting = Recipe().channels[c];
        QCOMPARE(channels[c].name, "CH" + std::to_string(c + 1));
        QCOMPARE(channels[c].sampleRate_Hz, 2.5e6);
        QVERIFY(std::abs(channels[c].t0_s - (3e-6 - 32 / 2.5e6)) < 1e-15);
        QCOMPARE(channels[c].samples.type(), SampleType::UInt8);
        QVERIFY(!channels[c].samples.isInMemory());
        QCOMPARE(channels[c].unit, std::string("V"));
        const double volts = setting.scale_uV * 1e-6 * double(setting.probe) / 25.0;
        for (Index k = 0; k < 64; ++k) {
            const double count = countOf(c, static_cast<std::uint32_t>(k));
            QCOMPARE(channels[c].samples.at(k), count);
            const double expected = (125.0 - count) * volts - setting.shift * volts;
            QVERIFY(std::abs(physicalValues(channels[c], k, 1)[0] - expected) < 1e-12);
        }
    }
}

void TestRigolWfm::familyB_keepsRoomForChannelsThatAreOff()
{
    const auto set = readBytes(wfm(familyB()));
    QVERIFY2(set.has_value(), sentence(set).c_str());
    QCOMPARE(set->instruments.at("oscilloscope").at("model"), std::string("DS1204B"));
    const auto &channels = set->shots[0].channels;
    QCOMPARE(channels.size(), std::size_t(3));
    QCOMPARE(channels[1].name, std::string("CH3"));
    QCOMPARE(channels[1].samples.size(), Index(8192));
    QCOMPARE(channels[1].samples.at(5), double(countOf(2, 5)));
    QCOMPARE(channels[1].polynomial, (std::vector<double>{(99.0 + 40.0) * 0.2, -0.2}));
}

void TestRigolWfm::unreadable_isRefusedBySentence_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("says");
    const auto row = [](const char *name, const char *id, const char *says, auto &&change,
                         Recipe recipe = {}) {
        change(recipe);
        QTest::newRow(name) << wfm(recipe) << id << says;
    };
    row("inverted", "CAP-001", "inverted", [](Recipe &r) { r.channels[0].inverted = true; });
    row("rolling", "CAP-001", "rolling", [](Recipe &r) { r.rollStop = 5; });
    row("alternating", "CAP-001", "alternating", [](Recipe &r) { r.triggerMode = 4; });
    row("off", "CAP-001", "sampled signal",
        [](Recipe &r) { r.channels[0].enabled = r.channels[1].enabled = false; });
    row("no points", "CAP-001", "sampled signal", [](Recipe &r) { r.points = 0; });
    row("scale", "CAP-018", "volts per division", [](Recipe &r) { r.channels[0].scale_uV = 0; });
    row("probe", "CAP-018", "volts per division", [](Recipe &r) { r.channels[0].probe = -1.0F; });
    row(
        "memory", "CAP-001", "16384 points", [](Recipe &r) { r.points = 16384; }, familyB());
    QTest::newRow("logic") << wfm({}) + QByteArray(128, '\0') << "CAP-001"
                           << "with other data";
    QTest::newRow("cut") << wfm({}).chopped(100) << "CAP-018"
                         << "of the 64 samples";
    const auto family = [](const char *name, const char *begin, const char *says) {
        QTest::newRow(name) << QByteArray::fromHex(begin).leftJustified(500, '\0') << "CAP-001"
                            << says;
    };
    family("1000Z", "01FFFFFFA6A53800445331303534", "DS1000Z");
    family("2000", "A5A5380044533241", "DS2000");
    family("1000C", "A1A50000", "DS1000C");
    family("DHO", "0200000046", "DHO");
    family("Tektronix", "0F0F3A57464D23303033", "Tektronix");
}

void TestRigolWfm::unreadable_isRefusedBySentence()
{
    checkRefusal(readBytes);
}

void TestRigolWfm::bombs_areRefusedAtOnce()
{
    QElapsedTimer timer;
    timer.start();
    for (const std::uint32_t points : {0x7FFFFFFFU, 0xFFFFFFFFU}) {
        QCOMPARE(findingId(readBytes(patched(wfm({}), 28, points))), std::string("CAP-018"));
        QCOMPARE(findingId(readBytes(patched(wfm(familyB()), 60, points))), std::string("CAP-001"));
    }
    QVERIFY(timer.elapsed() < kSlow_ms);
}

void TestRigolWfm::truncated_anywhere_isRefused()
{
    const Storm storm = truncateEverywhere(&readRigolWfm, wfm({}), m_folder.filePath("cut.wfm"));
    QCOMPARE(storm.wrong, 0);
    QCOMPARE(storm.read, 0);
}

void TestRigolWfm::mutants_neverCrash()
{
    const Storm storm = mutate(
        &readRigolWfm, {wfm({}), wfm(familyB())}, kMutants, m_folder.filePath("mutant.wfm"));
    qInfo("%d read, %d refused, slowest %lld ms", storm.read, storm.refused,
        static_cast<long long>(storm.slowest_ms));
    QCOMPARE(storm.wrong, 0);
    QVERIFY(storm.slowest_ms < kSlow_ms);
    QVERIFY(storm.refused > kMutants / 10);
}

void TestRigolWfm::corpus_isReadOrRefused()
{
    const QStringList files = corpusFiles("rigolwfm/files/wfm", {".wfm"});
    if (files.isEmpty())
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no folder rigolwfm: 0 files covered");
    const int read = readCorpus(
        "Rigol .wfm", files, {"CAP-001", "CAP-018"}, [](const QString &, const CaptureSet &set) {
            QVERIFY(set.shots[0].channels.at(0).sampleRate_Hz > 0.0);
        });
    QVERIFY(read >= 6);
}

void TestRigolWfm::twins_writtenByTheOscilloscope_agree()
{
    int covered = 0;
    for (const QString &path :
        corpusFiles("rigolwfm/files/wfm", {"DS1204B-A.wfm", "DS1204B-F.wfm", "DS1102E-D.wfm"})) {
        const QString stem = path.chopped(4);
        const auto csv
            = columnsOfCsv(QFile::exists(stem + ".csv") ? stem + ".csv" : stem + "-original.csv");
        const auto set = readCapture(path.toStdString(), {});
        QVERIFY2(set.has_value(), sentence(set).c_str());
        const auto &channels = set->shots[0].channels;
        QCOMPARE(csv.size(), channels.size() + 1);
        const bool whole = path.contains("DS1204B"); // the DS1102E writes what its screen shows
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const Channel &channel = channels[c];
            const Eigen::VectorXd volts = physicalValues(channel, 0, channel.samples.size());
            if (whole)
                QCOMPARE(csv[0].size(), std::size_t(8192));
            double worst = 0.0;
            for (std::size_t row = 0; row < csv[0].size(); ++row) {
                const double at = (csv[0][row] - channel.t0_s) * channel.sampleRate_Hz;
                if (whole)
                    QVERIFY(std::abs(at - static_cast<double>(row)) < 0.01);
                const auto k = static_cast<Index>(std::lround(at));
                double nearest = std::abs(volts[k] - csv[c + 1][row]);
                for (Index side = k - 2; !whole && side <= k + 2; ++side)
                    nearest = std::min(nearest, std::abs(volts[side] - csv[c + 1][row]));
                worst = std::max(worst, nearest);
            }
            // The text has three digits and the counts are coarser; the screen shows averages.
            QVERIFY2(worst <= (whole ? 1e-9 : 1.0 + 1e-9) * std::abs(channel.polynomial[1]),
                qPrintable(QString("%1 %2").arg(path).arg(worst)));
        }
        ++covered;
    }
    qInfo("Rigol .wfm against the oscilloscope's CSV: %d files covered", covered);
    if (covered == 0)
        DYNCAL_SKIP_WITHOUT_DATA("DYNCAL_DATA has no folder rigolwfm: 0 files covered");
}

DYNCAL_TEST(TestRigolWfm)
#include "tst_rigol_wfm.moc"

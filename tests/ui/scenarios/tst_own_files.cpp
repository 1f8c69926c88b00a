// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_words.h"
#include "tests/ui/support/recording_files.h"
#include "ui/shell/import/import_dialog.h"

#include <clocale>

using namespace dyncal;
using namespace dyncal::test;

namespace {

/// The DUT of one shot as a table: a header of twelve lines, then time and value with these marks.
QByteArray tableOf(const Channel &dut, char separator, char decimal)
{
    QString text;
    for (int line = 1; line <= 12; ++line)
        text += QString("Remark %1: calibration bench\n").arg(line);
    text += QString("time [s]%1DUT [V]\n").arg(separator);
    for (Index k = 0; k < dut.samples.size(); ++k) {
        const QString time = QString::number(dut.timeOf_s(k), 'E', 12).replace('.', decimal);
        const QString value
            = QString::number(physicalValue(dut, dut.samples.at(k)), 'E', 9).replace('.', decimal);
        text += time + separator + value + '\n';
    }
    return text.toUtf8();
}

Channel oneDut()
{
    SimulationSettings settings = threeShots();
    settings.shots = {ShotLevel::High};
    settings.duration_s = 0.003;
    return simulateShots(settings).value().set.shots[0].channels[0];
}

std::vector<double> samplesOf(const ScenarioBench &bench)
{
    const Channel &dut = bench.session().state().captures->shots.at(0).channels.at(0);
    std::vector<double> values;
    for (Index k = 0; k < dut.samples.size(); ++k)
        values.push_back(physicalValue(dut, dut.samples.at(k)));
    return values;
}

} // namespace

/// Files as they lie on an operator's disk.
class TestOwnFiles : public QObject
{
    Q_OBJECT

private slots:
    void s03_threeFilesDropped_areTaggedByTheirSteps();
    void s04_wrongFiles_areNamedAndTheOthersOpened();
    void s06_semicolonsAndCommas_giveTheSameValues_data();
    void s06_semicolonsAndCommas_giveTheSameValues();
    void s06_threeDigitsBehindTheComma_areAsked();
    void s07_rateAgainstTheTimes_isNotTaken();
    void s07_rateTenTimesTooLow_isSeenInTheShock();
};

void TestOwnFiles::s03_threeFilesDropped_areTaggedByTheirSteps()
{
    const ScenarioBench bench;
    SimulationSettings settings = threeShots();
    settings.shots = {ShotLevel::High, ShotLevel::Low, ShotLevel::Medium};
    CaptureSet all = simulateShots(settings).value().set;
    QStringList paths;
    for (std::size_t i = 0; i < all.shots.size(); ++i) {
        CaptureSet one = all;
        one.shots = {all.shots[i]};
        one.shots[0].level = ShotLevel::None;
        paths << bench.write(one, QString("own%1.h5").arg(i + 1));
    }
    bench.open(paths);
    QCOMPARE(bench.session().state().captures->shots.size(), std::size_t(3));
    QVERIFY(!bench.window->findChild<ImportDialog *>("importDialog"));
    QCOMPARE(bench.prompts.shownProblems(), QStringList());
    bench.show(Page::Captures);
    bench.click("tagByStepHeight");
    const std::array expected{"High", "Low", "Medium"};
    for (int shot = 1; shot <= 3; ++shot)
        QCOMPARE(bench.find<QComboBox>(QString("levelOfShot%1").arg(shot))->currentText().toLower(),
            QString(expected[static_cast<std::size_t>(shot - 1)]).toLower());
    bench.choose("levelOfShot2", 2);
    QCOMPARE(bench.recipe().import.levels.at(1), std::string("medium"));
}

void TestOwnFiles::s04_wrongFiles_areNamedAndTheOthersOpened()
{
    const ScenarioBench bench;
    writeFile(bench.folder.filePath("letter.h5"), "%PDF-1.7 not a capture");
    writeFile(bench.folder.filePath("report.docx"),
        QByteArray("PK\3\4\24\0\6\0", 8) + QByteArray(200, '\1'));
    bench.open({bench.folder.filePath("letter.h5"), bench.record(threeShots()),
        bench.folder.filePath("report.docx")});
    QCOMPARE(bench.session().state().captures->shots.size(), std::size_t(3));
    QCOMPARE(bench.prompts.shownProblems(), QStringList()); // one panel, no box
    auto *table = bench.find<QTableWidget>("problemTable");
    QVERIFY(table->isVisible());
    QCOMPARE(table->rowCount(), 2);
    for (const char *part : {"PDF document", ".h5", ".lvm", ".tdms", ".mat", ".csv"})
        DYNCAL_SAYS(bench.row("problemTable", "letter.h5").value(1), part);
    for (const char *part : {"ZIP", ".h5"})
        DYNCAL_SAYS(bench.row("problemTable", "report.docx").value(1), part);
}

void TestOwnFiles::s06_semicolonsAndCommas_giveTheSameValues_data()
{
    QTest::addColumn<QByteArray>("locale");
    QTest::newRow("C") << QByteArray("C");
    QTest::newRow("German") << QByteArray("de_DE.UTF-8");
}

void TestOwnFiles::s06_semicolonsAndCommas_giveTheSameValues()
{
    QFETCH(QByteArray, locale);
    // Where the machine has no German locale of C, that of Qt is German all the same.
    std::setlocale(LC_ALL, locale.constData());
    const QLocale before;
    QLocale::setDefault(QLocale(QString(locale)));
    const Channel dut = oneDut();
    const ScenarioBench points;
    writeFile(points.folder.filePath("a.csv"), tableOf(dut, ',', '.'));
    points.open({points.folder.filePath("a.csv")});
    const ScenarioBench commas;
    writeFile(commas.folder.filePath("a.csv"), tableOf(dut, ';', ','));
    commas.open({commas.folder.filePath("a.csv")});
    QLocale::setDefault(before);
    std::setlocale(LC_ALL, "C");
    const std::vector<double> expected = samplesOf(points);
    const std::vector<double> found = samplesOf(commas);
    QCOMPARE(found.size(), static_cast<std::size_t>(dut.samples.size()));
    QCOMPARE(found, expected);
    commas.show(Page::Captures);
    QTest::mouseClick(commas.find<QPushButton>("importSettings"), Qt::LeftButton);
    QTRY_VERIFY(commas.window->findChild<ImportDialog *>("importDialog"));
    auto *dialog = commas.find<ImportDialog>("importDialog");
    QTRY_VERIFY(!dialog->isLooking());
    DYNCAL_SAYS(commas.text("importCounts"), "unreadable cells: 0");
    dialog->reject();
}

void TestOwnFiles::s06_threeDigitsBehindTheComma_areAsked()
{
    const ScenarioBench bench;
    QString text;
    for (int row = 0; row < 600; ++row)
        text += QString("1,%1;%2\n").arg(row, 3, 10, QChar('0')).arg(row < 200 ? "1,234" : "5,678");
    writeFile(bench.folder.filePath("a.csv"), "time [ms];p [V]\n" + text.toUtf8());
    bench.drop({bench.folder.filePath("a.csv")});
    QTRY_VERIFY(bench.window->findChild<ImportDialog *>("importDialog"));
    auto *dialog = bench.find<ImportDialog>("importDialog");
    QTRY_VERIFY(!dialog->isLooking());
    DYNCAL_SAYS(bench.text("importVerdict"), "can be read in two ways: choose the decimal mark");
    dialog->reject(); // then the finding goes on saying it
    bench.settle();
    DYNCAL_SAYS(bench.finding("CAP-019"), "a.csv");
    QCOMPARE(samplesOf(bench).front(), 1.234);
}

void TestOwnFiles::s07_rateAgainstTheTimes_isNotTaken()
{
    ScenarioBench bench;
    writeFile(bench.folder.filePath("a.csv"), tableOf(oneDut(), ',', '.'));
    bench.open({bench.folder.filePath("a.csv")});
    bench.show(Page::Captures);
    bench.prompts.setNextSentence("");
    bench.type("sampleRateValue", "2 MHz");
    auto *table = bench.find<QTableWidget>("problemTable");
    QTRY_VERIFY(table->isVisible());
    for (const char *part : {"20 MHz", "2 MHz"})
        DYNCAL_SAYS(bench.row("problemTable", "a.csv").value(1), part);
    // The job stays with the column of times; the audit line of the choice comes with the
    // certificate.
    QVERIFY(!bench.recipe().import.sampleRate_Hz);
    bench.show(Page::Spectrum);
    DYNCAL_SAYS(bench.row("resonanceTable", "").join('|'), "2.33");
}

void TestOwnFiles::s07_rateTenTimesTooLow_isSeenInTheShock()
{
    ScenarioBench bench;
    bench.open({bench.record(threeShots())});
    bench.show(Page::Captures);
    bench.prompts.setNextSentence("the logger's manual");
    bench.type("sampleRateValue", "2 MHz");
    const QString said = bench.finding("SHK-001");
    for (const char *part : {"Mach number 0.1", "check sample rate", "distance", "T1"})
        DYNCAL_SAYS(said, part);
}

DYNCAL_TEST(TestOwnFiles)
#include "tst_own_files.moc"

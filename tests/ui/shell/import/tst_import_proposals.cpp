// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/shell/import/import_bench.h"
#include "ui/session/example.h"
#include "ui/shell/import/import_channel_table.h"
#include "ui/shell/import/trace_cell.h"

#include <QFileDialog>
#include <QLineEdit>
#include <QTimer>
#include <QtTest>

using namespace dyncal;
using namespace dyncal::test;

namespace {

constexpr int kTraceColumn = 2;
constexpr int kLooksColumn = 3;

} // namespace

/// What the import dialog shows and proposes of recordings that say nothing of themselves.
class TestImportProposals : public QObject
{
    Q_OBJECT

private slots:
    void everyChannel_hasItsTrace();
    void roles_areProposed_andTakenByOneClick();
    void withoutAStep_nothingIsProposed();
    void unit_unknown_isSaid();
    void fileWithoutSettings_offersNone();
    void trace_staysInItsCell();
    void save_proposesTheRecordingsFolder();
};

void TestImportProposals::everyChannel_hasItsTrace()
{
    const ImportBench bench;
    bench.drop({bench.write("a.csv", tableText({}))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    auto *channels = dialog->findChild<ImportChannelTable *>("importChannels");
    QCOMPARE(channels->rowCount(), 2);
    for (int row = 0; row < 2; ++row) {
        auto *trace = channels->cellWidget(row, kTraceColumn);
        QVERIFY(trace && trace->isVisible());
        const QImage drawn = trace->grab().toImage();
        // Below the middle before the step, above it behind: ink in opposite corners.
        const auto inked = [&](const QRect &part) {
            const QRgb paper = drawn.pixel(drawn.width() / 2, 0);
            for (int y = part.top(); y <= part.bottom(); ++y)
                for (int x = part.left(); x <= part.right(); ++x)
                    if (drawn.pixel(x, y) != paper)
                        return true;
            return false;
        };
        const int half = drawn.height() / 2;
        const int quarter = drawn.width() / 4;
        QVERIFY(inked({4, half + 2, quarter - 8, half - 4}));
        QVERIFY(!inked({4, 4, quarter - 8, half - 8}));
        QVERIFY(inked({3 * quarter, 1, quarter - 8, half - 4}));
        QVERIFY2(channels->item(row, kLooksColumn)->text().contains("times the noise"),
            qPrintable(channels->item(row, kLooksColumn)->text()));
    }
}

void TestImportProposals::roles_areProposed_andTakenByOneClick()
{
    const ImportBench bench;
    bench.drop({bench.write("a.csv", tableText({}))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    const auto &channels = dialog->view().channels;
    // The side sensor is reached 20 samples before.
    QCOMPARE(channels[0].proposed, ChannelRole::Dut);
    QCOMPARE(channels[1].proposed, ChannelRole::DrivenSide);
    QCOMPARE(channels[0].role, ChannelRole::Other); // proposed, not taken
    auto *import = dialog->findChild<QPushButton *>("importButton");
    QVERIFY(!import->isEnabled());
    auto *propose = dialog->findChild<QPushButton *>("importPropose");
    QVERIFY(propose->isVisible());
    QTest::mouseClick(propose, Qt::LeftButton);
    QVERIFY(import->isEnabled());
    QVERIFY(!propose->isVisible()); // nothing is left to propose
    QTest::mouseClick(import, Qt::LeftButton);
    QTRY_COMPARE(bench.shots(), std::size_t(1));
    QCOMPARE(bench.import().channels.at("p"), std::string("dut"));
    QCOMPARE(bench.import().channels.at("side"), std::string("driven_side"));
}

void TestImportProposals::withoutAStep_nothingIsProposed()
{
    const ImportBench bench;
    TableText flat;
    flat.scale = 0.0;
    bench.drop({bench.write("a.csv", tableText(flat))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    QVERIFY(!dialog->findChild<QPushButton *>("importPropose")->isVisible());
    const auto *channels = dialog->findChild<ImportChannelTable *>("importChannels");
    QVERIFY(channels->item(0, kLooksColumn)->text().startsWith("no step"));
}

void TestImportProposals::unit_unknown_isSaid()
{
    const ImportBench bench;
    TableText table;
    table.header = "time [s],p [furlong],side\n";
    bench.drop({bench.write("a.csv", tableText(table))});
    ImportDialog *dialog = bench.waitDialog();
    QVERIFY(dialog);
    const auto *channels = dialog->findChild<ImportChannelTable *>("importChannels");
    const QString first = channels->item(0, kLooksColumn)->text();
    QVERIFY2(first.contains("unit furlong is not converted"), qPrintable(first));
    const QString second = channels->item(1, kLooksColumn)->text();
    QVERIFY2(second.contains("unit not known"), qPrintable(second));
    QCOMPARE(
        dialog->findChild<QLineEdit *>("importUnit2")->placeholderText(), QString("not stated"));
    auto *unit = dialog->findChild<QLineEdit *>("importUnit2");
    QTest::keyClicks(unit, "kPa");
    emit unit->editingFinished();
    QVERIFY(!channels->item(1, kLooksColumn)->text().contains("unit"));
}

void TestImportProposals::fileWithoutSettings_offersNone()
{
    QTemporaryDir folder;
    ImportDialog example(kExamplePath, {}, 1, folder.path(), nullptr);
    example.show();
    QTRY_VERIFY_WITH_TIMEOUT(!example.isLooking(), 60000);
    for (const char *name : {"importFormat", "importProfile", "importRate"})
        QVERIFY2(!example.findChild<QWidget *>(name)->isVisible(), name);
    QVERIFY(example.findChild<ImportChannelTable *>("importChannels")->isVisible());
    writeFile(folder.filePath("empty.bin"), "");
    ImportDialog empty(folder.filePath("empty.bin"), {}, 1, folder.path(), nullptr);
    empty.show();
    QTRY_VERIFY_WITH_TIMEOUT(!empty.isLooking(), 60000);
    for (const char *name : {"importChannels", "importRate", "importPropose"})
        QVERIFY2(!empty.findChild<QWidget *>(name)->isVisible(), name);
    QVERIFY(empty.findChild<QWidget *>("importFormat")->isVisible()); // another reader may take it
}

void TestImportProposals::trace_staysInItsCell()
{
    ChannelGlance glance;
    glance.trace = {{0.0, 1.0, true}, {}, {-3.0, 8.0, true}, {2.0, 2.0, true}};
    const QRectF cell(10, 20, 100, 30);
    const QPolygonF outline = TraceCell::outline(glance, cell);
    QCOMPARE(outline.size(), 6); // the stretch without numbers has none
    for (const QPointF &point : outline)
        QVERIFY(cell.contains(point));
    QVERIFY(TraceCell::outline({}, cell).isEmpty());
}

void TestImportProposals::save_proposesTheRecordingsFolder()
{
    QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("records"));
    const QString file = folder.filePath("records/a.csv");
    TableText one;
    one.header = "time [s],p [V]\n";
    one.columns = 1;
    writeFile(file, tableText(one));
    Preferences preferences(folder.filePath("settings.ini"));
    preferences.setLastFolder(folder.path()); // the operator was elsewhere since
    Prompts prompts; // real dialogs
    Language language;
    language.install("en");
    MainWindow window(
        noComputation, [] { return Result<std::string>("2026-01-31T12:00:00Z"); }, preferences,
        prompts, language);
    window.show();
    window.files().openPaths({file});
    QTRY_VERIFY(window.session().state().hasShots());
    preferences.setLastFolder(folder.path());
    QString proposed;
    QTimer::singleShot(500, this, [&] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        if (!dialog)
            return;
        proposed = dialog->directory().absolutePath();
        dialog->reject();
    });
    QVERIFY(!window.files().saveAs());
    QCOMPARE(proposed, QFileInfo(folder.filePath("records")).absoluteFilePath());
}

DYNCAL_TEST(TestImportProposals)
#include "tst_import_proposals.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The registry through its window, and a certificate issued, amended and withdrawn from it, by the
// program as it is built.

#include "tests/support/test_program.h"
#include "tests/ui/shell/registry/issuing_bench.h"
#include "tests/ui/support/event_loop_watchdog.h"
#include "tests/ui/support/window_grounds.h"

#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QTableWidget>

using namespace dyncal;
using dyncal::test::EventLoopWatchdog;

namespace {

constexpr qint64 kLongestWork_ms = 200;

/// The same with hands.
struct Bench : test::IssuingBench
{
    void choose(const char *table, int row) const { find<QTableView>(table)->selectRow(row); }
    void setCard(int row, int column, const QString &text) const
    {
        find<QTableWidget>("cardTable")->item(row, column)->setText(text);
    }
};

} // namespace

class TestRegistryWindow : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_recordings;

private slots:
    void initTestCase() { QVERIFY(simulateShortCapture(m_recordings.filePath("shot.h5"), 7)); }

    void certificate_isIssuedAmendedAndWithdrawn();
    void obstacles_areNamedBeforeAnythingIsWritten();
    void cards_areEditedAndSearched();
    void cardsThatCannotBeTaken_areSaid();
    void registryThatIsNone_isSaid();
    void passwords_areNotKept();
    void everythingFits();
};

void TestRegistryWindow::certificate_isIssuedAmendedAndWithdrawn()
{
    Bench bench;
    QVERIFY(bench.job.begin(m_recordings.filePath("shot.h5")));
    bench.openJob();
    bench.showIssuing();
    QVERIFY(bench.text("issueState").contains("draft"));
    QVERIFY(!bench.find<QLineEdit>("issueReason")->isVisible());
    QCOMPARE(bench.obstacles().first(), QString("Nothing keeps it from being issued."));
    {
        EventLoopWatchdog watchdog;
        bench.issueNow();
        QVERIFY2(watchdog.longestWork_ms() < kLongestWork_ms,
            QByteArray::number(watchdog.longestWork_ms()));
    }
    QVERIFY2(bench.text("issueOutcome").startsWith("Certificate 1 is issued"),
        qPrintable(bench.text("issueOutcome")));
    QCOMPARE(bench.job.verify({bench.job.output() + "/1"}).exitCode, 1); // not signed

    // The same job again is offered an amendment, never an edit.
    QTRY_VERIFY(bench.text("issueState").contains("certificate 1"));
    QVERIFY(!bench.button("issueNow")->isEnabled());
    bench.find<QLineEdit>("issueReason")->setText("serial number corrected");
    bench.issueNow();
    QVERIFY2(bench.text("issueOutcome").startsWith("Certificate 2 is issued"),
        qPrintable(bench.text("issueOutcome")));
    bench.issuing->close();

    bench.showRegistry();
    QCOMPARE(bench.rows("certificateTable"), 2);
    QCOMPARE(bench.cell("certificateTable", 0, 1), QString("issued as an amendment"));
    QCOMPARE(bench.cell("certificateTable", 0, 7), QString("1"));
    QCOMPARE(bench.cell("certificateTable", 1, 1), QString("replaced"));
    bench.choose("certificateTable", 1);
    QVERIFY(!bench.button("registryWithdraw")->isEnabled());
    bench.choose("certificateTable", 0);
    bench.prompts.setNextSentence("--reference found damaged");
    bench.button("registryWithdraw")->click();
    bench.waitForRegistry();
    QTRY_COMPARE(bench.text("registryOutcome"), QString("Certificate 2 is withdrawn."));
    bench.waitForRegistry();
    QCOMPARE(bench.cell("certificateTable", 0, 1), QString("withdrawn"));
    QCOMPARE(bench.cell("certificateTable", 0, 9), QString("--reference found damaged"));

    // Its trail: the newest entry first, with the row before and after.
    bench.find<QTabWidget>("registryTabs")->setCurrentIndex(1);
    QCOMPARE(bench.cell("trailTable", 0, 3), QString("withdrawn"));
    bench.choose("trailTable", 0);
    const QString entry = bench.find<QPlainTextEdit>("trailEntry")->toPlainText();
    QVERIFY2(entry.contains("\"state\": \"withdrawn\""), qPrintable(entry));
    const int all = bench.rows("trailTable");
    bench.find<QLineEdit>("trailTableText")->setText("AMENDMENT");
    QVERIFY(bench.rows("trailTable") > 0 && bench.rows("trailTable") < all);

    // Verified from the window as by the command.
    bench.find<QTabWidget>("registryTabs")->setCurrentIndex(3);
    bench.prompts.setNextFile(bench.job.output());
    bench.button("verifyFolder")->click();
    bench.waitForRegistry();
    QCOMPARE(bench.rows("verifyTable"), 2);
    QVERIFY(writeBytes(bench.job.output() + "/1/recipe.json", "{}"));
    bench.prompts.setNextFile(bench.job.output());
    bench.button("verifyFolder")->click();
    bench.waitForRegistry();
    QCOMPARE(bench.cell("verifyTable", 1, 2), QString("■ changed"));
    QVERIFY(bench.cell("verifyTable", 1, 8).contains("recipe.json"));
}

void TestRegistryWindow::obstacles_areNamedBeforeAnythingIsWritten()
{
    Bench bench;
    QJsonObject recipe = completeRecipe();
    QJsonObject fields = completeFields();
    fields.remove("customer_address");
    recipe["certificate"] = QJsonObject{{"fields", fields}};
    QVERIFY(bench.job.begin(m_recordings.filePath("shot.h5"), recipe));
    bench.openJob();
    bench.showIssuing();
    QCOMPARE(bench.obstacles().filter("■").size(), 1);
    QVERIFY2(bench.obstacles().first().contains("CER-001"), qPrintable(bench.obstacles().first()));
    QVERIFY(!bench.button("issueNow")->isEnabled());

    // Results of another recipe than the one on the screen issue nothing.
    Recipe next = bench.window->session().recipe();
    next.certificate.fields["customer_address"] = "2 Test Street";
    next.realization.order = 4;
    bench.window->session().apply(next, "order");
    QVERIFY2(bench.obstacles().first().contains("CER-004"), qPrintable(bench.obstacles().first()));
    QVERIFY(!bench.button("issueNow")->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(bench.window->session().isUpToDate(), Bench::kPatience_ms);
    QTRY_VERIFY(!bench.obstacles().first().contains("CER-004"));
    QVERIFY(!QDir(bench.job.output()).exists());
    QVERIFY(!QFile::exists(bench.job.registry()));
}

void TestRegistryWindow::cards_areEditedAndSearched()
{
    Bench bench;
    QVERIFY(writeBytes(bench.path("c.csv"),
        "name,sensor_serial,note\nAcme 5 17,17,first\n\"Åkerö \"\"9\"\"\",9,\"two\nlines\"\n"));
    QCOMPARE(runDyncal({"registry", "import", "sensor", bench.path("c.csv"), "--registry",
                           bench.job.registry(), "--reason", "list", "--by", "A"})
                 .exitCode,
        0);
    bench.showRegistry();
    auto *kind = bench.find<QComboBox>("cardKind");
    kind->setCurrentIndex(kind->findData("sensor"));
    bench.waitForRegistry();
    auto *table = bench.find<QTableWidget>("cardTable");
    QCOMPARE(table->rowCount(), 2);
    // As the form of the certificate has them; a field of the laboratory's own is as it was named.
    QStringList titles;
    for (int column = 0; column < table->columnCount(); ++column)
        titles << table->horizontalHeaderItem(column)->text();
    QCOMPARE(titles,
        QStringList({"Name", "Serial number", "Manufacturer", "Model", "Description and condition",
            "note"}));
    QVERIFY(!bench.button("cardKeep")->isEnabled());
    bench.find<QLineEdit>("cardText")->setText("LINES");
    QVERIFY(table->isRowHidden(0) && !table->isRowHidden(1));
    bench.find<QLineEdit>("cardText")->clear();

    bench.setCard(0, 1, "0017");
    bench.button("cardAdd")->click();
    bench.setCard(2, 0, "New");
    bench.setCard(2, 2, "Maker");
    QVERIFY(bench.button("cardKeep")->isEnabled());
    bench.prompts.setNextSentence("serial numbers have four digits");
    bench.button("cardKeep")->click();
    bench.waitForRegistry();
    QTRY_COMPARE(bench.text("registryOutcome"), QString("The cards are kept."));
    bench.waitForRegistry();
    QCOMPARE(table->rowCount(), 3);
    const QByteArray csv
        = runDyncal({"registry", "cards", "sensor", "--registry", bench.job.registry()}).out;
    QVERIFY2(csv.contains("0017") && csv.contains("\"two\nlines\"") && csv.contains("New"), csv);
    // Two cards changed: two entries, with the reason.
    const QJsonArray trail = QJsonDocument::fromJson(
        runDyncal({"registry", "trail", "--json", "--registry", bench.job.registry()}).out)
                                 .array();
    int reasons = 0;
    for (const QJsonValue &entry : trail)
        reasons += entry["reason"].toString() == "serial numbers have four digits" ? 1 : 0;
    QCOMPARE(reasons, 2);

    bench.prompts.setNextFile(bench.path("out.csv"));
    bench.button("cardExport")->click();
    bench.waitForRegistry();
    QCOMPARE(bytesOf(bench.path("out.csv")), csv);

    // A file of the operator's own stays, whatever its name.
    const QByteArray mine = R"([{"name": "Mine", "fields": {}}])";
    QVERIFY(writeBytes(bench.path("mine.json"), mine));
    bench.prompts.setNextFile(bench.path("mine.json"));
    bench.prompts.setNextSentence("from another registry");
    bench.button("cardImport")->click();
    bench.waitForRegistry();
    QTRY_COMPARE(table->rowCount(), 4);
    QCOMPARE(bytesOf(bench.path("mine.json")), mine);
}

void TestRegistryWindow::cardsThatCannotBeTaken_areSaid()
{
    Bench bench;
    bench.showRegistry();
    bench.button("cardAdd")->isEnabled();
    QVERIFY(writeBytes(bench.path("bad.csv"), "title\nx\n"));
    bench.prompts.setNextFile(bench.path("bad.csv"));
    bench.prompts.setNextSentence("try");
    bench.button("cardImport")->click();
    bench.waitForRegistry();
    QVERIFY2(bench.text("registryOutcome").contains("\"name\""),
        qPrintable(bench.text("registryOutcome")));
}

void TestRegistryWindow::registryThatIsNone_isSaid()
{
    Bench bench;
    bench.showRegistry();
    QVERIFY(writeBytes(bench.path("none.sqlite"), "this is no database"));
    bench.prompts.setNextFile(bench.path("none.sqlite"));
    bench.button("registryChoose")->click();
    bench.waitForRegistry();
    QVERIFY2(
        bench.text("registryOutcome").endsWith('.'), qPrintable(bench.text("registryOutcome")));
    QCOMPARE(bytesOf(bench.path("none.sqlite")), QByteArray("this is no database"));

    bench.registry->setProgram(bench.path("nothing"));
    bench.registry->refresh();
    QTRY_VERIFY(bench.text("registryOutcome").contains("could not be started"));
    bench.waitForRegistry();
}

void TestRegistryWindow::passwords_areNotKept()
{
    Bench bench;
    bench.showRegistry();
    auto *address = bench.find<QLineEdit>("registryAddress");
    address->setText("postgresql://lab:secret@127.0.0.1:1/registry");
    QTest::keyClick(address, Qt::Key_Return);
    bench.waitForRegistry();
    QCOMPARE(bench.preferences.issuing(Preferences::Issuing::Registry),
        QString("postgresql://lab@127.0.0.1:1/registry"));
    QVERIFY2(!bench.text("registryOutcome").isEmpty()
            && !bench.text("registryOutcome").contains("secret"),
        qPrintable(bench.text("registryOutcome")));
}

void TestRegistryWindow::everythingFits()
{
    Bench bench;
    QVERIFY(bench.job.begin(m_recordings.filePath("shot.h5")));
    QCOMPARE(bench.job.issue().exitCode, 0);
    bench.openJob();
    for (const char *code : {"sv", "en"}) {
        bench.language.install(code);
        bench.showIssuing();
        QCOMPARE(test::faultsOnEveryGround(*bench.issuing, bench.language), QString());
        delete bench.issuing;
        bench.showRegistry();
        for (int tab = 0; tab < 4; ++tab) {
            bench.find<QTabWidget>("registryTabs")->setCurrentIndex(tab);
            bench.registry->setObjectName(QString("registryWindow"));
            QCOMPARE(test::faultsOnEveryGround(*bench.registry, bench.language), QString());
        }
    }
}

DYNCAL_TEST(TestRegistryWindow)
#include "tst_registry_window.moc"

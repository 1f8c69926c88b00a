// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The self-test in the window: it runs in the background, can be stopped, and its report is saved.

#include "core/selftest/selftest_files.h"
#include "tests/support/file_bytes.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/window_bench.h"
#include "ui/shell/selftest_dialog.h"
#include "ui/stages/frame/value_table.h"
#include "ui/text/core_text.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QtTest>

using namespace dyncal;

namespace {

constexpr int kPatience_ms = 60'000;

struct DialogBench
{
    QTemporaryDir folder;
    Preferences preferences{folder.filePath("settings.ini")};
    Prompts prompts;
    Result<std::string> now{"2026-01-31T12:00:00Z"};
    std::unique_ptr<SelfTestDialog> dialog;

    explicit DialogBench(const QString &language = "en")
    {
        prompts.setScripted();
        dialog = std::make_unique<SelfTestDialog>(
            [this] { return now; }, prompts, preferences, language, nullptr);
        dialog->show();
    }

    template <typename T>
    T *find(const char *name) const
    {
        T *found = dialog->findChild<T *>(name);
        if (!found)
            qFatal("no %s", name);
        return found;
    }
    QString verdict() const { return find<QLabel>("selfTestVerdict")->text(); }
    QPushButton *button(const char *name) const { return find<QPushButton>(name); }
    QByteArray file(const QString &name) const { return testing::bytesOf(folder.filePath(name)); }
};

} // namespace

class TestSelftestDialog : public QObject
{
    Q_OBJECT

private slots:
    void beforeTheFirstTest_nothingCanBeSaved()
    {
        const DialogBench bench;
        QVERIFY(!bench.button("selfTestSave")->isEnabled());
        QVERIFY(bench.button("selfTestAgain")->isEnabled());
        QVERIFY(!bench.find<QProgressBar>("selfTestProgress")->isVisible());
    }

    void test_runsBehindTheWindow_andShowsEveryCheck()
    {
        const DialogBench bench;
        bench.dialog->start(6);
        QVERIFY(bench.dialog->isRunning());
        QVERIFY(bench.find<QProgressBar>("selfTestProgress")->isVisible());
        QVERIFY(!bench.button("selfTestAgain")->isEnabled());
        QCOMPARE(bench.button("selfTestClose")->text(), QString("&Cancel"));
        QTRY_VERIFY_WITH_TIMEOUT(!bench.dialog->isRunning(), kPatience_ms);
        const auto *table = bench.find<ValueTable>("selfTestTable");
        QCOMPARE(table->rowCount(), int(allChecks().size()) + 8);
        QCOMPARE(table->columnCount(), 8);
        QVERIFY(bench.button("selfTestSave")->isEnabled());
        QCOMPARE(bench.button("selfTestClose")->text(), QString("&Close"));
    }

    void report_isSaved_withTheTimeOfTheTest()
    {
        DialogBench bench;
        bench.dialog->start(0);
        bench.now = Result<std::string>("2027-01-01T00:00:00Z"); // later
        QTRY_VERIFY_WITH_TIMEOUT(!bench.dialog->isRunning(), kPatience_ms);
        QVERIFY(bench.verdict().startsWith("All "));
        bench.prompts.setNextFile(bench.folder.filePath("evidence"));
        bench.button("selfTestSave")->click();
        QVERIFY(bench.prompts.shownProblems().isEmpty());
        QVERIFY(bench.verdict().contains("Written: "));
        const auto json = QJsonDocument::fromJson(bench.file("evidence/selftest.json")).object();
        QCOMPARE(json["created_utc"].toString(), QString("2026-01-31T12:00:00Z"));
        QVERIFY(json["holds"].toBool());
        QVERIFY(bench.file("evidence/selftest.pdf").startsWith("%PDF-"));
    }

    /// Nothing is written and nothing said where the dialog is left without a folder.
    void withoutFolder_nothingIsWritten()
    {
        DialogBench bench;
        bench.dialog->start(0);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.dialog->isRunning(), kPatience_ms);
        bench.button("selfTestSave")->click();
        QVERIFY(!bench.verdict().contains("Written"));
        QVERIFY(bench.prompts.shownProblems().isEmpty());
    }

    void foreignFile_isNotReplaced()
    {
        DialogBench bench;
        QVERIFY(QDir(bench.folder.path()).mkdir("taken"));
        QFile file(bench.folder.filePath("taken/selftest.pdf"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("somebody's") > 0);
        file.close();
        bench.dialog->start(0);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.dialog->isRunning(), kPatience_ms);
        bench.prompts.setNextFile(bench.folder.filePath("taken"));
        bench.button("selfTestSave")->click();
        QCOMPARE(bench.prompts.shownProblems().size(), 1);
        QCOMPARE(bench.file("taken/selftest.pdf"), QByteArray("somebody's"));
    }

    /// The first press stops, the second closes.
    void cancelled_saysThatNothingIsKnown()
    {
        const DialogBench bench;
        bench.dialog->start(10000);
        bench.button("selfTestClose")->click();
        QVERIFY(!bench.dialog->isRunning());
        QVERIFY(bench.dialog->isVisible());
        QVERIFY(bench.verdict().contains("stopped"));
        QVERIFY(!bench.button("selfTestSave")->isEnabled());
        bench.button("selfTestClose")->click();
        QVERIFY(!bench.dialog->isVisible());
    }

    void closedWhileItRuns_endsSoon()
    {
        QElapsedTimer taken;
        {
            const DialogBench bench;
            bench.dialog->start(10000);
            QTest::qWait(100);
            taken.start();
        }
        QVERIFY(taken.elapsed() < 10'000);
    }

    void clockThatFails_isAProblem()
    {
        DialogBench bench;
        bench.now = fail(ErrorKind::Usage, {"No time.", {}});
        bench.dialog->start(0);
        QCOMPARE(bench.prompts.shownProblems(), QStringList("No time."));
        QVERIFY(!bench.dialog->isRunning());
    }

    void helpMenu_opensAndStartsIt()
    {
        test::WindowBench bench([](auto &&...) { return PipelineOutcome(); });
        bench.window->show();
        bench.find<QAction>("selfTestAction")->trigger();
        auto *dialog = bench.find<SelfTestDialog>("selfTestDialog");
        QVERIFY(dialog->isVisible() && dialog->isRunning() && dialog->isModal());
        dialog->reject();
        dialog->reject();
        QTRY_VERIFY(!bench.window->findChild<SelfTestDialog *>("selfTestDialog"));
    }

    void swedish_hasNoEnglishLeft()
    {
        Language language;
        language.install("sv");
        const DialogBench bench("sv");
        bench.dialog->start(0);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.dialog->isRunning(), kPatience_ms);
        QVERIFY(bench.verdict().startsWith("Alla "));
        const auto *table = bench.find<ValueTable>("selfTestTable");
        QStringList steps;
        for (int row = 0; row < table->rowCount(); ++row)
            steps << table->item(row, 1)->text();
        QVERIFY(steps.contains("väntad stötvåg") && !steps.contains("expected_shock"));
        SelfTestReport deviating{
            {{"expected_shock", {"distance over time", {}}, {}, 1.0, 2.0, 0.1}}, {}, {}, 0};
        const QString verdict = translated(deviating.verdict());
        QVERIFY2(verdict.contains("väntad stötvåg") && verdict.contains("sträcka genom tid"),
            qPrintable(verdict));
        const std::vector<CheckSpec> specs = allChecks();
        for (int row = 0; row < table->rowCount(); ++row)
            for (const CheckSpec &spec : specs)
                if (!spec.name.text[0] || QString(spec.name.text).contains("FIT"))
                    continue;
                else
                    QVERIFY2(table->item(row, 2)->text() != spec.name.text, spec.name.text);
        language.install("en");
    }
};

DYNCAL_TEST(TestSelftestDialog)
#include "tst_selftest_dialog.moc"

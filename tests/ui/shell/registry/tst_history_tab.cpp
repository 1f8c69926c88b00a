// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The history of a sensor in the window of the registry, by the program as it is built.

#include "tests/support/test_program.h"
#include "tests/system/results_of_years.h"
#include "tests/ui/shell/registry/registry_bench.h"
#include "tests/ui/support/window_grounds.h"
#include "ui/plot/widget/plot_widget.h"

#include <QComboBox>
#include <QLineEdit>
#include <QTabWidget>

using namespace dyncal;

namespace {

constexpr int kHistoryTab = 4;

/// The window of the registry at its last tab.
struct Bench : test::RegistryBench
{
    void showHistory()
    {
        showRegistry();
        find<QTabWidget>("registryTabs")->setCurrentIndex(kHistoryTab);
        waitForRegistry();
    }
    const PlotContent &drawn() const { return find<PlotWidget>("historyPlot")->content(); }
    QString said() const { return text("registryOutcome"); }
};

} // namespace

class TestHistoryTab : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_simulated;

    /// A certificate of 2026 and results of other years.
    void makeYears(const Bench &bench) const
    {
        QVERIFY(bench.job.begin(m_simulated.filePath("shot.h5")));
        QVERIFY(bench.job.issue().exitCode <= 1);
        const QByteArray issued = bytesOf(bench.job.output() + "/1/results.json");
        for (int year = 2021; year < 2026; ++year) {
            const QString folder = bench.job.output() + QString("/year%1").arg(year);
            QVERIFY(QDir().mkpath(folder));
            QVERIFY(writeBytes(folder + "/results.json",
                resultsOf(issued, {year, year == 2023 ? 1.1 : 1.0, year == 2025 ? "18" : "17"})));
        }
    }

private slots:
    void initTestCase() { QVERIFY(simulateShortCapture(m_simulated.filePath("shot.h5"), 7)); }

    void sensor_isFollowedOverTheYears();
    void withdrawn_isLeftOut();
    void nothingThere_isSaid();
    void everythingFits();
};

void TestHistoryTab::sensor_isFollowedOverTheYears()
{
    Bench bench;
    makeYears(bench);
    bench.showHistory();
    auto *sensor = bench.find<QComboBox>("historySensor");
    QCOMPARE(sensor->count(), 2);
    QCOMPARE(sensor->currentText(), QString("17 (5)"));
    QCOMPARE(bench.rows("historyTable"), 5);
    QCOMPARE(bench.cell("historyTable", 0, 0), QString("2026-01-07")); // the newest first
    QCOMPARE(bench.cell("historyTable", 0, 1), QString("1"));
    auto *series = bench.find<QComboBox>("historySeries");
    QCOMPARE(series->count(), 3);
    series->setCurrentIndex(2);
    emit series->activated(2);
    QCOMPARE(bench.drawn().curves.size(), std::size_t(4)); // 2023 and what follows it stand out
    QCOMPARE(bench.drawn().curves[3].x.size(), std::size_t(2));
    QCOMPARE(bench.drawn().levels.size(), std::size_t(5));

    auto *frequencies = bench.find<QLineEdit>("historyFrequencies");
    frequencies->setText("1000; 1,25e3");
    QTest::keyClick(frequencies, Qt::Key_Return);
    bench.waitForRegistry();
    QVERIFY2(series->count() == 7, qPrintable(bench.said()));

    sensor->setCurrentIndex(1);
    emit sensor->activated(1);
    bench.waitForRegistry();
    QCOMPARE(bench.rows("historyTable"), 1);

    const QString csv = bench.job.path("history.csv");
    bench.prompts.setNextFile(csv);
    bench.find<QPushButton>("historySave")->click();
    bench.waitForRegistry();
    QVERIFY2(bench.said().contains("history.csv"), qPrintable(bench.said()));
    QVERIFY(bytesOf(csv).startsWith("quantity,"));
}

void TestHistoryTab::withdrawn_isLeftOut()
{
    Bench bench;
    makeYears(bench);
    QCOMPARE(
        runDyncal({"withdraw", "1", "--reason", "wrong gas", "--registry", bench.job.registry()})
            .exitCode,
        0);
    bench.showHistory();
    QCOMPARE(bench.rows("historyTable"), 4);
    QVERIFY(bench.find<QLabel>("historySummary")->text().contains("withdrawn or replaced"));
}

void TestHistoryTab::nothingThere_isSaid()
{
    Bench bench;
    bench.showHistory();
    QVERIFY(!bench.find<PlotWidget>("historyPlot")->notice().isEmpty());
    QVERIFY(!bench.find<QPushButton>("historySave")->isEnabled());
    // What cannot be read is said, and the rest is shown.
    makeYears(bench);
    QVERIFY(writeBytes(bench.job.output() + "/year2021/results.json", "no JSON"));
    bench.registry->refresh();
    bench.waitForRegistry();
    QCOMPARE(bench.rows("historyTable"), 4);
    QVERIFY2(bench.said().contains("year2021"), qPrintable(bench.said()));
    auto *frequencies = bench.find<QLineEdit>("historyFrequencies");
    frequencies->setText("often");
    QTest::keyClick(frequencies, Qt::Key_Return);
    bench.waitForRegistry();
    QVERIFY2(bench.said().endsWith('.'), qPrintable(bench.said()));
    QCOMPARE(bench.rows("historyTable"), 4); // what was there stays
}

void TestHistoryTab::everythingFits()
{
    Bench bench;
    makeYears(bench);
    for (const char *code : {"sv", "en"}) {
        bench.language.install(code);
        bench.showHistory();
        QCOMPARE(test::faultsOnEveryGround(*bench.registry, bench.language), QString());
    }
}

DYNCAL_TEST(TestHistoryTab)
#include "tst_history_tab.moc"

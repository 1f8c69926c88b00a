// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/check_rows.h"
#include "ui/stages/checks_page.h"
#include "ui/stages/frame/value_table.h"

#include <QLabel>
#include <QRegularExpression>
#include <QtTest>

using namespace dyncal;
using Bench = test::PageBench<ChecksPage>;

namespace {

constexpr int kVerdict = 2;
constexpr int kWays = 3;
constexpr int kDifference = 8;

const QStringList &verdicts(const ValueTable &table)
{
    static QStringList list;
    list.clear();
    for (int row = 0; row < table.rowCount(); ++row)
        list << table.item(row, kVerdict)->text();
    return list;
}

void changeTemperature(Bench &bench, double T1_K)
{
    Recipe recipe = bench.recipe();
    recipe.shock.T1_K = T1_K;
    bench.session.apply(recipe, "T1");
    test::waitComputed(bench.session);
}

} // namespace

class TestChecksPage : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void everyComparison_isARow_contradictionsFirst();
    void swedish_hasNoDecimalPoint();
    void rows_sayWhatCouldNotBeMade();
};

void TestChecksPage::everyComparison_isARow_contradictionsFirst()
{
    Bench bench(testing::simulatedExample(1e7, 0.006));
    const auto *table = bench.control<ValueTable>("checkTable");
    const auto *summary = bench.control<QLabel>("checkSummary");
    QTRY_VERIFY_WITH_TIMEOUT(bench.session.results().checks && table->rowCount() > 0, 30000);
    QCOMPARE(table->rowCount(), static_cast<int>(bench.session.results().checks->checks.size()));
    QVERIFY(!verdicts(*table).contains("contradict each other"));
    QVERIFY2(summary->text().contains("contradicting: 0"), qPrintable(summary->text()));
    changeTemperature(bench, 312.0);
    QTRY_COMPARE_WITH_TIMEOUT(verdicts(*table).first(), QString("contradict each other"), 30000);
    QVERIFY2(!summary->text().contains("contradicting: 0"), qPrintable(summary->text()));
    // The finding leads here, and the page is not simply done.
    QTRY_COMPARE(bench.page.status(), StageStatus::DoneWithCautions);
    bench.session.undoStack().undo();
    test::waitComputed(bench.session);
    QTRY_VERIFY(!verdicts(*table).contains("contradict each other"));
}

void TestChecksPage::swedish_hasNoDecimalPoint()
{
    const test::InSwedish swedish;
    Bench bench(testing::simulatedExample(1e7, 0.006));
    const auto *table = bench.control<ValueTable>("checkTable");
    QTRY_VERIFY_WITH_TIMEOUT(table->rowCount() > 0, 30000);
    for (int row = 0; row < table->rowCount(); ++row)
        for (int column = 0; column < table->columnCount(); ++column)
            QVERIFY2(!table->item(row, column)->text().contains(QRegularExpression("\\d\\.\\d")),
                qPrintable(table->item(row, column)->text()));
}

void TestChecksPage::rows_sayWhatCouldNotBeMade()
{
    WayComparison missing{.of = Compared::P2Rise, .channel = "a & b", .unit = "Pa"};
    missing.missing = Message{"No card of %1.", {"x"}};
    const WayComparison made{
        .of = Compared::Mach, .shot = 2, .value_a = 1.51, .value_b = 1.5, .u = 0.004, .unit = "1"};
    const auto rows = checkRows({missing, made});
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0].size(), checkHeaders().size());
    QCOMPARE(rows[0][kVerdict], QString("agree"));
    QCOMPARE(rows[0][1], QString("2"));
    QCOMPARE(rows[0][kDifference], QString("0.0100 (u = 0.0040)"));
    QCOMPARE(rows[1][kVerdict], QString("not made"));
    QVERIFY2(rows[1][kWays].endsWith(": No card of x."), qPrintable(rows[1][kWays]));
    QCOMPARE(rows[1][1], QString("all"));
    QCOMPARE(checkSummary({missing, made}),
        QString("Comparisons made: 1; contradicting: 0; not possible: 1."));
}

DYNCAL_TEST(TestChecksPage)
#include "tst_checks_page.moc"

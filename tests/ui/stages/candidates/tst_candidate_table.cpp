// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "ui/stages/candidates/candidate_table.h"

#include <QHeaderView>
#include <QSignalSpy>
#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

enum Column { Order, Fit, Attainable, F0, Zeta, Unstable, Nyquist, White, Bic, Note };

CandidateRow known(Index order, double fit_percent, double f0_Hz)
{
    CandidateRow row;
    row.order = order;
    row.isKnown = true;
    row.fit_percent = fit_percent;
    row.attainable_percent = 90.0;
    row.f0_Hz = f0_Hz;
    row.zeta = 0.02;
    row.whiteness_p = 0.2;
    row.bic = 100.0;
    return row;
}

/// A model that runs away: there is no FIT to speak of.
CandidateRow diverging(Index order)
{
    CandidateRow row = known(order, 0.0, 2.33e6);
    row.fit_percent.reset();
    row.diverges = true;
    row.unstable = 3;
    return row;
}

std::vector<CandidateRow> threeOrders()
{
    return {known(2, 88.5, 2.33e6), diverging(40), known(10, 9.25, 2.35e6)};
}

QString text(const CandidateTable &table, int row, Column column)
{
    return table.item(row, column)->text();
}

QStringList orders(const CandidateTable &table)
{
    QStringList shown;
    for (int row = 0; row < table.rowCount(); ++row)
        shown << text(table, row, Order);
    return shown;
}

} // namespace

/// The comparison of the pinned orders, as it is sorted, read, copied and picked from.
class TestCandidateTable : public QObject
{
    Q_OBJECT

private slots:
    void init() { QLocale::setDefault(QLocale::c()); }
    void sortedByFit_divergingIsLast_bothWays();
    void sortedByProbability_isByValue();
    void refilled_keepsTheSortingAsked();
    void differences_areToTheReference_whichStays();
    void differences_ofUnknownValues_areDashes();
    void frequency_hasTheDigitsOfItsUncertainty();
    void enter_choosesTheOrderOfTheRow_afterSorting();
    void note_namesAdoptedAndRemark();
    void copied_inSwedish_hasCommas();
};

void TestCandidateTable::sortedByFit_divergingIsLast_bothWays()
{
    CandidateTable table;
    table.setRows(threeOrders());
    table.sortByColumn(Fit, Qt::AscendingOrder);
    QCOMPARE(orders(table), (QStringList{"10", "2", "40"}));
    // Best first is how one looks for the best: what has no FIT must not stand on top.
    table.sortByColumn(Fit, Qt::DescendingOrder);
    QCOMPARE(orders(table), (QStringList{"2", "10", "40"}));
}

void TestCandidateTable::sortedByProbability_isByValue()
{
    std::vector<CandidateRow> rows = threeOrders();
    rows[0].whiteness_p = 2e-7;
    rows[1].whiteness_p = 1e-5; // both read "< 0.001"
    rows[2].whiteness_p = 0.3;
    CandidateTable table;
    table.setRows(rows);
    table.sortByColumn(White, Qt::DescendingOrder);
    QCOMPARE(orders(table), (QStringList{"10", "40", "2"}));
    QCOMPARE(text(table, 1, White), QString("< 0.001"));
    QCOMPARE(text(table, 0, White), QString("0.3"));
}

void TestCandidateTable::refilled_keepsTheSortingAsked()
{
    CandidateTable table;
    table.setRows(threeOrders());
    table.sortByColumn(F0, Qt::DescendingOrder);
    QCOMPARE(text(table, 0, Order), QString("10"));
    std::vector<CandidateRow> rows = threeOrders(); // a model comes in while the table is read
    rows.push_back(known(5, 50.0, 9.9e6));
    table.setRows(rows);
    QCOMPARE(text(table, 0, Order), QString("5"));
    QCOMPARE(table.rowCount(), 4);
}

void TestCandidateTable::differences_areToTheReference_whichStays()
{
    const std::vector<CandidateRow> rows = threeOrders();
    CandidateTable table;
    table.setRows(rows, &rows[0]);
    QCOMPARE(orders(table), (QStringList{"2", "10", "40"}));
    QCOMPARE(text(table, 0, Fit), QString("88.5 %"));
    QVERIFY2(text(table, 1, Fit).startsWith("-79.2"), qPrintable(text(table, 1, Fit)));
    QCOMPARE(text(table, 1, F0), QString("+20 kHz"));
    QCOMPARE(text(table, 1, Bic), QString("+0"));
    QCOMPARE(text(table, 2, Fit), QString("diverges"));
    QCOMPARE(text(table, 2, Unstable), QString("3")); // counts are counts
}

void TestCandidateTable::differences_ofUnknownValues_areDashes()
{
    std::vector<CandidateRow> rows = threeOrders();
    rows[2].f0_Hz.reset(); // nothing rings at that order
    rows[2].zeta.reset();
    rows[0].bic.reset(); // the reference has none: there is nothing to take away
    CandidateTable table;
    table.setRows(rows, &rows[0]);
    QCOMPARE(text(table, 1, F0), QString("–"));
    QCOMPARE(text(table, 1, Zeta), QString("–"));
    QCOMPARE(text(table, 0, Bic), QString("–"));
    QCOMPARE(text(table, 1, Bic), QString("100"));
}

void TestCandidateTable::frequency_hasTheDigitsOfItsUncertainty()
{
    CandidateRow row = known(2, 88.5, 2.3300412e6);
    row.u_f0_Hz = 130.0;
    row.u_zeta = 9.3e-5;
    CandidateTable table;
    table.setRows({row});
    QCOMPARE(text(table, 0, F0), QString("2.33004 MHz"));
    QCOMPARE(text(table, 0, Zeta), QString("0.020000"));
}

void TestCandidateTable::enter_choosesTheOrderOfTheRow_afterSorting()
{
    CandidateTable table;
    table.setRows(threeOrders());
    QSignalSpy chosen(&table, &CandidateTable::chosen);
    table.sortByColumn(Fit, Qt::AscendingOrder); // the poorest, order 10, is on top now
    table.setCurrentCell(0, White);
    emit table.itemActivated(table.item(0, White));
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.at(0).at(0).value<Index>(), Index(10));
    table.setRows({});
    QCOMPARE(table.rowCount(), 0);
}

void TestCandidateTable::note_namesAdoptedAndRemark()
{
    std::vector<CandidateRow> rows = threeOrders();
    rows[0].isAdopted = true;
    rows[0].note = "suggested";
    rows[0].remark = "rings at 2.3 MHz\nsecond line";
    rows[1].isAdopted = true;
    rows[2].remark = "odd";
    CandidateTable table;
    table.setRows(rows);
    QVERIFY2(text(table, 0, Note).startsWith("adopted, suggested; rings at 2.3 MHz"),
        qPrintable(text(table, 0, Note)));
    QVERIFY(!text(table, 0, Note).contains('\n')); // one line a row
    QCOMPARE(text(table, 1, Note), QString("odd"));
    QCOMPARE(text(table, 2, Note), QString("adopted"));
}

void TestCandidateTable::copied_inSwedish_hasCommas()
{
    const test::InSwedish swedish;
    CandidateTable table;
    table.setRows({known(2, 88.5, 2.33e6), diverging(40)});
    QCOMPARE(table.horizontalHeaderItem(Order)->text(), QString("Ordning"));
    QCOMPARE(text(table, 0, Fit), QString("88,5 %"));
    QCOMPARE(text(table, 1, Fit), QString("divergerar"));
    const QStringList first = table.selectedText().section('\n', 0, 0).split('\t');
    QCOMPARE(first.size(), 10);
    QCOMPARE(first[F0], QString("2,3300 MHz"));
}

DYNCAL_TEST(TestCandidateTable)
#include "tst_candidate_table.moc"

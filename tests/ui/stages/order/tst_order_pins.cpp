// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/stages/order/order_page_bench.h"
#include "ui/stages/candidates/candidate_table.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include <algorithm>

using namespace dyncal;
using namespace dyncal::test;

/// Orders pinned on the order page: cards, notes, overlays and the table.
class TestOrderPins : public OrderPageBench
{
    Q_OBJECT

private slots:
    void initTestCase() { openExample(); }
    void init() { startOver(); }
    void space_pinsAndUnpins();
    void pin_atMostEight();
    void propose_cards_haveTheModels();
    void note_typedOnACard_isKeptAndShown();
    void note_enter_adoptsNothing();
    void note_goesWithItsCard_andUndoBringsItBack();
    void overlays_areFourAtMostInFourStyles();
    void table_sortsByValue_andShowsDifferences();
};

void TestOrderPins::space_pinsAndUnpins()
{
    QTest::keyClick(plot("singularValuePlot"), Qt::Key_Space);
    QCOMPARE(m_session.recipe().realization.candidates, std::vector<Index>{2});
    QTRY_VERIFY_WITH_TIMEOUT(m_session.candidates().find(2), kPatience_ms);
    QVERIFY(m_page->findChild<CandidateCard *>());
    QTest::keyClick(plot("orderBodePlot"), Qt::Key_Space);
    QVERIFY(m_session.recipe().realization.candidates.empty());
}

void TestOrderPins::pin_atMostEight()
{
    pin({1, 2, 3, 4, 5, 6, 7, 8});
    choose(9);
    QTest::keyClick(plot("singularValuePlot"), Qt::Key_Space);
    QCOMPARE(m_session.recipe().realization.candidates.size(), std::size_t(8));
    QVERIFY(!control<QPushButton>("pinOrder")->isEnabled());
}

void TestOrderPins::propose_cards_haveTheModels()
{
    control<QPushButton>("pinDefaults")->click();
    const std::vector<Index> orders = m_session.recipe().realization.candidates;
    QVERIFY(std::ranges::find(orders, m_session.results().decomposition->suggestion.order)
        != orders.end());
    QTRY_VERIFY_WITH_TIMEOUT(m_session.candidates().find(orders.back()), kPatience_ms);
    for (const Index order : orders) {
        const ComparedOrder *compared = m_session.candidates().find(order);
        QVERIFY(compared);
        QCOMPARE(compared->order, order);
    }
    const Index other = orders.back();
    const double fit = m_session.candidates().find(other)->model->fit_percent;
    choose(other);
    QCOMPARE(m_session.results().model->fit_percent, fit); // to the last bit
}

void TestOrderPins::note_typedOnACard_isKeptAndShown()
{
    pin({2, 3});
    QTest::qWait(20);
    QLineEdit *note = remarkOf(2);
    QTest::keyClicks(note, "rings at 2.3 MHz");
    QTest::keyClick(note, Qt::Key_Return);
    QCOMPARE(m_session.recipe().realization.candidateNotes,
        (std::vector<OrderNote>{{2, "rings at 2.3 MHz"}}));
    QCOMPARE(remarkOf(2)->text(), QString("rings at 2.3 MHz"));
    QVERIFY(remarkOf(3)->text().isEmpty());
    QVERIFY(control<QLabel>("adoption")->text().contains("rings at 2.3 MHz"));
    control<QPushButton>("compareOrders")->setChecked(true);
    auto *table = find<CandidateTable>(*m_page, "candidateTable");
    bool found = false;
    for (int row = 0; row < table->rowCount(); ++row)
        found = found || table->item(row, table->columnCount() - 1)->text().contains("rings");
    QVERIFY(found);
    control<QPushButton>("compareOrders")->setChecked(false);
    const Result<Recipe> again = parseRecipe(recipeJson(m_session.recipe()));
    QVERIFY(again);
    QCOMPARE(again->realization.candidateNotes, m_session.recipe().realization.candidateNotes);
    QVERIFY(!m_session.isComputing()); // no number depends on it
}

void TestOrderPins::note_enter_adoptsNothing()
{
    pin({2});
    QTest::qWait(20);
    QLineEdit *note = remarkOf(2);
    note->setFocus();
    QTest::keyClicks(note, "x y");
    QTest::keyClick(note, Qt::Key_Return);
    QTest::keyClick(note, Qt::Key_PageUp);
    QVERIFY(m_session.recipe().realization.adoptedReason.empty());
    QCOMPARE(*m_session.recipe().realization.order.value, Index(2));
    QCOMPARE(m_session.recipe().realization.candidates, std::vector<Index>{2});
}

void TestOrderPins::note_goesWithItsCard_andUndoBringsItBack()
{
    pin({2, 3});
    QTest::qWait(20);
    QTest::keyClicks(remarkOf(3), "odd");
    QTest::keyClick(remarkOf(3), Qt::Key_Return);
    cardOf(3)->findChild<QToolButton *>("candidateUnpin")->click();
    QVERIFY(m_session.recipe().realization.candidateNotes.empty());
    m_session.undoStack().undo();
    QTest::qWait(20);
    QCOMPARE(remarkOf(3)->text(), QString("odd"));
    QVERIFY(remarkOf(2)->text().isEmpty());
}

void TestOrderPins::overlays_areFourAtMostInFourStyles()
{
    pin({3, 4, 5, 6, 7, 8});
    QTRY_VERIFY_WITH_TIMEOUT(m_session.candidates().find(8), kPatience_ms);
    const QStringList plots{"orderBodePlot", "orderFitPlot", "orderPolePlot"};
    for (const CurveRole role : {CurveRole::Candidate1, CurveRole::Candidate2,
             CurveRole::Candidate3, CurveRole::Candidate4})
        for (const QString &name : plots)
            QCOMPARE(curvesOfRole(name, role), std::size_t(1));
    QTest::qWait(20); // the layout shows new cards, old ones go
    const auto cards = m_page->findChildren<CandidateCard *>();
    const auto card = std::ranges::find_if(
        cards, [](const CandidateCard *each) { return !each->isHidden() && each->order() == 3; });
    QVERIFY(card != cards.end());
    (*card)->findChild<QCheckBox *>("candidateOverlay")->click();
    QVERIFY(!m_session.candidates().isDrawn(3));
    QCOMPARE(curvesOfRole("orderBodePlot", CurveRole::Candidate4), std::size_t(1)); // the next one
    m_session.candidates().setDrawn(3, true);
}

void TestOrderPins::table_sortsByValue_andShowsDifferences()
{
    pin({2, 10, 3});
    QTRY_VERIFY_WITH_TIMEOUT(m_session.candidates().find(10), kPatience_ms);
    control<QPushButton>("compareOrders")->setChecked(true);
    auto *table = find<CandidateTable>(*m_page, "candidateTable");
    QVERIFY(table->isVisible());
    table->sortByColumn(0, Qt::DescendingOrder);
    QCOMPARE(table->item(0, 0)->text(), QString("10")); // by value: as text "3" would be first
    table->sortByColumn(0, Qt::AscendingOrder);
    QCOMPARE(table->item(0, 0)->text(), QString("2"));
    control<QPushButton>("adoptOrder")->click();
    control<QCheckBox>("differenceToAdopted")->setChecked(true);
    QVERIFY(table->item(0, 1)->text().front().isDigit()); // the adopted one itself
    QVERIFY(QString("+-").contains(table->item(1, 1)->text().front()));
    control<QCheckBox>("differenceToAdopted")->setChecked(false);
    control<QPushButton>("compareOrders")->setChecked(false);
}

DYNCAL_TEST(TestOrderPins)
#include "tst_order_pins.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/stages/order/order_page_bench.h"
#include "ui/stages/frame/quantity_edit.h"

#include <QLabel>
#include <QPushButton>
#include <QtTest>

using namespace dyncal;
using namespace dyncal::test;

/// The order dragged, typed and mistyped, and what undo gives back.
class TestOrderByHand : public OrderPageBench
{
    Q_OBJECT

private:
    Index order() const { return m_session.recipe().realization.order.value.value_or(0); }
    Index largest() const
    {
        return m_session.results().decomposition->hankel.singularValues.size();
    }
    void typeOrder(const QString &text)
    {
        auto *field = control<QuantityEdit>("orderValue");
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        waitComputed();
    }

private slots:
    void initTestCase() { openExample(); }
    void init() { startOver(); }
    void cut_draggedByMouse_isOneStep_andTheModelFollows();
    void cut_draggedFarOut_stopsAtTheLastOrder();
    void cut_dragCancelledByEsc_isAsBefore();
    void typed_nonsense_keepsTheOrder();
    void typed_tooHigh_isTheHighestThereIs();
    void automatic_isTheSuggested_andUndone();
    void shotExcluded_pinsStay_andAreComputedAnew();
    void adopted_reasonWithBlanks_isTheProposedOne();
};

void TestOrderByHand::cut_draggedByMouse_isOneStep_andTheModelFollows()
{
    PlotWidget *values = plot("singularValuePlot");
    const int steps = m_session.undoStack().index();
    const double y = 0.5 * (values->yRange().begin + values->yRange().end);
    const QPoint from = values->pixelOf(2.5, y); // "keep 2" stands between the second and third
    const int width = values->pixelOf(3.5, y).x() - from.x();
    QTest::mousePress(values, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 12; ++i) // in small moves, as a hand does
        QTest::mouseMove(values, from + QPoint(3 * width * i / 12, 0));
    QTest::mouseRelease(values, Qt::LeftButton, {}, from + QPoint(3 * width, 0));
    waitComputed();
    QCOMPARE(order(), Index(5));
    QCOMPARE(m_session.results().model->order, Index(5));
    QCOMPARE(control<QLabel>("modelOrderReadout")->text(), QString("5"));
    QCOMPARE(m_session.undoStack().index(), steps + 1);
    m_session.undoStack().undo();
    waitComputed();
    QCOMPARE(order(), Index(2));
    QCOMPARE(control<QLabel>("modelOrderReadout")->text(), QString("2"));
}

void TestOrderByHand::cut_draggedFarOut_stopsAtTheLastOrder()
{
    emit plot("singularValuePlot")->lineMoved("cut", 1e9, false);
    emit plot("singularValuePlot")->lineMoved("cut", 1e9, true);
    waitComputed();
    QCOMPARE(order(), largest());
    emit plot("singularValuePlot")->lineMoved("cut", -50.0, true);
    waitComputed();
    QCOMPARE(order(), Index(1));
    QVERIFY(!m_session.error());
}

void TestOrderByHand::cut_dragCancelledByEsc_isAsBefore()
{
    PlotWidget *values = plot("singularValuePlot");
    const double y = 0.5 * (values->yRange().begin + values->yRange().end);
    const QPoint from = values->pixelOf(2.5, y);
    QTest::mousePress(values, Qt::LeftButton, {}, from);
    QTest::mouseMove(values, values->pixelOf(4.0, y));
    QTest::mouseMove(values, values->pixelOf(6.5, y));
    QTest::keyClick(values, Qt::Key_Escape);
    QTest::mouseRelease(values, Qt::LeftButton, {}, values->pixelOf(6.5, y));
    waitComputed();
    QCOMPARE(order(), Index(2));
    QCOMPARE(m_session.results().model->order, Index(2));
}

void TestOrderByHand::typed_nonsense_keepsTheOrder()
{
    const int steps = m_session.undoStack().index();
    for (const char *typed : {"abc", "-3", "0", "1e9", "2,,5", "nan"}) {
        typeOrder(typed);
        QCOMPARE(order(), Index(2));
    }
    QCOMPARE(m_session.undoStack().index(), steps);
    QCOMPARE(control<QuantityEdit>("orderValue")->value(), 2.0); // and the field says so
}

void TestOrderByHand::typed_tooHigh_isTheHighestThereIs()
{
    typeOrder("999");
    QCOMPARE(order(), largest());
    QCOMPARE(control<QuantityEdit>("orderValue")->value(), static_cast<double>(largest()));
}

void TestOrderByHand::automatic_isTheSuggested_andUndone()
{
    choose(7);
    control<QAbstractButton>("orderAuto")->click();
    waitComputed();
    QVERIFY(m_session.recipe().realization.order.isAuto());
    const Index suggested = m_session.results().decomposition->suggestion.order;
    QCOMPARE(m_session.results().model->order, suggested);
    QCOMPARE(control<QuantityEdit>("orderValue")->value(), static_cast<double>(suggested));
    m_session.undoStack().undo();
    waitComputed();
    QCOMPARE(order(), Index(7));
}

void TestOrderByHand::shotExcluded_pinsStay_andAreComputedAnew()
{
    pin({2, 4});
    QTRY_VERIFY_WITH_TIMEOUT(m_session.candidates().find(4), kPatience_ms);
    const double before = m_session.candidates().find(4)->model->fit_percent;
    Recipe recipe = m_session.recipe();
    recipe.import.exclude = {{3, "tore late"}};
    m_session.apply(recipe, "exclude");
    waitComputed();
    QCOMPARE(m_session.recipe().realization.candidates, (std::vector<Index>{2, 4}));
    QTRY_VERIFY_WITH_TIMEOUT(
        m_session.candidates().find(4) && m_session.candidates().find(4)->model->series.size() == 2,
        kPatience_ms);
    QVERIFY(m_session.candidates().find(4)->model->fit_percent != before);
    m_session.undoStack().undo();
    waitComputed();
    QTRY_VERIFY_WITH_TIMEOUT(m_session.candidates().find(4)
            && m_session.candidates().find(4)->model->fit_percent == before,
        kPatience_ms);
}

void TestOrderByHand::adopted_reasonWithBlanks_isTheProposedOne()
{
    auto *reason = control<QLineEdit>("adoptReason");
    const std::string proposed = control<QLabel>("proposedReason")->text().toStdString();
    reason->setText("   ");
    control<QPushButton>("adoptOrder")->click();
    QCOMPARE(m_session.recipe().realization.adoptedReason, proposed);
    QVERIFY(control<QLabel>("adoption")->text().contains("adopted"));
    m_session.undoStack().undo();
    QVERIFY(m_session.recipe().realization.adoptedReason.empty());
    QVERIFY(!control<QLabel>("adoption")->text().contains("adopted"));
}

DYNCAL_TEST(TestOrderByHand)
#include "tst_order_by_hand.moc"

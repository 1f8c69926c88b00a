// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/stage_table.h"
#include "tests/support/test_program.h"
#include "tests/ui/stages/order/order_page_bench.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/model/model_page.h"
#include "ui/text/quantity_format.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>

using namespace dyncal;
using namespace dyncal::test;

/// The order and model pages over the real pipeline and the built-in example.
class TestOrderPage : public OrderPageBench
{
    Q_OBJECT

private slots:
    void initTestCase() { openExample(); }
    void init() { startOver(); }
    void strip_showsEveryClassAndTheRow();
    void strip_click_picksTheOrder();
    void order_beyondThePlot_isStillSeen();
    void order_changed_zoomStays();
    void orderChanged_oldResponse_isNotShown();
    void keys_leadToWholePairsAndToTheLastOrder();
    void keyO_leadsToTheFieldOfTheOrder();
    void splitPair_isSaidAndOffersTheWholeOne();
    void values_haveTheDigitsOfTheirUncertainty();
    void enter_adoptsWithTheProposedReason();
    void adopted_orderChanged_reasonGoesAndUndoBringsItBack();
    void adopt_unstable_isDisabledAndSaysWhy();
    void tolerances_changeTheRecipe();
    void modelPage_series_showsThatAlone();
    void frequencyCursors_areShared();
    void everyControl_hasAName();
};

void TestOrderPage::strip_showsEveryClassAndTheRow()
{
    const PlotContent &content = plot("stabilisationPlot")->content();
    QVERIFY(content.yAxis2);
    QVERIFY(curvesOfRole("stabilisationPlot", CurveRole::StablePole) == 1);
    QCOMPARE(content.levels.size(), std::size_t(1));
    QCOMPARE(content.levels[0].y, 2.0);
    const auto &evidence = *m_session.results().evidence;
    std::size_t drawn = 0;
    for (const PlotCurve &curve : content.curves)
        drawn += curve.onSecondAxis ? 0 : curve.x.size();
    QCOMPARE(drawn, evidence.poles.size());
    QVERIFY(!m_session.results().evidence->words.empty());
    QVERIFY(!control<QLabel>("orderWhy")->text().isEmpty());
}

void TestOrderPage::strip_click_picksTheOrder()
{
    const auto &poles = m_session.results().evidence->poles;
    const auto pole = std::ranges::find(poles, Index(4), &OrderPole::order);
    QVERIFY(pole != poles.end());
    PlotWidget *strip = plot("stabilisationPlot");
    strip->setXRange({0.9 * pole->frequency_Hz, 1.1 * pole->frequency_Hz});
    QTest::qWait(50);
    QTest::mouseClick(strip, Qt::LeftButton, {}, strip->pixelOf(pole->frequency_Hz, 4.0));
    waitComputed();
    QCOMPARE(*m_session.recipe().realization.order.value, Index(4));
    QCOMPARE(strip->content().levels.at(0).y, 4.0);
}

void TestOrderPage::order_beyondThePlot_isStillSeen()
{
    auto *values = plot("singularValuePlot");
    QTRY_VERIFY(values->xRange().end < 45.0); // the first 40 of them
    choose(53);
    QTRY_VERIFY(values->xRange().end > 53.5);
    QVERIFY(values->axesRect().contains(
        {values->pixelOf(53.5, 1.0).x(), values->axesRect().center().y()}));
}

void TestOrderPage::order_changed_zoomStays()
{
    const QStringList names{"singularValuePlot", "stabilisationPlot", "orderEvidencePlot",
        "orderFitPlot", "orderBodePlot"}; // the pole map keeps equal scales instead
    plot("orderBodePlot")->setXRange({1e6, 3e6});
    plot("orderFitPlot")->setXRange({1e-6, 3e-6});
    plot("singularValuePlot")->setXRange({0.5, 12.5});
    QTest::qWait(50);
    std::vector<Interval> before;
    for (const QString &name : names)
        before.push_back(plot(name)->xRange());
    for (const Index order : {3, 10, 40, 2}) {
        choose(order);
        QTest::qWait(20);
        for (int i = 0; i < names.size(); ++i)
            QVERIFY2(plot(names[i])->xRange() == before[static_cast<std::size_t>(i)],
                qPrintable(QString("%1 at order %2").arg(names[i]).arg(order)));
    }
}

void TestOrderPage::orderChanged_oldResponse_isNotShown()
{
    // Within a drag the response is still that of the order before: its dots must not be drawn.
    Recipe recipe = m_session.recipe();
    recipe.realization.order = 7;
    m_session.apply(recipe, "order", "drag");
    QTRY_COMPARE(m_session.results().model->order, Index(7));
    if (!m_session.isOfThisRun(StageId::Response))
        QCOMPARE(curvesOfRole("orderBodePlot", CurveRole::Measured), std::size_t(0));
    QCOMPARE(control<QLabel>("modelOrderReadout")->text(), QString("7"));
    m_session.endMerge();
    waitComputed();
    QVERIFY(m_session.isOfThisRun(StageId::Response));
    QCOMPARE(curvesOfRole("orderBodePlot", CurveRole::Measured), std::size_t(1));
}

void TestOrderPage::keys_leadToWholePairsAndToTheLastOrder()
{
    PlotWidget *values = plot("singularValuePlot");
    QTest::keyClick(values, Qt::Key_Left);
    QCOMPARE(*m_session.recipe().realization.order.value, Index(1)); // half of the pair
    QTest::keyClick(values, Qt::Key_Right);
    QTest::keyClick(values, Qt::Key_Right);
    QTest::keyClick(values, Qt::Key_Left, Qt::ShiftModifier);
    QCOMPARE(*m_session.recipe().realization.order.value, Index(2));
    QTest::keyClick(values, Qt::Key_Left);
    QTest::keyClick(values, Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(*m_session.recipe().realization.order.value, Index(2));
    QTest::keyClick(values, Qt::Key_Left);
    QTest::keyClick(values, Qt::Key_Left, Qt::ShiftModifier); // nothing whole is below
    QCOMPARE(*m_session.recipe().realization.order.value, Index(1));
    QTest::keyClick(values, Qt::Key_End);
    QCOMPARE(*m_session.recipe().realization.order.value,
        m_session.results().decomposition->hankel.singularValues.size());
    waitComputed();
}

void TestOrderPage::keyO_leadsToTheFieldOfTheOrder()
{
    Recipe recipe = m_session.recipe();
    recipe.realization.order = {};
    m_session.apply(recipe, "order");
    waitComputed();
    QTest::keyClick(plot("singularValuePlot"), Qt::Key_O);
    auto *field = m_page->inspector()->findChild<QuantityEdit *>("orderValue");
    QTest::keyClicks(field, "3");
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(m_session.recipe().realization.order.value);
    QCOMPARE(*m_session.recipe().realization.order.value, Index(3));
    waitComputed();
}

void TestOrderPage::splitPair_isSaidAndOffersTheWholeOne()
{
    choose(1);
    const Findings findings = allFindings(m_session.results());
    const auto split = std::ranges::find(findings, "ORD-001", &Finding::id);
    QVERIFY(split != findings.end());
    QCOMPARE(split->correction->key, std::string("realization.order"));
    QCOMPARE(split->correction->value, std::string("2"));
    pin({1});
    QTest::qWait(20);
    QTRY_VERIFY(find<QLabel>(*cardOf(1), "candidateText")->text().contains("splits a pair"));
}

void TestOrderPage::values_haveTheDigitsOfTheirUncertainty()
{
    const auto plain = [](QString text) { return text.replace(QChar::Nbsp, ' '); };
    const CalibrationResults &results = m_session.results();
    const ReportedValue *f0 = results.uncertainty->find("f0_hz"); // what every page states
    QVERIFY(f0 && f0->u);
    const QString shown = plain(control<QLabel>("resonanceReadout")->text());
    QVERIFY2(shown.contains(shownWithStandardU(f0->value, *f0->u, "Hz")), qPrintable(shown));
    // "2.33000 MHz ± 0.00013 MHz": as many decimals in both.
    const QRegularExpression pair("^(\\d+\\.(\\d+)) MHz ± 0\\.(\\d+) MHz");
    const auto match = pair.match(plain(control<QLabel>("spreadReadout")->text()));
    QVERIFY2(match.hasMatch(), qPrintable(control<QLabel>("spreadReadout")->text()));
    QCOMPARE(match.captured(2).size(), match.captured(3).size());
}

void TestOrderPage::enter_adoptsWithTheProposedReason()
{
    const QString proposed = control<QLabel>("proposedReason")->text();
    QVERIFY(!proposed.isEmpty());
    QTest::keyClick(plot("singularValuePlot"), Qt::Key_Return);
    QCOMPARE(*m_session.recipe().realization.order.value, Index(2));
    QCOMPARE(QString::fromStdString(m_session.recipe().realization.adoptedReason), proposed);
    QVERIFY(!control<QPushButton>("adoptOrder")->isEnabled()); // done
}

void TestOrderPage::adopted_orderChanged_reasonGoesAndUndoBringsItBack()
{
    control<QLineEdit>("adoptReason")->setText("agreed with the customer");
    control<QPushButton>("adoptOrder")->click();
    QCOMPARE(m_session.recipe().realization.adoptedReason, std::string("agreed with the customer"));
    QTest::keyClick(plot("singularValuePlot"), Qt::Key_Right);
    waitComputed();
    QVERIFY(m_session.recipe().realization.adoptedReason.empty());
    QTest::keyClick(plot("singularValuePlot"), Qt::Key_Return);
    QCOMPARE(*m_session.recipe().realization.order.value, Index(3));
    m_session.undoStack().undo(); // adopting 3
    m_session.undoStack().undo(); // the step to 3
    waitComputed();
    QCOMPARE(*m_session.recipe().realization.order.value, Index(2));
    QCOMPARE(m_session.recipe().realization.adoptedReason, std::string("agreed with the customer"));
}

void TestOrderPage::adopt_unstable_isDisabledAndSaysWhy()
{
    Index unstable = 0;
    for (Index order = 30; order < 60 && unstable == 0; ++order) {
        choose(order);
        if (!m_session.error()
            && std::ranges::any_of(m_session.results().model->findings,
                [](const Finding &finding) { return finding.id == "MOD-001"; }))
            unstable = order;
    }
    QVERIFY2(unstable > 0, "no order of the example from 30 to 59 is unstable");
    auto *adopt = control<QPushButton>("adoptOrder");
    QVERIFY(!adopt->isEnabled());
    QVERIFY(adopt->toolTip().startsWith("MOD-001"));
    QTest::keyClick(plot("singularValuePlot"), Qt::Key_Return);
    QVERIFY(m_session.recipe().realization.adoptedReason.empty());
}

void TestOrderPage::tolerances_changeTheRecipe()
{
    const auto model = m_session.results().model;
    Recipe recipe = m_session.recipe();
    recipe.realization.stableFrequency = 1e-6;
    m_session.apply(recipe, "tolerance");
    waitComputed();
    QCOMPARE(m_session.results().model.get(), model.get()); // the strip alone is computed again
    m_session.undoStack().undo();
    waitComputed();
}

void TestOrderPage::modelPage_series_showsThatAlone()
{
    ModelPage page(m_session);
    const std::unique_ptr<InspectorForm> inspector(page.inspector());
    page.show();
    const auto curves = [&](const QString &name) {
        return find<PlotWidget>(page, name)->content().curves.size();
    };
    const std::size_t all = m_session.results().input->series.size();
    QCOMPARE(curves("modelErrorPlot"), all);
    QCOMPARE(curves("modelResidualPlot"), all);
    auto *series = inspector->findChild<QComboBox *>("modelSeries");
    QCOMPARE(static_cast<std::size_t>(series->count()), all + 1);
    series->setCurrentIndex(2);
    emit series->activated(2);
    QCOMPARE(curves("modelErrorPlot"), std::size_t(1));
    QCOMPARE(curves("modelResidualPlot"), std::size_t(1));
    QCOMPARE(curves("modelFitPlot"), std::size_t(2));
}

void TestOrderPage::frequencyCursors_areShared()
{
    PlotWidget *bode = plot("orderBodePlot");
    QTest::mouseMove(bode, bode->axesRect().center());
    QTest::keyClick(bode, Qt::Key_1);
    QVERIFY(!bode->cursorReadout().isEmpty());
    const QString strip = plot("stabilisationPlot")->cursorReadout();
    QVERIFY(strip.startsWith("A: "));
    QCOMPARE(strip, bode->cursorReadout().section(';', 0, 0));
    QTest::keyClick(bode, Qt::Key_Escape);
    QVERIFY(plot("stabilisationPlot")->cursorReadout().isEmpty());
}

void TestOrderPage::everyControl_hasAName()
{
    pin({2, 3});
    QTRY_VERIFY_WITH_TIMEOUT(m_session.candidates().find(3), kPatience_ms);
    for (const QAbstractButton *button : m_page->findChildren<QAbstractButton *>()) {
        if (button->isVisible())
            QVERIFY2(!button->text().isEmpty() || !button->accessibleName().isEmpty(),
                qPrintable(button->objectName()));
    }
    for (const PlotWidget *each : m_page->findChildren<PlotWidget *>()) {
        QVERIFY(!each->accessibleName().isEmpty());
        QVERIFY(each->focusPolicy() & Qt::TabFocus);
    }
}

DYNCAL_TEST(TestOrderPage)
#include "tst_order_page.moc"

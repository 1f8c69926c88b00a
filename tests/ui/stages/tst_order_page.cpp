// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/plot_widget.h"
#include "ui/session/example.h"
#include "ui/session/order_candidates.h"
#include "ui/stages/candidate_cards.h"
#include "ui/stages/candidate_table.h"
#include "ui/stages/model_page.h"
#include "ui/stages/order_page.h"
#include "ui/stages/quantity_edit.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QToolButton>
#include <QtTest>

#include <algorithm>
#include <memory>

using namespace dyncal;

namespace {

/// Long enough for the plateau of every shot.
constexpr double kDuration_s = 0.006;
constexpr int kPatience_ms = 120'000;

template <typename T>
T *find(const QWidget &page, const QString &name)
{
    T *found = page.findChild<T *>(name);
    if (!found)
        qFatal("no %s", qPrintable(name));
    return found;
}

} // namespace

/// The order and model pages over the real pipeline and the built-in example.
class TestOrderPage : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void strip_showsEveryClassAndTheRow();
    void strip_click_picksTheOrder();
    void order_changed_zoomStays();
    void orderChanged_oldResponse_isNotShown();
    void space_pinsAndUnpins();
    void pin_atMostEight();
    void propose_cards_haveTheModels();
    void note_typedOnACard_isKeptAndShown();
    void note_enter_adoptsNothing();
    void note_goesWithItsCard_andUndoBringsItBack();
    void overlays_areFourAtMostInFourStyles();
    void table_sortsByValue_andShowsDifferences();
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

private:
    template <typename T>
    T *control(const QString &name)
    {
        T *found = m_page->inspector()->findChild<T *>(name);
        return found ? found : find<T>(*m_page, name);
    }
    PlotWidget *plot(const QString &name) { return find<PlotWidget>(*m_page, name); }
    void choose(Index order)
    {
        Recipe recipe = m_session.recipe();
        recipe.realization.order = order;
        recipe.realization.adoptedReason.clear();
        m_session.apply(recipe, "order");
        waitComputed();
    }
    void pin(std::vector<Index> orders)
    {
        Recipe recipe = m_session.recipe();
        recipe.realization.candidates = std::move(orders);
        recipe.realization.candidateNotes.clear();
        m_session.apply(recipe, "pin");
        QTRY_VERIFY_WITH_TIMEOUT(!m_session.candidates().isComputing(), kPatience_ms);
    }
    void waitComputed() { QTRY_VERIFY_WITH_TIMEOUT(!m_session.isComputing(), kPatience_ms); }
    CandidateCard *cardOf(Index order)
    {
        for (CandidateCard *card : m_page->findChildren<CandidateCard *>())
            if (!card->isHidden() && card->order() == order)
                return card;
        qFatal("no card");
    }
    QLineEdit *remarkOf(Index order) { return find<QLineEdit>(*cardOf(order), "candidateRemark"); }
    std::size_t curvesOfRole(const QString &name, CurveRole role)
    {
        return static_cast<std::size_t>(
            std::ranges::count(plot(name)->content().curves, role, &PlotCurve::role));
    }

    Session m_session{runPipeline};
    std::unique_ptr<OrderPage> m_page;
    std::unique_ptr<InspectorForm> m_inspector;
};

void TestOrderPage::initTestCase()
{
    const auto captures = exampleCaptures({}, kDuration_s);
    QVERIFY(captures);
    m_session.setFocus(StageId::Shock);
    m_session.reset({std::make_shared<const CaptureSet>(*captures), {}});
    waitComputed();
    QVERIFY2(
        !m_session.error(), m_session.error() ? english(m_session.error()->message).c_str() : "");
    m_page = std::make_unique<OrderPage>(m_session);
    m_inspector.reset(m_page->inspector());
    m_page->resize(1000, 800);
    m_page->show();
    m_inspector->show();
}

void TestOrderPage::init()
{
    choose(2);
    pin({});
}

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

void TestOrderPage::space_pinsAndUnpins()
{
    QTest::keyClick(plot("singularValuePlot"), Qt::Key_Space);
    QCOMPARE(m_session.recipe().realization.candidates, std::vector<Index>{2});
    QTRY_VERIFY_WITH_TIMEOUT(m_session.candidates().find(2), kPatience_ms);
    QVERIFY(m_page->findChild<CandidateCard *>());
    QTest::keyClick(plot("orderBodePlot"), Qt::Key_Space);
    QVERIFY(m_session.recipe().realization.candidates.empty());
}

void TestOrderPage::pin_atMostEight()
{
    pin({1, 2, 3, 4, 5, 6, 7, 8});
    choose(9);
    QTest::keyClick(plot("singularValuePlot"), Qt::Key_Space);
    QCOMPARE(m_session.recipe().realization.candidates.size(), std::size_t(8));
    QVERIFY(!control<QPushButton>("pinOrder")->isEnabled());
}

void TestOrderPage::propose_cards_haveTheModels()
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

void TestOrderPage::note_typedOnACard_isKeptAndShown()
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

void TestOrderPage::note_enter_adoptsNothing()
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

void TestOrderPage::note_goesWithItsCard_andUndoBringsItBack()
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

void TestOrderPage::overlays_areFourAtMostInFourStyles()
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

void TestOrderPage::table_sortsByValue_andShowsDifferences()
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
    const Findings findings = m_session.results().findings();
    const auto split = std::ranges::find(findings, "ORD-001", &Finding::id);
    QVERIFY(split != findings.end());
    QCOMPARE(split->mend->key, std::string("realization.order"));
    QCOMPARE(split->mend->value, std::string("2"));
    pin({1});
    QTest::qWait(20);
    QTRY_VERIFY(find<QLabel>(*cardOf(1), "candidateText")->text().contains("splits a pair"));
}

void TestOrderPage::values_haveTheDigitsOfTheirUncertainty()
{
    const Pole *pole = mainPole(*m_session.results().model);
    QVERIFY(pole && pole->u_frequency_Hz > 0.0);
    const QString shown = control<QLabel>("resonanceReadout")->text();
    QVERIFY2(shown.contains(shownWithU(pole->frequency_Hz, pole->u_frequency_Hz, "Hz")),
        qPrintable(shown));
    // "2.33000 MHz ± 0.00013 MHz": as many decimals in both.
    const QRegularExpression pair("^(\\d+\\.(\\d+)) MHz ± 0\\.(\\d+) MHz");
    const auto match = pair.match(control<QLabel>("spreadReadout")->text());
    QVERIFY2(match.hasMatch(), qPrintable(control<QLabel>("spreadReadout")->text()));
    QCOMPARE(match.captured(2).size(), match.captured(3).size());
}

void TestOrderPage::enter_adoptsWithTheProposedReason()
{
    const QString proposed = control<QLineEdit>("adoptReason")->placeholderText();
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

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/results_json.h"
#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_words.h"
#include "ui/plot/values/plot_theme.h"
#include "ui/session/order_candidates.h"

#include <QHeaderView>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include <set>

using namespace dyncal;
using namespace dyncal::test;

/// The order chosen by hand. The default treatment takes the pole of the step out before the model
/// is made, so every order here is one less than where the step takes a pole of its own.
class TestOrders : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void s23_orderByMouseAndKeys_everythingFollows();
    void s24_unstableModel_cannotBeAdopted();
    void s24_divergingCandidate_showsWordsNotNumbers();
    void s24_stepPole_isNeverUnstable();
    void s25_fourOrders_areCompared();

private:
    PlotWidget *plot(const QString &name) const { return m_bench->find<PlotWidget>(name); }
    Index order() const { return m_bench->recipe().realization.order.value.value_or(0); }
    void compareWithCommandLine();
    void press(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(plot("singularValuePlot"), static_cast<Qt::Key>(key), modifiers);
        m_bench->settle();
    }
    void typeOrder(const QString &text)
    {
        press(Qt::Key_O);
        QTest::keyClicks(m_bench->window->focusWidget(), text);
        QTest::keyClick(m_bench->window->focusWidget(), Qt::Key_Return);
        m_bench->settle();
    }
    std::unique_ptr<ScenarioBench> m_bench;
};

void TestOrders::initTestCase()
{
    m_bench = std::make_unique<ScenarioBench>();
    m_bench->open({m_bench->record(threeShots())});
}

void TestOrders::init()
{
    m_bench->session().apply(Recipe(), "As opened");
    m_bench->settle();
    m_bench->session().undoStack().clear();
    m_bench->show(Page::Order);
    m_bench->settle();
}

void TestOrders::s23_orderByMouseAndKeys_everythingFollows()
{
    const Interval view = plot("orderBodePlot")->xRange();
    PlotWidget *values = plot("singularValuePlot");
    m_bench->dragLine(values, "order", 20.0);
    m_bench->release(values, 20.5);
    QCOMPARE(m_bench->text("modelOrderReadout"), QString::number(order()));
    QVERIFY(order() > 10);
    QCOMPARE(m_bench->session().undoStack().count(), 1);
    values->setFocus();
    typeOrder("1");
    QCOMPARE(order(), Index(1));
    const QString split = m_bench->finding("ORD-001");
    for (const char *part : {"splits an oscillating pair", "singular values 1 and 2 are "})
        DYNCAL_SAYS(split, part);
    const QString poor = m_bench->text("fitReadout");
    m_bench->clickOffer("correction", "ORD-001", "Use order 2");
    QCOMPARE(order(), Index(2));
    QVERIFY(m_bench->finding("ORD-001").isEmpty());
    QVERIFY2(number(poor) < 60.0 && number(m_bench->text("fitReadout")) > 95.0, qPrintable(poor));
    press(Qt::Key_Right);
    QCOMPARE(order(), Index(3));
    press(Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(m_bench->finding("ORD-001").isEmpty());
    press(Qt::Key_Home);
    QCOMPARE(order(), Index(2));
    press(Qt::Key_Space);
    QCOMPARE(m_bench->recipe().realization.candidates, std::vector<Index>{2});
    press(Qt::Key_Return);
    DYNCAL_SAYS(m_bench->text("adoption"), "adopted");
    m_bench->undo();
    QVERIFY(!m_bench->text("adoption").contains("adopted"));
    QCOMPARE(plot("orderBodePlot")->xRange(), view);
}

void TestOrders::s24_unstableModel_cannotBeAdopted()
{
    typeOrder("60");
    const QString unstable = m_bench->finding("MOD-001");
    QVERIFY2(unstable.startsWith("■"), qPrintable(unstable));
    for (const char *part : {"order 60 is unstable", "Hz", "of magnitude 1.00", "not reportable"})
        DYNCAL_SAYS(unstable, part);
    DYNCAL_SAYS(m_bench->finding("MOD-002"), "Nyquist frequency");
    DYNCAL_SAYS(m_bench->finding("MOD-002"), "come from sampling, not from the sensor");
    auto *adopt = m_bench->find<QPushButton>("adoptOrder");
    QVERIFY(!adopt->isEnabled());
    DYNCAL_SAYS(adopt->toolTip(), "unstable");
    press(Qt::Key_Return); // nor with the key
    QVERIFY(m_bench->recipe().realization.adoptedReason.empty());
}

/// Nearly sixty poles from sixty rows, nearly all of noise: the highest order that diverges.
void TestOrders::s24_divergingCandidate_showsWordsNotNumbers()
{
    const ScenarioBench bench;
    SimulationSettings settings = threeShots();
    settings.noise = 0.05;
    bench.open({bench.record(settings)});
    bench.show(Page::Order);
    bench.type("hankelRowsValue", "60");
    const Interval range = bench.find<PlotWidget>("orderFitPlot")->yRange();
    for (int order = 59; order > 50 && bench.text("fitReadout") != "diverges"; --order) {
        bench.type("orderValue", QString::number(order));
        QTest::keyClick(bench.find<PlotWidget>("singularValuePlot"), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.session().candidates().isComputing(), kPatience_ms);
        bench.settle();
    }
    QCOMPARE(bench.text("fitReadout"), QString("diverges"));
    DYNCAL_SAYS(bench.text("candidateText"), "diverges");
    QVERIFY(!bench.find<QPushButton>("adoptOrder")->isEnabled());
    const Interval now = bench.find<PlotWidget>("orderFitPlot")->yRange();
    QVERIFY(now.end - now.begin < 3.0 * (range.end - range.begin));
    const QRegularExpression wild(
        "\\bnan\\b|\\binf\\b|e\\+?[1-9]\\d", QRegularExpression::CaseInsensitiveOption);
    for (const QLabel *label : bench.window->findChildren<QLabel *>())
        QVERIFY2(!label->text().contains(wild), qPrintable(label->text()));
    for (const QString &row : bench.findings())
        QVERIFY2(!row.contains(wild), qPrintable(row));
    const QJsonObject model = QJsonDocument::fromJson(
        QByteArray::fromStdString(resultsJson(
            {bench.session().results(), bench.session().error(), bench.session().failedStage()},
            bench.recipe(), "2026-01-31T12:00:00Z")))
                                  .object()
                                  .value("model")
                                  .toObject();
    QVERIFY(model.value("fit_percent").isNull());
    DYNCAL_SAYS(model.value("fit_percent_reason").toString(), "diverges");
}

void TestOrders::s24_stepPole_isNeverUnstable()
{
    m_bench->show(Page::ModelInput);
    m_bench->choose("treatment", 1); // as the thesis does: the step takes a pole
    m_bench->show(Page::Order);
    m_bench->settle();
    QVERIFY(m_bench->finding("MOD-001").isEmpty());
    DYNCAL_SAYS(m_bench->finding("MOD-003"), "is the step itself");
    DYNCAL_SAYS(m_bench->finding("MIN-004"), "order");
    DYNCAL_SAYS(m_bench->text("polesReadout"), "0 unstable");
    QCOMPARE(m_bench->text("modelOrderReadout"), QString("3"));
}

void TestOrders::s25_fourOrders_areCompared()
{
    for (const char *typed : {"100", "50", "3", "2"}) {
        typeOrder(typed);
        press(Qt::Key_Space);
    }
    QTRY_VERIFY_WITH_TIMEOUT(!m_bench->session().candidates().isComputing(), kPatience_ms);
    m_bench->settle();
    int cards = 0;
    for (const QWidget *card : m_bench->window->findChildren<QWidget *>("candidateCard"))
        cards += card->isVisible();
    QCOMPARE(cards, 4);
    std::set<Qt::PenStyle> dashes; // told apart without colour
    for (const PlotCurve &curve : plot("orderBodePlot")->content().curves)
        if (curve.role == CurveRole::Model
            || (curve.role >= CurveRole::Candidate1 && curve.role <= CurveRole::Candidate4))
            dashes.insert(lightPlots().style(curve.role, curve.variant).dash);
    QCOMPARE(dashes.size(), std::size_t(4));
    m_bench->click("compareOrders");
    auto *table = m_bench->find<QTableWidget>("candidateTable");
    QVERIFY(table->isVisible());
    QCOMPARE(table->rowCount(), 4);
    const auto orders = [&] {
        QStringList shown;
        for (int row = 0; row < table->rowCount(); ++row)
            shown << table->item(row, 0)->text();
        return shown;
    };
    QCOMPARE(orders(), QStringList({"2", "3", "50", "100"}));
    const QHeaderView *header = table->horizontalHeader();
    const QPoint first(header->sectionViewportPosition(0) + 10, header->height() / 2);
    QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, first);
    QCOMPARE(orders(), QStringList({"100", "50", "3", "2"}));
    compareWithCommandLine();
}

void TestOrders::compareWithCommandLine()
{
    QProcess process;
    process.start(qEnvironmentVariable("DYNCAL_BINARY"),
        {"compare", m_bench->folder.filePath("shots.h5"), "--orders", "2,3,50,100", "--json"});
    QVERIFY(process.waitForFinished(kPatience_ms));
    const QJsonArray rows = QJsonDocument::fromJson(process.readAllStandardOutput())
                                .object()
                                .value("orders")
                                .toArray();
    QCOMPARE(rows.size(), 4);
    for (const QJsonValue &row : rows) {
        const ComparedOrder *shown = m_bench->session().candidates().find(row["order"].toInt());
        QVERIFY(shown && shown->model);
        const double fit_percent = row["fit_percent"].toDouble();
        QVERIFY2(std::abs(shown->model->fit_percent / fit_percent - 1.0) < 1e-12,
            qPrintable(QString::number(fit_percent, 'g', 15)));
    }
}

DYNCAL_TEST(TestOrders)
#include "tst_orders.moc"

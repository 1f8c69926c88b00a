// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/ui/scenarios/scenario_words.h"

using namespace dyncal;
using namespace dyncal::test;

/// Good recordings and a setting that does not suit them.
class TestWrongSettings : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void s15_celsiusTypedAsKelvin_isOfferedAsKelvin();
    void s15_temperature_takesItsUnit_data();
    void s15_temperature_takesItsUnit();
    void s17_windowBehindThePlateau_isMovedBack();
    void s22_rateTooLow_isBlocked_andASparseOneIsNot();

private:
    std::unique_ptr<ScenarioBench> m_bench;
};

void TestWrongSettings::initTestCase()
{
    m_bench = std::make_unique<ScenarioBench>();
    m_bench->open({m_bench->record(threeShots())});
}

void TestWrongSettings::init()
{
    m_bench->session().apply(Recipe(), "As opened");
    m_bench->settle();
    m_bench->session().undoStack().clear();
}

void TestWrongSettings::s15_celsiusTypedAsKelvin_isOfferedAsKelvin()
{
    m_bench->show(Page::Shock);
    m_bench->type("T1Value", "21");
    DYNCAL_SAYS(m_bench->finding("SHK-004"), "294.15 K");
    m_bench->clickOffer("correction", "SHK-004", "Use 294.15 K");
    QVERIFY(m_bench->finding("SHK-004").isEmpty());
    QCOMPARE(m_bench->row("stateTable", "T1").value(1), QString("294.15 K"));
}

void TestWrongSettings::s15_temperature_takesItsUnit_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("shown");
    QTest::newRow("C") << "21 C"
                       << "294.15 K";
    QTest::newRow("degrees C") << "21 °C"
                               << "294.15 K";
    QTest::newRow("F") << "70 F"
                       << "294.26 K";
}

void TestWrongSettings::s15_temperature_takesItsUnit()
{
    QFETCH(QString, typed);
    QFETCH(QString, shown);
    m_bench->show(Page::Shock);
    m_bench->type("T1Value", typed);
    QVERIFY(m_bench->finding("SHK-004").isEmpty());
    QCOMPARE(m_bench->row("stateTable", "T1").value(1), shown);
}

void TestWrongSettings::s17_windowBehindThePlateau_isMovedBack()
{
    m_bench->show(Page::Window);
    m_bench->choose("startShot", 2); // the High shot, whose plateau is the shortest
    m_bench->type("windowEndValue", "1600 µs");
    auto *plot = m_bench->find<PlotWidget>("windowPlot");
    plot->setFocus();
    QTest::keyClick(plot, Qt::Key_F);
    QTest::keyClick(plot, Qt::Key_Minus);
    QTest::qWait(50);
    const int steps = m_bench->session().undoStack().count();
    m_bench->dragLine(plot, "end", 2e-3);
    m_bench->settle();
    DYNCAL_SAYS(m_bench->finding("WIN-001"), "after the computed end of the plateau"); // held still
    m_bench->release(plot, 2e-3);
    QCOMPARE(m_bench->session().undoStack().count(), steps + 1);
    const auto &handles = plot->handles();
    const auto guard = std::ranges::find(handles, QString("guard"), &HandleState::id);
    QVERIFY(guard != handles.end() && !guard->movable && guard->x.begin < 2e-3); // so it is hatched
    const double dragged_s = *m_bench->recipe().window.end_s.value;
    QVERIFY(std::abs(dragged_s - 2e-3) < 2e-5);
    m_bench->clickOffer("correction", "WIN-001", "Move the end to");
    QCOMPARE(m_bench->session().undoStack().count(), steps + 2);
    QVERIFY2(m_bench->finding("WIN-001").isEmpty(), qPrintable(m_bench->finding("WIN-001")));
    m_bench->undo();
    QCOMPARE(*m_bench->recipe().window.end_s.value, dragged_s);
    QVERIFY(!m_bench->finding("WIN-001").isEmpty());
}

void TestWrongSettings::s22_rateTooLow_isBlocked_andASparseOneIsNot()
{
    m_bench->show(Page::ModelInput);
    m_bench->type("modelRateValue", "1 MHz");
    const QString said = m_bench->finding("MIN-001");
    QVERIFY2(said.startsWith("■"), qPrintable(said));
    for (const char *part : {"1 MHz", "2.33 MHz", "330 kHz"})
        DYNCAL_SAYS(said, part);
    QVERIFY(m_bench->session().error()); // nothing is computed after it, nothing can be exported
    m_bench->type("modelRateValue", "10 MHz");
    QVERIFY(!m_bench->session().error());
    QVERIFY(m_bench->finding("MIN-001").isEmpty());
    DYNCAL_SAYS(m_bench->text("samplesPerPeriod"), "4.29");
    DYNCAL_SAYS(m_bench->text("samplesPerPeriod"), "▲");
    // 4 to 10 is a note among the findings, below 4 a caution.
    DYNCAL_SAYS(m_bench->finding("MIN-002"), "4.29 samples per period");
    m_bench->type("modelRateValue", "8 MHz");
    QVERIFY(m_bench->finding("MIN-002").startsWith("▲"));
}

DYNCAL_TEST(TestWrongSettings)
#include "tst_wrong_settings.moc"

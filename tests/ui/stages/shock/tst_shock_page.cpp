// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/page_bench.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/shock/shock_page.h"
#include "ui/stages/spectrum/spectrum_page.h"
#include "ui/stages/window/window_page.h"

#include <QCheckBox>
#include <QPushButton>
#include <QtTest>

#include <cmath>

using namespace dyncal;
using test::PageBench;
using test::waitComputed;

namespace {

constexpr double kRate_Hz = 1e7;
constexpr double kDuration_s = 0.01;

const ShockConditions &conditionsOf(const Session &session, Index shot)
{
    return *session.results().shock->ofShot(shot);
}

const std::vector<ArrivalSensor> &sensorsOf(const Session &session)
{
    return session.recipe().shock.arrivalSensors;
}

} // namespace

class TestShockPage : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;

private slots:
    void initTestCase() { m_set = testing::simulatedExample(kRate_Hz, kDuration_s); }

    /// A model rate too low for the resonance blocks the model, not the shock before it.
    void modelBlocked_theShockOfTheseSettingsStays()
    {
        PageBench<ShockPage> bench(m_set);
        const double before_K = conditionsOf(bench.session, 3).states->reflected.temperature_K;
        Recipe recipe = bench.recipe();
        recipe.input.sampleRate_Hz = 1e6;
        recipe.shock.T1_K = 300.0;
        bench.session.apply(recipe, "Change the model rate");
        waitComputed(bench.session);
        QVERIFY(bench.session.error() && !bench.session.results().shock);
        auto *diagram = bench.control<PlotWidget>("tubeDiagram");
        QVERIFY(!diagram->content().curves.empty() && !diagram->isDimmed());
        QVERIFY(!bench.control<PlotWidget>("sidePlot")->content().curves.empty());
        auto *states = bench.control<ValueTable>("stateTable");
        QVERIFY(states->isEnabled() && states->columnCount() == 4);
        QString shown;
        for (int row = 0; row < states->rowCount(); ++row)
            if (states->item(row, 0)->text() == "T1")
                shown = states->item(row, 3)->text();
        QVERIFY2(shown.startsWith("300"), qPrintable(shown));
        const QString sensitivity = bench.control<QLabel>("sensitivityReason")->text();
        QVERIFY2(sensitivity.contains("not determined"), qPrintable(sensitivity));
        bench.session.undoStack().undo();
        waitComputed(bench.session);
        QCOMPARE(conditionsOf(bench.session, 3).states->reflected.temperature_K, before_K);
    }

    void diagramAndTables_showTheShot()
    {
        PageBench<ShockPage> bench(m_set);
        QVERIFY(bench.control<PlotWidget>("tubeDiagram")->content().curves.size() > 5);
        QVERIFY(bench.control<PlotWidget>("tubeDiagram")->content().title.contains("3"));
        bench.choose("shockShot", 0);
        QVERIFY(bench.control<PlotWidget>("tubeDiagram")->content().title.contains("1"));
        QCOMPARE(bench.control<ValueTable>("stepUncertaintyTable")->rowCount(), 15);
        QVERIFY(bench.control<ValueTable>("stepBudgetTable")->rowCount() > 4);
        QCOMPARE(bench.control<ValueTable>("arrivalTable")->rowCount(), 6);
        for (int row = 0; row < 15; ++row) // propagation and Monte Carlo side by side
            for (const int column : {3, 5})
                QVERIFY(bench.control<ValueTable>("stepUncertaintyTable")->item(row, column)->text()
                    != QStringLiteral("–"));
    }

    void draggedArrival_isOneStep_movesTheVelocity_andGoesBack()
    {
        PageBench<ShockPage> bench(m_set);
        bench.choose("shockShot", 1);
        const double before_m_s = conditionsOf(bench.session, 2).states->velocity_m_s;
        const double found_s = conditionsOf(bench.session, 2).seen[0].found->time_s;
        auto *plot = bench.control<PlotWidget>("sidePlot");
        emit plot->lineMoved("arrival", found_s + 2e-6, false);
        emit plot->lineMoved("arrival", found_s + 5e-6, true);
        waitComputed(bench.session);
        QCOMPARE(bench.session.undoStack().count(), 1);
        QCOMPARE(sensorsOf(bench.session).size(), std::size_t(1));
        const std::vector<std::optional<double>> expected{{}, found_s + 5e-6, {}};
        QVERIFY(sensorsOf(bench.session)[0].shotArrival_s == expected);
        const double transit_s = conditionsOf(bench.session, 2).distance_m / before_m_s;
        const double moved = conditionsOf(bench.session, 2).states->velocity_m_s / before_m_s - 1.0;
        constexpr double kSecondOrder = 5e-5; // (5 us of 1.6 ms) squared
        QVERIFY(std::abs(moved - 5e-6 / transit_s) < kSecondOrder);
        // The typed twin shows it, and "auto" finds the arrival again.
        auto *twin = bench.control<QuantityEdit>("arrivalTimeValue");
        QVERIFY(std::abs(twin->si() - found_s - 5e-6) < 1e-9);
        bench.control<QCheckBox>("arrivalTimeAuto")->click();
        waitComputed(bench.session);
        QVERIFY(sensorsOf(bench.session)[0].shotArrival_s.empty());
        QVERIFY(std::abs(conditionsOf(bench.session, 2).states->velocity_m_s / before_m_s - 1.0)
            < 1e-12);
        bench.session.undoStack().undo();
        waitComputed(bench.session);
        QVERIFY(sensorsOf(bench.session)[0].shotArrival_s == expected);
        bench.session.undoStack().undo();
        QVERIFY(sensorsOf(bench.session).empty());
    }

    void sensors_areAddedChangedAndRemoved()
    {
        PageBench<ShockPage> bench(m_set);
        bench.control<QPushButton>("addArrivalSensor")->click();
        waitComputed(bench.session);
        QCOMPARE(sensorsOf(bench.session).size(), std::size_t(2));
        QCOMPARE(bench.control<QComboBox>("arrivalSensor")->currentIndex(), 1);
        bench.type("arrivalDistanceValue", "0.4");
        QCOMPARE(sensorsOf(bench.session)[1].distanceToEndWall_m, 0.4);
        bench.type("arrivalDistanceUncertaintyValue", "0.2");
        QCOMPARE(sensorsOf(bench.session)[1].u_distance_m, 2e-4);
        bench.type("arrivalDelayValue", "1.5");
        QVERIFY(std::abs(*sensorsOf(bench.session)[1].delay_s - 1.5e-6) < 1e-15);
        bench.control<QPushButton>("removeArrivalSensor")->click();
        QCOMPARE(sensorsOf(bench.session).size(), std::size_t(1));
        QVERIFY(!sensorsOf(bench.session)[0].delay_s);
    }

    void gases_showTheirConstants_andOnlyOwnOnesAreTyped()
    {
        PageBench<ShockPage> bench(m_set);
        auto *gamma = bench.control<QuantityEdit>("drivenGamma");
        auto *mass = bench.control<QuantityEdit>("drivenMolarMass");
        QVERIFY(gamma->isReadOnly() && mass->isReadOnly());
        QVERIFY(gamma->toolTip().contains("table 4.1"));
        bench.choose("drivenGas", 3);
        waitComputed(bench.session);
        QCOMPARE(bench.session.recipe().shock.drivenGas.substance, std::string("n2"));
        QCOMPARE(mass->si(), 0.028014);
        QVERIFY(!bench.control<QWidget>("humidity")->isEnabled());
        bench.choose("drivenGas", 2);
        waitComputed(bench.session);
        QVERIFY(bench.control<QWidget>("humidity")->isEnabled());
        bench.type("humidityValue", "40");
        waitComputed(bench.session);
        QVERIFY(gamma->toolTip().contains("Cramer"));
        QVERIFY(gamma->si() > 1.395 && gamma->si() < 1.402); // moist air of the shot, not the 1.402
        bench.choose("driverGas", 7);
        QVERIFY(!bench.control<QuantityEdit>("driverGamma")->isReadOnly());
        bench.control<QuantityEdit>("driverGamma")->setValue(1.5);
        QCOMPARE(bench.session.recipe().shock.driverGas.gamma, 1.5);
        QCOMPARE(bench.session.recipe().shock.driverGas.substance, std::string("custom"));
    }

    void dut_showsPlateauAndDriverGas_withoutACursor()
    {
        PageBench<ShockPage> bench(m_set);
        bench.choose("arrivalSensor", 1); // behind the one side sensor
        const PlotContent &content = bench.control<PlotWidget>("sidePlot")->content();
        QCOMPARE(content.marks.size(), std::size_t(2));
        QVERIFY(!bench.control<QWidget>("arrivalTime")->isEnabled());
    }

    void spectrum_ticksTubeModesOfTheChosenShot()
    {
        PageBench<SpectrumPage> bench(m_set);
        auto *plot = bench.control<PlotWidget>("spectrumPlot");
        const std::size_t ticked = plot->content().marks.size();
        QVERIFY(plot->content().title.contains("tube modes computed"));
        bench.choose("tubeModes", 0);
        QVERIFY(plot->content().marks.size() + 10 < ticked);
        QVERIFY(!plot->content().title.contains("computed"));
    }

    void windowEnd_behindThePlateau_canBeMovedBackAndUndone()
    {
        PageBench<WindowPage> bench(m_set);
        emit bench.control<PlotWidget>("windowPlot")->lineMoved("end", 2e-3, true);
        waitComputed(bench.session);
        std::optional<Correction> correction;
        for (const Finding &finding : bench.session.results().window->findings) {
            if (finding.id == "WIN-001" && finding.shot == 3)
                correction = finding.correction;
        }
        QVERIFY(correction.has_value());
        QCOMPARE(correction->key, std::string("window.end_s"));
        bench.session.undoStack().undo();
        QVERIFY(bench.session.recipe().window.end_s.isAuto());
    }
};

DYNCAL_TEST(TestShockPage)
#include "tst_shock_page.moc"

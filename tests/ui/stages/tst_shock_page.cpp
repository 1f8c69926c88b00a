// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"
#include "core/synthesis/shot_generator.h"
#include "ui/stages/quantity_edit.h"
#include "ui/stages/shock_page.h"
#include "ui/stages/spectrum_page.h"
#include "ui/stages/value_table.h"
#include "ui/stages/window_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

std::shared_ptr<const CaptureSet> example()
{
    SimulationSettings settings;
    settings.sensor = sensorPreset("optic3").value();
    settings.sampleRate_Hz = 1e7;
    settings.duration_s = 0.01;
    settings.noise = 0.01;
    auto set = std::make_shared<CaptureSet>(simulateShots(settings).value().set);
    set->inputs = {{"example", "example", "0123", "simulated"}};
    return set;
}

/// Outside a template, where the compiler does not fall over it.
Session::Pipeline realPipeline()
{
    return runPipeline;
}

/// The page over the real pipeline: what a technician's hand does to the numbers.
template <typename Page>
struct Bench
{
    Session session;
    Page page;
    std::unique_ptr<InspectorForm> inspector;

    explicit Bench(const std::shared_ptr<const CaptureSet> &set)
        : session(realPipeline())
        , page(session)
        , inspector(page.inspector())
    {
        session.setFocus(StageId::Shock);
        session.reset({set, {}});
        page.resize(1000, 800);
        page.show();
        inspector->show();
        settle();
    }

    void settle()
    {
        QTRY_VERIFY_WITH_TIMEOUT(!session.isComputing(), 60000);
        QVERIFY(!session.error());
    }

    template <typename T>
    T *control(const QString &name)
    {
        T *found = inspector->findChild<T *>(name);
        if (!found)
            found = page.template findChild<T *>(name);
        if (!found)
            qFatal("no %s", qPrintable(name));
        return found;
    }
    void choose(const QString &name, int choice)
    {
        auto *box = control<QComboBox>(name);
        box->setCurrentIndex(choice);
        emit box->activated(choice);
    }
    void type(const QString &name, const QString &text)
    {
        auto *edit = control<QLineEdit>(name);
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    const ShockConditions &shot(Index number) const
    {
        return *session.results().shock->ofShot(number);
    }
    const std::vector<ArrivalSensor> &sensors() const
    {
        return session.recipe().shock.arrivalSensors;
    }
};

} // namespace

class TestShockPage : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;

private slots:
    void initTestCase() { m_set = example(); }

    void diagramAndTables_showTheShot()
    {
        Bench<ShockPage> bench(m_set);
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
        Bench<ShockPage> bench(m_set);
        bench.choose("shockShot", 1);
        const double before_m_s = bench.shot(2).states->velocity_m_s;
        const double found_s = bench.shot(2).seen[0].found->time_s;
        auto *plot = bench.control<PlotWidget>("sidePlot");
        emit plot->lineMoved("arrival", found_s + 2e-6, false);
        emit plot->lineMoved("arrival", found_s + 5e-6, true);
        bench.settle();
        QCOMPARE(bench.session.undoStack().count(), 1);
        QCOMPARE(bench.sensors().size(), std::size_t(1));
        const std::vector<std::optional<double>> expected{{}, found_s + 5e-6, {}};
        QVERIFY(bench.sensors()[0].shotArrival_s == expected);
        const double transit_s = bench.shot(2).distance_m / before_m_s;
        const double moved = bench.shot(2).states->velocity_m_s / before_m_s - 1.0;
        constexpr double kSecondOrder = 5e-5; // (5 us of 1.6 ms) squared
        QVERIFY(std::abs(moved - 5e-6 / transit_s) < kSecondOrder);
        // The typed twin shows it, and "auto" finds the arrival again.
        auto *twin = bench.control<QuantityEdit>("arrivalTimeValue");
        QVERIFY(std::abs(twin->si() - found_s - 5e-6) < 1e-9);
        bench.control<QCheckBox>("arrivalTimeAuto")->click();
        bench.settle();
        QVERIFY(bench.sensors()[0].shotArrival_s.empty());
        QVERIFY(std::abs(bench.shot(2).states->velocity_m_s / before_m_s - 1.0) < 1e-12);
        bench.session.undoStack().undo();
        bench.settle();
        QVERIFY(bench.sensors()[0].shotArrival_s == expected);
        bench.session.undoStack().undo();
        QVERIFY(bench.sensors().empty());
    }

    void sensors_areAddedChangedAndRemoved()
    {
        Bench<ShockPage> bench(m_set);
        bench.control<QPushButton>("addArrivalSensor")->click();
        bench.settle();
        QCOMPARE(bench.sensors().size(), std::size_t(2));
        QCOMPARE(bench.control<QComboBox>("arrivalSensor")->currentIndex(), 1);
        bench.type("arrivalDistanceValue", "0.4");
        QCOMPARE(bench.sensors()[1].distanceToEndWall_m, 0.4);
        bench.type("arrivalDistanceUncertaintyValue", "0.2");
        QCOMPARE(bench.sensors()[1].u_distance_m, 2e-4);
        bench.type("arrivalDelayValue", "1.5");
        QVERIFY(std::abs(*bench.sensors()[1].delay_s - 1.5e-6) < 1e-15);
        bench.control<QPushButton>("removeArrivalSensor")->click();
        QCOMPARE(bench.sensors().size(), std::size_t(1));
        QVERIFY(!bench.sensors()[0].delay_s);
    }

    void gases_showTheirConstants_andOnlyOwnOnesAreTyped()
    {
        Bench<ShockPage> bench(m_set);
        auto *gamma = bench.control<QuantityEdit>("drivenGamma");
        auto *mass = bench.control<QuantityEdit>("drivenMolarMass");
        QVERIFY(gamma->isReadOnly() && mass->isReadOnly());
        QVERIFY(gamma->toolTip().contains("table 4.1"));
        bench.choose("drivenGas", 2);
        bench.settle();
        QCOMPARE(bench.session.recipe().shock.drivenGas.substance, std::string("n2"));
        QCOMPARE(mass->si(), 0.028014);
        QVERIFY(!bench.control<QWidget>("humidity")->isEnabled());
        bench.choose("drivenGas", 1);
        bench.settle();
        QVERIFY(bench.control<QWidget>("humidity")->isEnabled());
        bench.type("humidityValue", "40");
        bench.settle();
        QVERIFY(gamma->toolTip().contains("Cramer"));
        QVERIFY(gamma->si() > 1.395 && gamma->si() < 1.402); // moist air of the shot, not the 1.402
        bench.choose("driverGas", 6);
        QVERIFY(!bench.control<QuantityEdit>("driverGamma")->isReadOnly());
        bench.control<QuantityEdit>("driverGamma")->setValue(1.5);
        QCOMPARE(bench.session.recipe().shock.driverGas.gamma, 1.5);
        QCOMPARE(bench.session.recipe().shock.driverGas.substance, std::string("custom"));
    }

    void dut_showsPlateauAndDriverGas_withoutACursor()
    {
        Bench<ShockPage> bench(m_set);
        bench.choose("arrivalSensor", 1); // behind the one side sensor
        const PlotContent &content = bench.control<PlotWidget>("sidePlot")->content();
        QCOMPARE(content.marks.size(), std::size_t(2));
        QVERIFY(!bench.control<QWidget>("arrivalTime")->isEnabled());
    }

    void spectrum_ticksTubeModesOfTheChosenShot()
    {
        Bench<SpectrumPage> bench(m_set);
        auto *plot = bench.control<PlotWidget>("spectrumPlot");
        const std::size_t ticked = plot->content().marks.size();
        QVERIFY(plot->content().title.contains("tube modes computed"));
        bench.choose("tubeModes", 0);
        QVERIFY(plot->content().marks.size() + 10 < ticked);
        QVERIFY(!plot->content().title.contains("computed"));
    }

    void windowEnd_behindThePlateau_canBeMovedBackAndUndone()
    {
        Bench<WindowPage> bench(m_set);
        emit bench.control<PlotWidget>("windowPlot")->lineMoved("end", 2e-3, true);
        bench.settle();
        std::optional<Mend> mend;
        for (const Finding &finding : bench.session.results().window->findings) {
            if (finding.id == "WIN-001" && finding.shot == 3)
                mend = finding.mend;
        }
        QVERIFY(mend.has_value());
        QCOMPARE(mend->key, std::string("window.end_s"));
        bench.session.undoStack().undo();
        QVERIFY(bench.session.recipe().window.end_s.isAuto());
    }
};

QTEST_MAIN(TestShockPage)
#include "tst_shock_page.moc"

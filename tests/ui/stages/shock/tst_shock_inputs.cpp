// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"
#include "tests/ui/support/in_swedish.h"
#include "tests/ui/support/kept_bench.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/value_table.h"
#include "ui/stages/shock/sensor_arrivals.h"
#include "ui/stages/shock/shock_page.h"
#include "ui/text/quantity_format.h"

#include <QCheckBox>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include <cmath>
#include <numbers>

using namespace dyncal;
using test::PageBench;
using test::waitComputed;

namespace {

using Bench = PageBench<ShockPage>;

const ShockConditions &shotOf(const Bench &bench, Index shot)
{
    return *bench.session.results().shock->ofShot(shot);
}

QString cell(Bench &bench, const char *table, const QString &rowName, int column)
{
    const auto *values = bench.control<ValueTable>(table);
    for (int row = 0; row < values->rowCount(); ++row)
        if (values->item(row, 0)->text() == rowName)
            return values->item(row, column)->text();
    return {};
}

void typeAndWait(Bench &bench, const QString &name, const QString &text)
{
    bench.type(name, text);
    waitComputed(bench.session);
}

void undo(Bench &bench)
{
    bench.session.undoStack().undo();
    waitComputed(bench.session);
}

} // namespace

/// What is typed about the gas, the tube and the sensors, and what the shock makes of it.
class TestShockInputs : public QObject
{
    Q_OBJECT

private:
    Bench &fresh()
    {
        Bench &bench = m_kept.fresh(m_set);
        bench.choose("shockShot", 2);
        return bench;
    }
    std::shared_ptr<const CaptureSet> m_set;
    test::KeptBench<ShockPage> m_kept;

private slots:
    void initTestCase() { m_set = testing::simulatedExample(1e7, 0.004); }
    void init() { QLocale::setDefault(QLocale::c()); }
    void pressureTyped_scalesTheStep_andEmptiedIsTheRecordings();
    void velocityTyped_givesTheMachNumber();
    void stepTyped_winsOverTheShock_andUndone();
    void shockSwitchedOff_saysNotDetermined();
    void gasChanged_isHeardAtOnce_andUndone();
    void arrivalTyped_isOfTheShotOnShow();
    void distanceEmptied_takesTheSensorOut();
    void sensorAdded_isACopyWithoutItsArrivals();
    void shotExcluded_tablesLeaveItOut();
    void guard_shortensThePlateau();
    void frontStated_isTakenOut_andEmptiedAgain();
    void swedish_tablesAndTyping();
    void typedArrivals_keepTheOthers();
};

void TestShockInputs::pressureTyped_scalesTheStep_andEmptiedIsTheRecordings()
{
    Bench &bench = fresh();
    auto *field = bench.control<QLineEdit>("p1Value");
    const auto *origin = bench.control<QLabel>("p1Origin");
    const QString recorded = field->text();
    QVERIFY(origin->isVisible());
    const double recorded_Pa = shotOf(bench, 2).states->driven.pressure_Pa;
    QVERIFY(std::abs(typedNumber(recorded).value_or(0.0) * 1e3 / recorded_Pa - 1.0) < 1e-5);
    const double step_Pa = *shotOf(bench, 2).step_Pa;
    typeAndWait(bench, "p1Value", "50");
    QVERIFY(!origin->isVisible());
    // At one Mach number every pressure goes with p1.
    QVERIFY(std::abs(*shotOf(bench, 2).step_Pa / step_Pa - 50e3 / recorded_Pa) < 1e-9);
    QCOMPARE(cell(bench, "stateTable", "p1", 2), QString("50.000 kPa"));
    typeAndWait(bench, "p1Value", " ");
    QVERIFY(!bench.recipe().shock.p1_Pa);
    QCOMPARE(*shotOf(bench, 2).step_Pa, step_Pa);
    QCOMPARE(field->text(), recorded);
    QVERIFY(origin->isVisible());
    typeAndWait(bench, "p1Value", "0,5 bar");
    QCOMPARE(*bench.recipe().shock.p1_Pa, 50e3);
    QTest::mouseClick(bench.control<QToolButton>("p1UseRecorded"), Qt::LeftButton);
    waitComputed(bench.session);
    QVERIFY(!bench.recipe().shock.p1_Pa);
    QCOMPARE(*shotOf(bench, 2).step_Pa, step_Pa);
}

void TestShockInputs::velocityTyped_givesTheMachNumber()
{
    Bench &bench = fresh();
    const double measured_m_s = shotOf(bench, 1).states->velocity_m_s;
    typeAndWait(bench, "shockVelocityValue", "450"); // of the shot on show, and of no other
    const ShockStates &states = *shotOf(bench, 3).states;
    QCOMPARE(states.velocity_m_s, 450.0);
    QVERIFY(std::abs(states.mach - 450.0 / states.driven.soundSpeed_m_s) < 1e-12);
    // The model's delay is that of all shots: their windows, and so the last digits, are others.
    QVERIFY(std::abs(shotOf(bench, 1).states->velocity_m_s / measured_m_s - 1.0) < 1e-8);
    QVERIFY(!bench.recipe().shock.velocity_m_s.common);
    bench.choose("shockShot", 0);
    QVERIFY(bench.control<QLineEdit>("shockVelocityValue")->text().isEmpty());
    bench.choose("shockShot", 2);
    typeAndWait(bench, "shockVelocityValue", "100"); // slower than sound: there is no such shock
    const Findings findings = bench.session.findings();
    QVERIFY(bench.session.error() || std::ranges::any_of(findings, [](const Finding &finding) {
        return finding.severity != Severity::Info && finding.id.starts_with("SHK");
    }));
    undo(bench);
    QCOMPARE(shotOf(bench, 3).states->velocity_m_s, 450.0);
    typeAndWait(bench, "shockVelocityValue", " "); // measured again
    QVERIFY(!bench.recipe().shock.velocity_m_s.isTyped());
}

void TestShockInputs::stepTyped_winsOverTheShock_andUndone()
{
    Bench &bench = fresh();
    const QString computed = cell(bench, "stateTable", "Pressure step", 3);
    typeAndWait(bench, "stepPressureValue", "434.2");
    QCOMPARE(*shotOf(bench, 3).step_Pa, 434.2e3);
    QCOMPARE(cell(bench, "stateTable", "Pressure step", 3), QString("434.2 kPa (typed)"));
    QVERIFY(!shotOf(bench, 2).stepTyped);
    undo(bench);
    QCOMPARE(cell(bench, "stateTable", "Pressure step", 3), computed);
    QVERIFY(bench.control<QLineEdit>("stepPressureValue")->text().isEmpty());
    QCOMPARE(bench.control<QLineEdit>("stepPressureValue")->placeholderText(), QString("computed"));
}

void TestShockInputs::shockSwitchedOff_saysNotDetermined()
{
    Bench &bench = fresh();
    auto *reason = bench.control<QLabel>("sensitivityReason");
    QVERIFY2(!reason->text().contains("not determined"), qPrintable(reason->text()));
    bench.control<QCheckBox>("shockEnabled")->click();
    waitComputed(bench.session);
    QVERIFY2(reason->text().contains("not determined"), qPrintable(reason->text()));
    undo(bench);
    QVERIFY(!reason->text().contains("not determined"));
    QVERIFY(bench.control<QCheckBox>("shockEnabled")->isChecked());
}

void TestShockInputs::gasChanged_isHeardAtOnce_andUndone()
{
    Bench &bench = fresh();
    const double before_m_s = shotOf(bench, 1).states->driven.soundSpeed_m_s;
    const double T1_K = shotOf(bench, 1).states->driven.temperature_K;
    bench.choose("drivenGas", 5); // argon: 5/3, 39.948 g/mol
    waitComputed(bench.session);
    QVERIFY(shotOf(bench, 1).states);
    const double argon_m_s = std::sqrt(5.0 / 3.0 * 8.314462618 / 39.948e-3 * T1_K);
    QVERIFY(std::abs(shotOf(bench, 1).states->driven.soundSpeed_m_s / argon_m_s - 1.0) < 2e-3);
    QVERIFY(std::abs(bench.control<QuantityEdit>("drivenGamma")->si() - 5.0 / 3.0) < 0.002);
    undo(bench);
    QCOMPARE(shotOf(bench, 1).states->driven.soundSpeed_m_s, before_m_s);
    QCOMPARE(bench.control<QComboBox>("drivenGas")->currentIndex(), 0);
}

void TestShockInputs::arrivalTyped_isOfTheShotOnShow()
{
    Bench &bench = fresh();
    bench.choose("shockShot", 0);
    const double found_s
        = shotOf(bench, 1).seen.at(0).found->time_s; // of the record, delay and all
    bench.control<QCheckBox>("arrivalTimeAuto")->click();
    waitComputed(bench.session);
    const auto &typed = bench.recipe().shock.arrivalSensors.at(0).shotArrival_s;
    QCOMPARE(typed.size(), std::size_t(3));
    QVERIFY(typed[0] && !typed[1] && !typed[2]);
    QVERIFY(std::abs(*typed[0] - found_s) < 1e-9);
    bench.choose("shockShot", 1);
    QVERIFY(bench.control<QCheckBox>("arrivalTimeAuto")->isChecked()); // that one is still found
    bench.choose("shockShot", 0);
    QVERIFY(!bench.control<QCheckBox>("arrivalTimeAuto")->isChecked());
    undo(bench);
    QVERIFY(bench.recipe().shock.arrivalSensors.empty());
}

void TestShockInputs::distanceEmptied_takesTheSensorOut()
{
    Bench bench;
    bench.type("arrivalDistanceValue", "0.3");
    QCOMPARE(bench.recipe().shock.arrivalSensors.size(), std::size_t(1));
    bench.type("arrivalDistanceValue", "0"); // no place is 0 m away: not taken
    QCOMPARE(bench.recipe().shock.arrivalSensors.at(0).distanceToEndWall_m, 0.3);
    QCOMPARE(bench.control<QLineEdit>("arrivalDistanceValue")->text(), QString("0.3"));
    bench.type("arrivalDistanceValue", " ");
    QVERIFY(bench.recipe().shock.arrivalSensors.empty());
    QVERIFY(!bench.control<QPushButton>("removeArrivalSensor")->isEnabled());
    waitComputed(bench.session);
}

void TestShockInputs::sensorAdded_isACopyWithoutItsArrivals()
{
    Bench &bench = fresh();
    bench.control<QCheckBox>("arrivalTimeAuto")->click();
    waitComputed(bench.session);
    bench.control<QPushButton>("addArrivalSensor")->click();
    waitComputed(bench.session);
    const auto &sensors = bench.recipe().shock.arrivalSensors;
    QCOMPARE(sensors.size(), std::size_t(2));
    QCOMPARE(sensors[1].channel, sensors[0].channel);
    QVERIFY(!sensors[0].shotArrival_s.empty());
    QVERIFY(sensors[1].shotArrival_s.empty()); // a time belongs to its place
    undo(bench);
    QCOMPARE(bench.recipe().shock.arrivalSensors.size(), std::size_t(1));
    QVERIFY(!bench.recipe().shock.arrivalSensors[0].shotArrival_s.empty());
}

void TestShockInputs::shotExcluded_tablesLeaveItOut()
{
    Bench &bench = fresh();
    auto *states = bench.control<ValueTable>("stateTable");
    QCOMPARE(states->columnCount(), 4);
    Recipe recipe = bench.recipe();
    recipe.import.exclude = {{2, "tore late"}};
    bench.session.apply(recipe, "exclude");
    waitComputed(bench.session);
    QCOMPARE(states->columnCount(), 3);
    QCOMPARE(states->horizontalHeaderItem(2)->text(), QString("Shot 3"));
    bench.choose("shockShot", 1); // it can be chosen still: its record is there
    QVERIFY(bench.control<PlotWidget>("tubeDiagram")->content().curves.empty());
    QCOMPARE(bench.control<ValueTable>("stepBudgetTable")->rowCount(), 0);
    undo(bench);
    QCOMPARE(states->columnCount(), 4);
    QVERIFY(!bench.control<PlotWidget>("tubeDiagram")->content().curves.empty());
}

void TestShockInputs::guard_shortensThePlateau()
{
    Bench &bench = fresh();
    const double before_s = *shotOf(bench, 3).plateau_s;
    typeAndWait(bench, "plateauGuardValue", "100");
    QVERIFY(std::abs(before_s - *shotOf(bench, 3).plateau_s - 100e-6) < 1e-9);
    typeAndWait(bench, "plateauGuardValue", " ");
    QCOMPARE(bench.recipe().shock.plateauGuard_s, 0.0);
    QCOMPARE(*shotOf(bench, 3).plateau_s, before_s);
    QCOMPARE(bench.control<QLineEdit>("plateauGuardValue")->placeholderText(), QString("none"));
}

/// S(f) behind a front is the recorded one over sinc(fT).
void TestShockInputs::frontStated_isTakenOut_andEmptiedAgain()
{
    Bench &bench = fresh();
    const auto *field = bench.control<QLineEdit>("frontDurationValue");
    QCOMPARE(field->placeholderText(), QString("not stated"));
    const ResponseResult before = *bench.session.results().response;
    typeAndWait(bench, "frontDurationValue", "0.2 us");
    typeAndWait(bench, "frontDurationUValue", "20");
    QCOMPARE(bench.recipe().shock.frontDuration_s, 200e-9);
    QCOMPARE(bench.recipe().shock.u_frontDuration_s, 20e-9);
    QCOMPARE(field->text(), QString("200"));
    const ResponseResult &behind = *bench.session.results().response;
    Index compared = 0;
    for (Index row = 0; row < before.magnitude.size(); ++row) {
        // Nearer the end of the band noise makes the mean of the shots another.
        if (!std::isfinite(before.magnitude[row]) || before.frequency_Hz[row] > 400e3)
            continue;
        const double x = std::numbers::pi * before.frequency_Hz[row] * 200e-9;
        const double ratio = behind.magnitude[row] / before.magnitude[row] * std::sin(x) / x;
        QVERIFY2(std::abs(ratio - 1.0) < 1e-3,
            qPrintable(QString("%1 at %2 Hz").arg(ratio).arg(before.frequency_Hz[row])));
        ++compared;
    }
    QVERIFY(compared > 10);
    typeAndWait(bench, "frontDurationValue", " ");
    typeAndWait(bench, "frontDurationUValue", " ");
    QVERIFY(field->text().isEmpty());
    QCOMPARE(bench.recipe().shock.frontDuration_s, 0.0);
    undo(bench);
    QCOMPARE(bench.recipe().shock.u_frontDuration_s, 20e-9);
}

void TestShockInputs::swedish_tablesAndTyping()
{
    const test::InSwedish swedish;
    Bench bench(m_set);
    bench.choose("shockShot", 0);
    typeAndWait(bench, "stepPressureValue", "434,25");
    QCOMPARE(bench.recipe().shock.step_Pa.of(1).value_or(0.0), 434250.0);
    const auto *states = bench.control<ValueTable>("stateTable");
    QCOMPARE(states->horizontalHeaderItem(1)->text(), QString("Skott 1"));
    QVERIFY2(states->item(0, 1)->text().startsWith("434,25 kPa"),
        qPrintable(states->item(0, 1)->text()));
    for (int row = 0; row < states->rowCount(); ++row)
        QVERIFY2(!states->item(row, 1)->text().contains(QRegularExpression("\\d\\.\\d")),
            qPrintable(states->item(row, 1)->text()));
}

void TestShockInputs::typedArrivals_keepTheOthers()
{
    ArrivalSensor sensor{"driven_side", 0.3};
    sensor.arrival_s = 1e-3; // one time for all shots, from an older recipe
    QCOMPARE(*typedArrival_s(sensor, 2), 1e-3);
    typeArrival(sensor, 2, 3, 2e-3);
    QVERIFY(!sensor.arrival_s);
    QCOMPARE(*typedArrival_s(sensor, 1), 1e-3);
    QCOMPARE(*typedArrival_s(sensor, 2), 2e-3);
    QCOMPARE(*typedArrival_s(sensor, 3), 1e-3);
    for (Index shot = 1; shot <= 3; ++shot)
        typeArrival(sensor, shot, 3, {});
    QVERIFY(sensor.shotArrival_s.empty()); // as if nothing had ever been typed
    QVERIFY(!typedArrival_s(sensor, 1));
}

DYNCAL_TEST(TestShockInputs)
#include "tst_shock_inputs.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A step among the reported values: nothing of its budget is lost or changed on the way.

#include "core/uncertainty/step_value.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr StepResult kAll[]
    = {StepResult::Velocity, StepResult::Mach, StepResult::P2, StepResult::P5, StepResult::Step};

/// Two places 0.8 m apart; the first arrival has six degrees of freedom.
StepMeasurement measured()
{
    constexpr double kVelocity_m_s = 512.8;
    StepMeasurement m;
    m.state = {101100.0, 294.15, 0.0, 0.0};
    m.u_p1_Pa = 30.0;
    m.u_T1_K = 0.3;
    Sighting side, wall;
    side.channel = "side";
    side.distance_m = 0.8;
    side.u_distance_m = 2e-4;
    side.u_time_s = 1e-6;
    wall.channel = "DUT";
    wall.time_s = 0.8 / kVelocity_m_s;
    wall.u_time_s = 1e-8;
    wall.isDut = true;
    m.velocity.sightings = {side, wall};
    m.velocity.fit = fitVelocity(m.velocity.sightings, Attenuation::None).value();
    m.velocity.velocity_m_s = m.velocity.fit->velocity_m_s;
    return m;
}

StepUncertainty evaluated(std::vector<StatedUncertainty> stated = {})
{
    return evaluateStep(measured(), {true, std::move(stated)}).value();
}

} // namespace

class TestStepValue : public QObject
{
    Q_OBJECT

private slots:
    void namesAndUnits_areThoseOfResultsJson()
    {
        const StepUncertainty step = evaluated();
        const char *names[] = {"velocity_m_s", "mach", "p2_pa", "p5_pa", "step_pa"};
        const char *units[] = {"m/s", "", "Pa", "Pa", "Pa"};
        for (std::size_t i = 0; i < std::size(kAll); ++i) {
            const ReportedValue value = stepValue(step, kAll[i], 1);
            QCOMPARE(value.of, std::string(names[i]));
            QCOMPARE(value.unit, std::string(units[i]));
            QCOMPARE(value.value, step.budget.value[static_cast<Index>(i)]);
        }
        // p5 - p1 is the step.
        QVERIFY(isNear(stepValue(step, StepResult::P5, 1).value - 101100.0,
            stepValue(step, StepResult::Step, 1).value));
    }

    void uAndDegreesOfFreedom_areThoseOfTheBudget_data()
    {
        QTest::addColumn<double>("correlation");
        QTest::newRow("independent") << 0.0;
        QTest::newRow("correlated") << 0.8;
        QTest::newRow("against each other") << -0.8;
    }
    void uAndDegreesOfFreedom_areThoseOfTheBudget()
    {
        QFETCH(double, correlation);
        std::vector<StatedUncertainty> stated{{"p1_pa", 400.0, Distribution::Normal, 6.0},
            {"t1_k", 1.5, Distribution::Rectangular, {}}};
        if (correlation != 0.0) {
            stated[0].correlated = {{"t1_k", correlation}};
            stated[1].correlated = {{"p1_pa", correlation}};
        }
        const StepUncertainty step = evaluated(stated);
        for (const StepResult result : kAll) {
            const auto at = static_cast<Index>(result);
            const ReportedValue value = stepValue(step, result, 3);
            QVERIFY(isNear(*value.u, step.budget.u[at]));
            if (std::isfinite(step.budget.dof[at]))
                QVERIFY(isNear(value.dof, step.budget.dof[at]));
            else
                QVERIFY(std::isinf(value.dof));
            QCOMPARE(value.lines.size(), step.budget.lines.size());
            for (std::size_t i = 0; i < value.lines.size(); ++i)
                QVERIFY(
                    std::abs(value.sharePercent(value.lines[i]) - step.budget.sharePercent(i, at))
                    < 1e-9);
        }
    }

    /// What all shots have in common is of none; the times of arrival are the shot's.
    void lines_sayWhoseTheyAre()
    {
        const ReportedValue value = stepValue(evaluated(), StepResult::Step, 3);
        int common = 0, own = 0;
        for (const UncertaintyLine &line : value.lines) {
            const bool isArrival = line.quantity.starts_with("arrival_s");
            QCOMPARE(line.shot, Index(isArrival ? 3 : 0));
            QCOMPARE(line.overShots == OverShots::Own, isArrival);
            QVERIFY(isNear(line.sensitivity * line.u, line.contribution));
            ++(isArrival ? own : common);
        }
        QVERIFY(common >= 4 && own == 2);
    }

    void unknownInput_leavesTheValueWithoutU()
    {
        StepMeasurement m = measured();
        m.u_p1_Pa = 0.0; // not stated
        const StepUncertainty step = evaluateStep(m, {true, {}}).value();
        QVERIFY(step.stepMissing);
        const ReportedValue value = stepValue(step, StepResult::Step, 1);
        QVERIFY(std::isfinite(value.value));
        QVERIFY(!value.u && value.lines.empty());
        QVERIFY(stepValue(step, StepResult::Velocity, 1).u);
    }

    void typedStep_hasItsOneLine()
    {
        const auto step = uncertaintyOfTypedStep(
            2e5, {true, {{"step_relative", 0.01, Distribution::Normal, {}}}});
        QVERIFY(step);
        const ReportedValue value = stepValue(*step, StepResult::Step, 1);
        QCOMPARE(value.value, 2e5);
        QVERIFY(isNear(*value.u, 2e3));
        QVERIFY(!stepValue(*step, StepResult::Velocity, 1).u);
    }
};

DYNCAL_TEST(TestStepValue)
#include "tst_step_value.moc"

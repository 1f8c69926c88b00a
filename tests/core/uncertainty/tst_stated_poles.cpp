// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is stated of poles: one number, one uncertainty.

#include "core/pipeline/pipeline.h"
#include "core/uncertainty/stated_poles.h"
#include "tests/support/near.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kClock = 1e-4;

/// A model of two pairs, the first of which is the sensor's.
SensorModel twoPairs()
{
    SensorModel model;
    model.order = 4;
    for (const double frequency_Hz : {1e6, 4e5})
        for (const double side : {1.0, -1.0}) {
            Pole pole;
            pole.z = {0.5, 0.5 * side};
            pole.s_rad_s = {-0.02 * kTwoPi * frequency_Hz, side * kTwoPi * frequency_Hz};
            pole.poleClass = PoleClass::Sensor;
            pole.frequency_Hz = frequency_Hz;
            pole.u_frequency_Hz = 30.0;
            pole.dampingRatio = 0.02;
            pole.u_dampingRatio = 1e-4;
            pole.coverageFactor = 2.1;
            pole.amplitude = frequency_Hz / 1e6;
            model.poles.push_back(pole);
        }
    return model;
}

ModelAssessment assessedPoles(const SensorModel &model)
{
    ModelAssessment assessment;
    assessment.poles = model.poles;
    return assessment;
}

UncertaintyReport reportOf(double u_f0_Hz, double u_zeta)
{
    UncertaintyReport report;
    report.chain = chainEffects({{"clock_relative", kClock, Distribution::Normal, {}}});
    ReportedValue f0{"f0_hz", 1e6, "Hz", {directLine("noise", u_f0_Hz, 5.0)}};
    ReportedValue zeta{"damping_ratio", 0.02, "", {directLine("noise", u_zeta, 5.0)}};
    combineLines(f0);
    combineLines(zeta);
    report.ofModel = {f0, zeta};
    return report;
}

} // namespace

class TestStatedPoles : public QObject
{
    Q_OBJECT

private slots:
    /// Both of the pair: they are one resonance.
    void polesOfTheResonance_haveWhatIsReported()
    {
        const SensorModel model = twoPairs();
        const ModelAssessment assessment = assessedPoles(model);
        const UncertaintyReport report = reportOf(150.0, 3e-4);
        const auto stated = statedPoles(model, &assessment, &report);
        QCOMPARE(stated.size(), std::size_t{4});
        for (const PoleUncertainty &one : {stated[0], stated[1]}) {
            QCOMPARE(one.u_frequency_Hz, 150.0);
            QCOMPARE(one.u_dampingRatio, 3e-4);
            QVERIFY(isNear(one.kFrequency, 2.570582, 1e-6)); // Student, 5 degrees of freedom
            QCOMPARE(one.kDamping, one.kFrequency);
        }
    }

    void otherPoles_haveTheClockBesideTheNoise()
    {
        const SensorModel model = twoPairs();
        const ModelAssessment assessment = assessedPoles(model);
        const UncertaintyReport report = reportOf(150.0, 3e-4);
        const PoleUncertainty other = statedPoles(model, &assessment, &report)[2];
        QVERIFY(isNear(other.u_frequency_Hz, std::hypot(30.0, kClock * 4e5)));
        QCOMPARE(other.u_dampingRatio, 1e-4);
        QCOMPARE(other.kFrequency, 2.1);
        QCOMPARE(other.kDamping, 2.1);
    }

    /// Noise alone is not shown as if it were all.
    void withoutAReport_nothingIsStated()
    {
        const SensorModel model = twoPairs();
        const ModelAssessment assessment = assessedPoles(model);
        for (const PoleUncertainty &one : statedPoles(model, &assessment, nullptr))
            QVERIFY(std::isnan(one.u_frequency_Hz) && std::isnan(one.u_dampingRatio));
        const auto resonance = statedResonance(&model, &assessment, nullptr);
        QVERIFY(resonance && resonance->frequency_Hz == 1e6);
        QVERIFY(std::isnan(resonance->with.u_frequency_Hz));
        QVERIFY(!statedResonance(nullptr, nullptr, nullptr));
    }

    /// A sensor of damping ratio 1.5 has two real poles, neither of them at f0.
    void overdampedSensor_noPoleTakesF0s()
    {
        SensorModel model;
        model.secondOrder = SecondOrderModel{};
        model.secondOrder->f0_Hz = 1e6;
        model.secondOrder->zeta = 1.5;
        for (const double root : {0.381966, 2.618034}) {
            Pole pole;
            pole.z = {0.5, 0.0};
            pole.frequency_Hz = root * 1e6;
            pole.u_frequency_Hz = 30.0;
            pole.dampingRatio = 1.0;
            model.poles.push_back(pole);
        }
        ModelAssessment assessment = assessedPoles(model);
        assessment.secondOrder = model.secondOrder;
        const UncertaintyReport report = reportOf(150.0, 3e-4);
        for (const PoleUncertainty &one : statedPoles(model, &assessment, &report))
            QVERIFY(one.u_frequency_Hz > 30.0 && one.u_frequency_Hz < 300.0
                && one.u_frequency_Hz != 150.0);
        QCOMPARE(statedResonance(&model, &assessment, &report)->with.u_frequency_Hz, 150.0);
    }

    /// The whole pipeline, with a capability that nothing of the records reaches.
    void calibration_onlyOneUncertaintyOfF0()
    {
        Recipe recipe;
        recipe.uncertainty.cmc = {{"f0_hz", 3e3, false}};
        ResultCache cache;
        const CalibrationResults results
            = runPipeline(testing::simulatedExample(2e7), recipe, cache, StageId::Uncertainty)
                  .results;
        const auto resonance = statedResonance(
            results.model.get(), results.assessment.get(), results.uncertainty.get());
        const ReportedValue &f0 = *results.uncertainty->find("f0_hz");
        QVERIFY(resonance && isNear(*f0.expanded(), 3e3));
        QCOMPARE(resonance->with.u_frequency_Hz, *f0.u);
        const auto stated
            = statedPoles(*results.model, results.assessment.get(), results.uncertainty.get());
        int same = 0;
        for (std::size_t i = 0; i < stated.size(); ++i)
            if (results.assessment->poles[i].frequency_Hz == resonance->frequency_Hz) {
                QCOMPARE(stated[i].u_frequency_Hz, *f0.u);
                ++same;
            }
        QCOMPARE(same, 2);
    }
};

DYNCAL_TEST(TestStatedPoles)
#include "tst_stated_poles.moc"

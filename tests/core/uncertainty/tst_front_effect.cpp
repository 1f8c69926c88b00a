// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What another duration of the front makes of a model: undone by the way back, and at a resonance
// what sinc(f T) takes off.

#include "core/model_analysis/model_response.h"
#include "core/uncertainty/chain_effects.h"
#include "core/uncertainty/front_effect.h"
#include "tests/support/cascade_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;

namespace {

constexpr double kF0_Hz = 1e6;

SensorModel sensor(double zeta)
{
    return testing::cascadeModel({{kF0_Hz, zeta}});
}

double gainAtResonance(const SensorModel &model)
{
    return std::abs(modelResponse(model, ResponseTreatment::StepDeflated, kF0_Hz)) / model.level();
}

} // namespace

class TestFrontEffect : public QObject
{
    Q_OBJECT

private slots:
    void thereAndBack_changesNothing()
    {
        const SensorModel model = sensor(0.05);
        const SensorModel back = withFront(withFront(model, 50e-9, 200e-9), 200e-9, 50e-9);
        QVERIFY((back.amplitudes - model.amplitudes).norm() < 1e-14 * model.amplitudes.norm());
        QCOMPARE(back.level(), model.level());
        const SensorModel same = withFront(model, 70e-9, 70e-9);
        QVERIFY((same.amplitudes - model.amplitudes).norm() < 1e-15);
    }

    /// Recorded amplitudes are sinc(f T) of those of a sharp front, so the sharp ones are larger
    /// the longer the front was. The resonance is the ringing alone, to about zeta.
    void aLongerFront_meansMoreRinging()
    {
        const SensorModel model = sensor(0.001);
        for (const double T_s : {50e-9, 100e-9, 300e-9}) {
            const double x = std::numbers::pi * kF0_Hz * T_s;
            const double ratio
                = gainAtResonance(withFront(model, 0.0, T_s)) / gainAtResonance(model);
            QVERIFY2(std::abs(ratio * std::sin(x) / x - 1.0) < 2e-3,
                qPrintable(QString::number(ratio * std::sin(x) / x, 'g', 10)));
        }
    }

    /// With a drift the sensor's own step changes, level and drift do not.
    void sensorsOwnStep_changesWithIt()
    {
        SensorModel model = sensor(0.05);
        model.stepLevel = 1.1;
        model.sensorStep = {1.0, Eigen::VectorXcd::Constant(1, {-3e5, 6e6}),
            Eigen::VectorXcd::Constant(1, {-0.5, 0.1})};
        const SensorModel longer = withFront(model, 0.0, 100e-9);
        QCOMPARE(longer.level(), 1.1);
        const std::complex<double> expected
            = model.sensorStep.amplitudes[0] / frontFactor(100e-9, {-3e5, 6e6});
        QVERIFY(std::abs(longer.sensorStep.amplitudes[0] - expected) < 1e-15);
    }

    void range_isStatedOrUnknown()
    {
        const FrontRange unknown = frontRange({});
        QCOMPARE(unknown.quantity, "front_unknown");
        QCOMPARE(unknown.shorter_s, 0.0);
        QCOMPARE(unknown.longer_s, kUnstatedFront_s);
        QCOMPARE(unknown.divisor, std::sqrt(5.0));
        const FrontRange stated = frontRange({200e-9, 30e-9});
        QCOMPARE(stated.quantity, "front_duration_s");
        QCOMPARE(stated.shorter_s, 170e-9);
        QCOMPARE(stated.longer_s, 230e-9);
        QCOMPARE(stated.divisor, 2.0);
        QCOMPARE(frontRange({10e-9, 30e-9}).shorter_s, 0.0); // no front is shorter than none
    }
};

DYNCAL_TEST(TestFrontEffect)
#include "tst_front_effect.moc"

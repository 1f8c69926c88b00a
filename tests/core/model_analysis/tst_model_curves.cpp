// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/constants.h"
#include "core/model_analysis/model_characteristics.h"
#include "core/model_analysis/model_curves.h"
#include "core/model_analysis/model_response.h"
#include "core/realization/exponentials/exponential_sum.h"
#include "tests/support/model_inputs.h"
#include "tests/support/second_order_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <numbers>

using namespace dyncal;

namespace {
/// The closed-form table prints six decimals; half of the last one.
constexpr double kPrinted = 0.6e-6;
constexpr ResponseTreatment kStep = ResponseTreatment::StepDeflated;
} // namespace

class TestModelCurves : public QObject
{
    Q_OBJECT

private slots:
    void characteristics_equalTheClosedForm_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("overshoot");
        QTest::addColumn<double>("rise");
        QTest::addColumn<double>("settling");
        QTest::addColumn<double>("within5");
        QTest::addColumn<double>("within10");
        QTest::addColumn<double>("minus3");
        const auto row = [](double z, double o, double r, double s, double a, double b, double c) {
            QTest::newRow(qPrintable(QString::number(z))) << z << o << r << s << a << b << c;
        };
        row(0.02, 93.90896, 0.164806, 23.550619, 0.218310, 0.301644, 1.553334);
        row(0.05, 85.44679, 0.168749, 9.531381, 0.218793, 0.302344, 1.551026);
        row(0.10, 72.92476, 0.175739, 4.610377, 0.220547, 0.304888, 1.542771);
        row(0.20, 52.66206, 0.191532, 2.187495, 0.228028, 0.315797, 1.509577);
        row(0.40, 25.38267, 0.232922, 1.210975, 0.268687, 0.377566, 1.374517);
        row(0.50, 16.30335, 0.260628, 0.841785, 0.322072, 0.472769, 1.272020);
        row(0.70, 4.59879, 0.338396, 0.461521, 0.591009, 0.710447, 1.010049);
    }
    void characteristics_equalTheClosedForm()
    {
        QFETCH(double, zeta);
        QFETCH(double, overshoot);
        QFETCH(double, rise);
        QFETCH(double, settling);
        QFETCH(double, within5);
        QFETCH(double, within10);
        QFETCH(double, minus3);
        for (const double gain : {1.0, -3.5}) {
            const double f0_Hz = 2.33e6;
            const StepCharacteristics c
                = stepCharacteristics(testing::secondOrderModel(f0_Hz, zeta, gain), kStep);
            QVERIFY2(std::abs(*c.overshoot_percent - overshoot) < 1e-4,
                qPrintable(QString::number(*c.overshoot_percent, 'g', 10)));
            QVERIFY(std::abs(*c.riseTime_s * f0_Hz - rise) < kPrinted);
            QVERIFY2(std::abs(*c.settlingTime_s * f0_Hz - settling) < kPrinted,
                qPrintable(QString::number(*c.settlingTime_s * f0_Hz, 'g', 10)));
            QVERIFY2(std::abs(*c.within5percent_Hz / f0_Hz - within5) < kPrinted,
                qPrintable(QString::number(*c.within5percent_Hz / f0_Hz, 'g', 10)));
            QVERIFY(std::abs(*c.within10percent_Hz / f0_Hz - within10) < kPrinted);
            QVERIFY(std::abs(*c.minus3dB_Hz / f0_Hz - minus3) < kPrinted);
        }
    }

    /// Of a sensor of f0 = 1: where the step response is highest, and when it enters +-2 % for
    /// good.
    void stepResponse_peaksAndSettles_whereTheClosedFormDoes_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("peak");
        QTest::addColumn<double>("settled");
        QTest::newRow("0.02") << 0.02 << 0.500100 << 31.034336;
        QTest::newRow("0.05") << 0.05 << 0.500626 << 12.097275;
        QTest::newRow("0.10") << 0.10 << 0.502519 << 6.108889;
        QTest::newRow("0.20") << 0.20 << 0.510310 << 3.119740;
        QTest::newRow("0.40") << 0.40 << 0.545545 << 1.338385;
        QTest::newRow("0.50") << 0.50 << 0.577350 << 1.285391;
        QTest::newRow("0.70") << 0.70 << 0.700140 << 0.951554;
    }
    void stepResponse_peaksAndSettles_whereTheClosedFormDoes()
    {
        QFETCH(double, zeta);
        QFETCH(double, peak);
        QFETCH(double, settled);
        const SensorModel model = testing::secondOrderModel(1.0, zeta);
        const ExponentialSum step{1.0,
            Eigen::Vector2cd(model.poles[0].s_rad_s, model.poles[1].s_rad_s), model.amplitudes};
        QVERIFY(step.derivative(peak - 1e-5, 1) > 0.0 && step.derivative(peak + 1e-5, 1) < 0.0);
        // Only compared with the window's length: to the time grid, 40 points per radian.
        QVERIFY(std::abs(*stepCharacteristics(model, kStep).top_s - peak) < 1.0 / (40.0 * kTwoPi));
        const auto deviation = [&](double t_s) { return std::abs(step.value(t_s) - 1.0); };
        QVERIFY(deviation(settled - 1e-5) > 0.02 && deviation(settled + 1e-5) < 0.02);
        for (double t_s = settled + 1e-5; t_s < settled + 2.0; t_s += 1e-3)
            QVERIFY(deviation(t_s) < 0.02);
    }

    void characteristics_ofAFreeDecayOrADivergingModel_areNone()
    {
        SensorModel model = testing::secondOrderModel(1e3, 0.1);
        QVERIFY(!stepCharacteristics(model, ResponseTreatment::Impulse).riseTime_s);
        model.diverges = true;
        QVERIFY(!stepCharacteristics(model, kStep).minus3dB_Hz);
    }

    void response_equalsTheTransferFunction()
    {
        const double f0_Hz = 318e3;
        const double zeta = 0.02;
        const SensorModel model = testing::secondOrderModel(f0_Hz, zeta);
        for (const double f_Hz : {1.0, 1e3, 1e5, 318e3, 1e6, 1e8}) {
            const double r = f_Hz / f0_Hz;
            const std::complex<double> G = 1.0 / std::complex<double>(1.0 - r * r, 2.0 * zeta * r);
            QVERIFY(std::abs(modelResponse(model, kStep, f_Hz) - G) < 1e-12 * (1.0 + std::abs(G)));
        }
    }

    void curve_phaseRunsFromZeroToMinusPi()
    {
        const ResponseCurve curve
            = modelCurve(testing::secondOrderModel(1e5, 0.02), kStep, 10.0, 1e8, 800);
        QVERIFY(std::abs(curve.phase_rad[0]) < 1e-4);
        QVERIFY(std::abs(curve.phase_rad[799] + std::numbers::pi) < 1e-3);
        QVERIFY((curve.phase_rad.tail(799) - curve.phase_rad.head(799)).maxCoeff() <= 0.0);
    }
};

DYNCAL_TEST(TestModelCurves)
#include "tst_model_curves.moc"

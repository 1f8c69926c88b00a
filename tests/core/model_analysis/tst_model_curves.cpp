// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/model_characteristics.h"
#include "core/model_analysis/model_curves.h"
#include "core/model_analysis/model_response.h"
#include "core/model_analysis/step_transform.h"
#include "tests/support/model_inputs.h"
#include "tests/support/second_order_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

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

    void stepTransform_recoversTheSensor()
    {
        // metrology 1.4: at 10 MHz, f0 = 300 kHz, zeta = 0.02, onset half a sample before the
        // first: the bracket leaves less than 1e-4 % at 100 kHz; a long record leaves no
        // truncation.
        const double rate_Hz = 10e6;
        const SensorModel model = testing::secondOrderModel(300e3, 0.02);
        const Eigen::VectorXd y = testing::sampledStep(300e3, 0.02, rate_Hz, 20000, 0.5);
        for (const double f_Hz : {1e3, 3e4, 1e5, 2.5e5}) {
            const std::complex<double> S = stepTransform(y, rate_Hz, 1.0, -0.5 / rate_Hz, f_Hz);
            const std::complex<double> G = modelResponse(model, kStep, f_Hz);
            // Aliasing grows with frequency; 1 % of (f / rate) bounds it here.
            QVERIFY2(std::abs(S / G - 1.0) < 2e-6 + 1e-4 * f_Hz / 2.5e5,
                qPrintable(QString::number(std::abs(S / G - 1.0))));
        }
    }

    void stepTransform_equalsTheSumWrittenOut()
    {
        std::mt19937 random(3);
        std::normal_distribution<double> normal;
        for (const Index size :
            {Index(1), Index(2), Index(256), Index(257), Index(258), Index(5000)}) {
            const Eigen::VectorXd y
                = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(random); });
            for (const double x : {1e-3, 0.7, 3.1}) {
                const double rate_Hz = 1e6;
                std::complex<double> D = 0.0;
                for (Index n = 0; n <= size; ++n) {
                    const double now = n < size ? y[n] : 0.4;
                    D += (now - (n > 0 ? y[n - 1] : 0.0)) * std::polar(1.0, -x * double(n));
                }
                const std::complex<double> expected
                    = D * std::complex<double>(0.0, x) / (1.0 - std::polar(1.0, -x));
                const std::complex<double> found
                    = stepTransform(y, rate_Hz, 0.4, 0.0, x * rate_Hz / (2.0 * std::numbers::pi));
                QVERIFY(std::abs(found - expected) < 1e-12 * double(size + 10));
            }
        }
    }

    void stepTransformError_isThatOfTheSamples()
    {
        // Coarsely sampled (aliasing of 12 % at 400 kHz) and cut off before it has settled; the
        // first sample at, before or behind the onset.
        const double rate_Hz = 1e6;
        const SensorModel model = testing::secondOrderModel(300e3, 0.02);
        ExponentialSum sum{1.0, Eigen::VectorXcd(2), model.amplitudes};
        sum.poles_rad_s << model.poles[0].s_rad_s, model.poles[1].s_rad_s;
        for (const Index samples : {Index(30), Index(3000)}) {
            for (const double first : {0.0, 0.3, 0.99, -2.4}) {
                const Eigen::VectorXd y
                    = testing::sampledStep(300e3, 0.02, rate_Hz, samples, first);
                for (const double f_Hz : {0.0, 1e3, 1e5, 2.9e5, 4e5}) {
                    const double onset_s = -first / rate_Hz;
                    const std::complex<double> expected
                        = stepTransform(y, rate_Hz, 1.0, onset_s, f_Hz)
                        - modelResponse(model, kStep, f_Hz);
                    const std::complex<double> found
                        = stepTransformError(sum, samples, rate_Hz, onset_s, f_Hz);
                    QVERIFY2(std::abs(found - expected) < 1e-10,
                        qPrintable(QString::number(std::abs(found - expected))));
                    if (f_Hz == 4e5 && samples > 1000)
                        QVERIFY(std::abs(expected) > 0.05); // it is worth taking off
                }
            }
        }
    }

    void stepTransformError_isPoissonsSum()
    {
        // m = +-1 .. +-400 of G(f + m fs) f/(f + m fs) e^(-2 pi j m fs onset): what docs/method
        // say.
        const double rate_Hz = 1e6, f_Hz = 1.7e5, onset_s = -0.3e-6;
        const SensorModel model = testing::secondOrderModel(300e3, 0.02);
        ExponentialSum sum{1.0, Eigen::VectorXcd(2), model.amplitudes};
        sum.poles_rad_s << model.poles[0].s_rad_s, model.poles[1].s_rad_s;
        std::complex<double> aliases = 0.0;
        for (int m = -400; m <= 400; ++m) {
            const double at_Hz = f_Hz + m * rate_Hz;
            const std::complex<double> G = at_Hz > 0.0
                ? modelResponse(model, kStep, at_Hz)
                : std::conj(modelResponse(model, kStep, -at_Hz));
            if (m != 0)
                aliases += G * f_Hz / at_Hz
                    * std::polar(1.0, -2.0 * std::numbers::pi * m * rate_Hz * onset_s);
        }
        const std::complex<double> found = stepTransformError(sum, 5000, rate_Hz, onset_s, f_Hz);
        // Terms fall as 1/m^3.
        QVERIFY2(std::abs(found - aliases) < 1e-6,
            qPrintable(QString::number(std::abs(found - aliases))));
    }

    void stepTransform_atZeroFrequency_isThePlateau()
    {
        const Eigen::VectorXd y = testing::sampledStep(300e3, 0.02, 1e7, 500, 0.5);
        QVERIFY(std::abs(stepTransform(y, 1e7, 1.25, 0.0, 0.0) - 1.25) < 1e-12);
    }

    void stepTransformNoise_matchesTheScatter()
    {
        constexpr Index kSamples = 1000;
        constexpr int kTrials = 400;
        testing::Noise noise(8);
        double squares = 0.0;
        for (int trial = 0; trial < kTrials; ++trial) {
            const std::complex<double> S
                = stepTransform(noise.series(kSamples, 0.01), 1e7, 0.0, 0.0, 4e5);
            squares += std::norm(S) / 2.0 / kTrials;
        }
        const double stated = stepTransformNoise(kSamples, 1e7, 0.01, 4e5);
        // sd of a mean of 400 squares of a complex Gaussian is 5 %; the end level adds a little
        QVERIFY2(std::abs(std::sqrt(squares) / stated - 1.0) < 0.1,
            qPrintable(QString::number(std::sqrt(squares) / stated)));
    }
};

DYNCAL_TEST(TestModelCurves)
#include "tst_model_curves.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/exponentials/exponential_sum.h"
#include "core/realization/exponentials/onset.h"
#include "core/realization/hankel/state_space_model.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using Complex = std::complex<double>;

class TestExponentialSum : public QObject
{
    Q_OBJECT

private slots:
    void pairedPoles_putsPartnersTogether()
    {
        Eigen::VectorXcd mixed(5);
        mixed << Complex(0.2, -0.9), Complex(0.5), Complex(0.8, 0.1), Complex(0.2, 0.9),
            Complex(0.8, -0.1);
        const auto poles = pairedPoles(mixed);
        QCOMPARE(poles.size(), std::size_t(5));
        QCOMPARE(poles[0], Complex(0.5));
        QCOMPARE(poles[1], Complex(0.8, 0.1));
        QCOMPARE(poles[2], std::conj(poles[1]));
        QVERIFY(isUpperOfPair(poles, 3) && !isUpperOfPair(poles, 4) && !isUpperOfPair(poles, 0));
    }

    void fitAmplitudes_recoversConstructedOnes()
    {
        constexpr double kRounding = 1e-12;
        const std::vector<Complex> poles{{0.97}, {0.6, 0.7}, {0.6, -0.7}, {-0.5}};
        Eigen::VectorXcd c(4);
        c << 0.4, Complex(-0.3, 0.2), Complex(-0.3, -0.2), 0.05;
        Eigen::VectorXd y = Eigen::VectorXd::Constant(80, 1.7);
        for (Index k = 0; k < 80; ++k) {
            for (Index i = 0; i < 4; ++i)
                y[k] += (c[i] * std::pow(poles[static_cast<std::size_t>(i)], double(k))).real();
        }
        const AmplitudeFit fit = fitAmplitudes(y, poles, true);
        QVERIFY(std::abs(fit.constant - 1.7) < kRounding);
        QVERIFY((fit.amplitudes - c).cwiseAbs().maxCoeff() < kRounding);
        QVERIFY((fit.fitted - y).cwiseAbs().maxCoeff() < kRounding);
    }

    void fitAmplitudes_ofAGrowingPole_doesNotOverflow()
    {
        const std::vector<Complex> poles{{1.9}, {0.9}};
        const AmplitudeFit fit = fitAmplitudes(Eigen::VectorXd::Ones(3000), poles, true);
        QVERIFY(fit.fitted.allFinite());
        QVERIFY(fit.amplitudes.allFinite());
        QVERIFY((fit.fitted.array() - 1.0).abs().maxCoeff() < 1e-9);
    }

    void onset_ofASecondOrderStep_data()
    {
        QTest::addColumn<double>("zeta");
        QTest::addColumn<double>("early");
        QTest::newRow("ringing") << 0.02 << 0.06;
        QTest::newRow("late start") << 0.02 << 0.45;
        QTest::newRow("damped") << 0.7 << 0.1;
        QTest::newRow("start before the onset") << 0.1 << -0.05;
    }
    void onset_ofASecondOrderStep()
    {
        // Time 0 is where the start was detected, `early` periods behind the true onset.
        QFETCH(double, zeta);
        QFETCH(double, early);
        const double f0_Hz = 1e6;
        const double w0 = 2.0 * std::numbers::pi * f0_Hz;
        const Complex s = w0 * Complex(-zeta, std::sqrt(1.0 - zeta * zeta));
        ExponentialSum sum{1.0, Eigen::VectorXcd(2), Eigen::VectorXcd(2)};
        sum.poles_rad_s << s, std::conj(s);
        // 1 + 2 Re(c e^(s t)) with y(0) = y'(0) = 0
        const Complex c = std::conj(s) / (s - std::conj(s));
        const double onset_s = -early / f0_Hz;
        sum.amplitudes << c * std::exp(-s * onset_s), std::conj(c * std::exp(-s * onset_s));
        const auto found = findOnset_s(sum, 0.6 / f0_Hz);
        QVERIFY(found.has_value());
        QVERIFY2(std::abs(*found - onset_s) < 1e-6 / f0_Hz, qPrintable(QString::number(*found)));
    }

    void onset_ofAFirstOrderLag()
    {
        ExponentialSum sum{2.0, Eigen::VectorXcd(1), Eigen::VectorXcd(1)};
        sum.poles_rad_s << -1e5;
        sum.amplitudes << -2.0 * std::exp(-0.3); // began 3 us before
        const auto found = findOnset_s(sum, 1e-5);
        QVERIFY(found && std::abs(*found + 3e-6) < 1e-12);
    }

    void modalStateSpace_hasTheResidues()
    {
        const std::vector<Complex> poles{{0.9, 0.2}, {0.9, -0.2}, {0.5}};
        Eigen::VectorXcd residues(3);
        residues << Complex(0.3, -0.1), Complex(0.3, 0.1), Complex(-0.2);
        const StateSpaceModel model = modalStateSpace(poles, residues, 0.7, 1e-6);
        const Eigen::VectorXd h = impulseResponse(model, 40);
        QVERIFY(std::abs(h[0] - 0.7) < 1e-15);
        for (Index k = 1; k < 40; ++k) {
            Complex expected = 0.0;
            for (Index i = 0; i < 3; ++i)
                expected
                    += residues[i] * std::pow(poles[static_cast<std::size_t>(i)], double(k - 1));
            QVERIFY(std::abs(h[k] - expected.real()) < 1e-13);
        }
    }

    void modalStateSpace_ofAFoldedResonance_hasTheResidues()
    {
        // Above the Nyquist frequency the upper half of the pair in s is the lower one in z.
        const std::vector<Complex> poles{{0.9, -0.2}, {0.9, 0.2}, {0.5}, {-0.3, -0.1}, {-0.3, 0.1}};
        Eigen::VectorXcd residues(5);
        residues << Complex(0.3, -0.1), Complex(0.3, 0.1), Complex(-0.2), Complex(0.1, 0.4),
            Complex(0.1, -0.4);
        const Eigen::VectorXd h = impulseResponse(modalStateSpace(poles, residues, 0.7, 1e-6), 40);
        for (Index k = 1; k < 40; ++k) {
            Complex expected = 0.0;
            for (Index i = 0; i < 5; ++i)
                expected
                    += residues[i] * std::pow(poles[static_cast<std::size_t>(i)], double(k - 1));
            QVERIFY(std::abs(h[k] - expected.real()) < 1e-13);
        }
    }

    void zeros_makeTheTransferFunctionVanish()
    {
        const std::vector<Complex> poles{{0.9, 0.2}, {0.9, -0.2}, {0.5}};
        Eigen::VectorXcd residues(3);
        residues << Complex(0.3, -0.1), Complex(0.3, 0.1), Complex(-0.2);
        for (const double feedthrough : {0.7, 0.0}) {
            const StateSpaceModel model = modalStateSpace(poles, residues, feedthrough, 1.0);
            const auto zeros = transmissionZeros(model);
            QCOMPARE(zeros.size(), std::size_t(feedthrough != 0.0 ? 3 : 2));
            for (const Complex &z : zeros) {
                Complex value = feedthrough;
                for (Index i = 0; i < 3; ++i)
                    value += residues[i] / (z - poles[static_cast<std::size_t>(i)]);
                QVERIFY2(std::abs(value) < 1e-10, qPrintable(QString::number(std::abs(value))));
            }
        }
    }

    void sampler_givesTheValuesOfTheSum()
    {
        ExponentialSum sum{0.7, Eigen::VectorXcd(3), Eigen::VectorXcd(3)};
        sum.poles_rad_s << Complex(-300.0, 9e4), Complex(-300.0, -9e4), Complex(-20.0, 0.0);
        sum.amplitudes << Complex(0.3, -0.4), Complex(0.3, 0.4), Complex(-1.1, 0.0);
        const double dt_s = 1e-6;
        const ExponentialSampler sampler(sum, dt_s);
        constexpr double kRounding = 1e-12; // of 256 products
        for (const Index block : {Index(0), Index(1), Index(40)}) {
            const Eigen::VectorXd values = sampler.block(block);
            QCOMPARE(values.size(), ExponentialSampler::kBlock);
            for (Index j = 0; j < values.size(); ++j) {
                const double t_s
                    = static_cast<double>(block * ExponentialSampler::kBlock + j) * dt_s;
                QVERIFY(std::abs(values[j] - sum.value(t_s)) < kRounding);
            }
        }
    }
};

DYNCAL_TEST(TestExponentialSum)
#include "tst_exponential_sum.moc"

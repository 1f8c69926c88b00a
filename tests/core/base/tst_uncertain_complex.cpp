// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/uncertain_complex.h"
#include "tests/support/model_inputs.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

UncertainComplex made(Complex value, double varRe, double cov, double varIm)
{
    UncertainComplex z{value};
    z.covariance << varRe, cov, cov, varIm;
    return z;
}

} // namespace

class TestUncertainComplex : public QObject
{
    Q_OBJECT

private slots:
    void polar_ofARealValue_isReadOffByEye()
    {
        const UncertainPolar z = toPolar(made(-2.0, 0.04, 0.0, 0.01));
        QCOMPARE(z.magnitude, 2.0);
        QVERIFY(std::abs(std::abs(z.phase_rad) - M_PI) < 1e-15);
        QVERIFY(std::abs(z.covariance(0, 0) - 0.04) < 1e-15); // along the axis
        QVERIFY(std::abs(z.covariance(1, 1) - 0.01 / 4.0) < 1e-15); // across it, over the distance
        QVERIFY(std::abs(z.covariance(0, 1)) < 1e-15);
    }

    void polar_andBack_isTheSame()
    {
        for (const Complex value : {Complex(3.0, 4.0), Complex(-1e-3, 2e-3), Complex(1e6, -1e-6)}) {
            const double v = std::norm(value);
            const UncertainComplex z = made(value, 2e-4 * v, -0.7e-4 * v, 1e-4 * v);
            const UncertainComplex back = toRectangular(toPolar(z));
            QVERIFY(std::abs(back.value - value) < 1e-15 * std::abs(value));
            QVERIFY((back.covariance - z.covariance).cwiseAbs().maxCoeff() < 1e-18 * v);
        }
    }

    void phaseOfZero_isNotDetermined()
    {
        const UncertainPolar z = toPolar(made(0.0, 1.0, 0.0, 1.0));
        QCOMPARE(z.magnitude, 0.0);
        QVERIFY(std::isnan(z.covariance(1, 1)));
    }

    void quotient_byAKnownNumber_isScaledAndTurned()
    {
        const UncertainComplex z
            = quotient(made({1.0, 2.0}, 0.09, 0.0, 0.01), made({0.0, 2.0}, 0.0, 0.0, 0.0));
        QVERIFY(std::abs(z.value - Complex(1.0, -0.5)) < 1e-15);
        QVERIFY(std::abs(z.covariance(0, 0) - 0.01 / 4.0) < 1e-16); // a quarter turn swaps the two
        QVERIFY(std::abs(z.covariance(1, 1) - 0.09 / 4.0) < 1e-16);
    }

    void quotient_byZero_isNotANumber()
    {
        const UncertainComplex z = quotient(made(1.0, 0.1, 0.0, 0.1), made(0.0, 0.1, 0.0, 0.1));
        QVERIFY(!std::isfinite(z.value.real()) && !z.covariance.allFinite());
    }

    /// 40 000 draws of numerator, and of magnitude and phase of the denominator; first order leaves
    /// out squares of relative u of 1 %. A variance of so many draws scatters by 0.7 %.
    void quotient_isTheScatterOfDraws()
    {
        constexpr int kDraws = 40000;
        testing::Noise noise(5);
        UncertainPolar H{1.3, -0.3};
        H.covariance.diagonal() << 1e-4, 4e-4;
        const UncertainComplex F = made({-1.6, -0.2}, 9e-4, 0.0, 1e-4);
        const UncertainComplex stated = quotient(F, toRectangular(H));
        Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
        for (int i = 0; i < kDraws; ++i) {
            const Complex f = F.value + Complex(0.03 * noise.next(), 0.01 * noise.next());
            const Complex error
                = f / std::polar(1.3 + 0.01 * noise.next(), -0.3 + 0.02 * noise.next())
                - stated.value;
            const Eigen::Vector2d parts(error.real(), error.imag());
            scatter += parts * parts.transpose() / kDraws;
        }
        for (const int i : {0, 1})
            QVERIFY(std::abs(scatter(i, i) / stated.covariance(i, i) - 1.0) < 0.03);
        const double size = std::sqrt(stated.covariance(0, 0) * stated.covariance(1, 1));
        QVERIFY(std::abs(scatter(0, 1) - stated.covariance(0, 1)) < 0.03 * size);
    }
};

DYNCAL_TEST(TestUncertainComplex)
#include "tst_uncertain_complex.moc"

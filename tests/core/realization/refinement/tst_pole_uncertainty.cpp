// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/pole_uncertainty.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kRounding = 1e-12;
constexpr double kTwoPi = 2.0 * M_PI;
constexpr double kOmega = kTwoPi * 30e3;

std::complex<double> poleOf(double zeta, double omega = kOmega)
{
    return omega * std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta));
}

bool isNear(double a, double b, double relative = kRounding)
{
    return std::abs(a - b) <= relative * std::abs(b);
}

/// A pair and a real pole, each with a variance of its own.
Refinement pairAndReal()
{
    Refinement fit;
    fit.poles_rad_s = {poleOf(0.1), std::conj(poleOf(0.1)), -4e4};
    fit.poleParameters = 3;
    fit.covariance = Eigen::MatrixXd::Zero(6, 6);
    fit.covariance.topLeftCorner<2, 2>() << 90.0, 12.0, 12.0, 40.0;
    fit.covariance(2, 2) = 2500.0;
    return fit;
}

} // namespace

class TestPoleUncertainty : public QObject
{
    Q_OBJECT

private slots:
    void frequencyAndDamping_ofThePole()
    {
        for (const double zeta : {0.001, 0.05, 0.7, 0.999}) {
            const PoleFigures figures = pairFigures(poleOf(zeta), Eigen::Matrix2d::Identity());
            QVERIFY(isNear(figures.frequency_Hz, 30e3));
            QVERIFY(isNear(figures.dampingRatio, zeta));
        }
    }

    void equalUncorrelatedParts_closedForm()
    {
        // In polar coordinates: sd along the radius over 2 pi, sd across it over |s| as an angle,
        // zeta = cos(angle to the negative axis), so u(zeta) = sin(angle) sd/|s|.
        constexpr double kSd = 7.0;
        for (const double zeta : {0.001, 0.05, 0.7, 0.999}) {
            const PoleFigures figures
                = pairFigures(poleOf(zeta), kSd * kSd * Eigen::Matrix2d::Identity());
            QVERIFY(isNear(figures.u_frequency_Hz, kSd / kTwoPi));
            QVERIFY(isNear(figures.u_dampingRatio, std::sqrt(1.0 - zeta * zeta) * kSd / kOmega));
        }
    }

    void alongAndAcrossTheRadius_moveOneFigureOnly()
    {
        for (const double zeta : {0.001, 0.02, 0.05, 0.3, 0.7, 0.9}) {
            const std::complex<double> s = poleOf(zeta);
            const Eigen::Vector2d along(s.real() / kOmega, s.imag() / kOmega);
            const Eigen::Vector2d across(-along[1], along[0]);
            const Eigen::Matrix2d little = 1e-4 * Eigen::Matrix2d::Identity(); // sd 0.01 all round
            constexpr double kCancelled = 1e-9; // of the larger variance, 1e5 times as large
            const double sine = std::sqrt(1.0 - zeta * zeta);
            const PoleFigures radial = pairFigures(s, 9.0 * along * along.transpose() + little);
            QVERIFY(isNear(radial.u_frequency_Hz, std::hypot(3.0, 0.01) / kTwoPi));
            QVERIFY(isNear(radial.u_dampingRatio, 0.01 * sine / kOmega, kCancelled));
            const PoleFigures turned = pairFigures(s, 9.0 * across * across.transpose() + little);
            QVERIFY(isNear(turned.u_frequency_Hz, 0.01 / kTwoPi, kCancelled));
            QVERIFY(isNear(turned.u_dampingRatio, std::hypot(3.0, 0.01) * sine / kOmega));
        }
    }

    void covarianceThatIsNone_isUnknownNotCertain()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        for (const double variance : {nan, -1.0}) {
            const PoleFigures figures
                = pairFigures(poleOf(0.1), variance * Eigen::Matrix2d::Identity());
            QVERIFY(isNear(figures.frequency_Hz, 30e3));
            QVERIFY(std::isnan(figures.u_frequency_Hz) && std::isnan(figures.u_dampingRatio));
        }
    }

    void correlatedParts_asComputedIndependently()
    {
        // /usr/bin/python3 -c "import numpy as np; s=2*np.pi*3e4*(-.1+1j*np.sqrt(.99))
        // V=np.array([[90.,12],[12,40]]); f=lambda a,b: abs(a+1j*b)/2/np.pi
        // z=lambda a,b: -a/abs(a+1j*b); h=1.
        // for q in (f,z): g=np.array([(q(s.real+h,s.imag)-q(s.real-h,s.imag))/2/h,
        //  (q(s.real,s.imag+h)-q(s.real,s.imag-h))/2/h]); print(repr(np.sqrt(g@V@g)))"
        const PoleFigures figures = poleFigures(pairAndReal(), 0);
        QVERIFY(isNear(figures.u_frequency_Hz, 0.9825421118073057, 1e-8)); // central differences
        QVERIFY(isNear(figures.u_dampingRatio, 5.059945072352766e-05, 1e-8));
    }

    void fasterPole_scalesTheFrequencyAlone()
    {
        Eigen::Matrix2d covariance;
        covariance << 90.0, 12.0, 12.0, 40.0;
        const PoleFigures slow = pairFigures(poleOf(0.1), covariance);
        const PoleFigures fast = pairFigures(10.0 * poleOf(0.1), 100.0 * covariance);
        QVERIFY(isNear(fast.frequency_Hz, 10.0 * slow.frequency_Hz));
        QVERIFY(isNear(fast.u_frequency_Hz, 10.0 * slow.u_frequency_Hz));
        QVERIFY(isNear(fast.u_dampingRatio, slow.u_dampingRatio));
    }

    void lowerHalf_saysTheSame()
    {
        const PoleFigures upper = poleFigures(pairAndReal(), 0);
        const PoleFigures lower = poleFigures(pairAndReal(), 1);
        QCOMPARE(lower.frequency_Hz, upper.frequency_Hz);
        QCOMPARE(lower.u_frequency_Hz, upper.u_frequency_Hz);
        QCOMPARE(lower.dampingRatio, upper.dampingRatio);
        QCOMPARE(lower.u_dampingRatio, upper.u_dampingRatio);
    }

    void realPole_hasNoUncertaintyOfDamping()
    {
        const PoleFigures real = poleFigures(pairAndReal(), 2);
        QVERIFY(isNear(real.frequency_Hz, 4e4 / kTwoPi));
        QVERIFY(isNear(real.u_frequency_Hz, 50.0 / kTwoPi));
        QCOMPARE(real.dampingRatio, 1.0);
        QCOMPARE(real.u_dampingRatio, 0.0);
    }

    void coverageFactor_isStudents()
    {
        // 1 and 2 degrees of freedom have closed forms: tan(pi (p - 1/2)) and (2p - 1)/sqrt(2p(1 -
        // p)).
        QVERIFY(isNear(coverageFactor95(1.0), std::tan(M_PI * 0.475)));
        QVERIFY(isNear(coverageFactor95(2.0), 0.95 / std::sqrt(2.0 * 0.975 * 0.025)));
        // /usr/bin/python3 -c "from scipy.stats import t; print(t.ppf(.975, 2.5), t.ppf(.975, 10))"
        QVERIFY(isNear(coverageFactor95(2.5), 3.5746548420118773, 1e-9));
        QVERIFY(isNear(coverageFactor95(10.0), 2.2281388519649385, 1e-9));
        const double normal = coverageFactor95(std::numeric_limits<double>::infinity());
        QVERIFY(isNear(normal, 1.959963984540054));
        QVERIFY(coverageFactor95(1e6) > coverageFactor95(1e7));
    }
};

DYNCAL_TEST(TestPoleUncertainty)
#include "tst_pole_uncertainty.moc"

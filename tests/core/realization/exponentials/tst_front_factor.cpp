// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/constants.h"
#include "core/realization/exponentials/front.h"
#include "tests/support/ramp_response.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using Complex = std::complex<double>;

namespace {

constexpr double kF0_Hz = 400e3;
constexpr double kZeta = 0.3;
constexpr double kFront_s = 400e-9;

/// The response to a sharp step, as a sum.
ExponentialSum sharpStep()
{
    const double w = kTwoPi * kF0_Hz;
    const Complex s = w * Complex(-kZeta, std::sqrt(1.0 - kZeta * kZeta));
    const Complex c = std::conj(s) / (s - std::conj(s));
    ExponentialSum sharp{1.0, Eigen::VectorXcd(2), Eigen::VectorXcd(2)};
    sharp.poles_rad_s << s, std::conj(s);
    sharp.amplitudes << c, std::conj(c);
    return sharp;
}

} // namespace

class TestFrontFactor : public QObject
{
    Q_OBJECT

private slots:
    void factor_isSincOnTheFrequencyAxis_andOneWithoutAFront()
    {
        for (const double fT : {1e-6, 3e-4, 0.1, 0.5, 0.9}) {
            const Complex factor = frontFactor(1e-6, {0.0, kTwoPi * fT / 1e-6});
            QVERIFY(std::abs(factor - std::sin(M_PI * fT) / (M_PI * fT)) < 1e-12);
        }
        QCOMPARE(frontFactor(0.0, {-1e5, 2e6}), Complex(1.0));
        const Complex below = frontFactor(1.0, 1.9999e-3), above = frontFactor(1.0, 2.0001e-3);
        QVERIFY(std::abs(below - above) < 1e-9);
    }

    void behindTheFront_theSumIsTheRampsResponse()
    {
        const ExponentialSum sharp = sharpStep();
        ExponentialSum recorded = sharp;
        for (Index i = 0; i < 2; ++i)
            recorded.amplitudes[i] *= frontFactor(kFront_s, sharp.poles_rad_s[i]);
        for (double t_s = 0.5 * kFront_s; t_s < 5e-6; t_s += 37e-9)
            QVERIFY(
                std::abs(recorded.value(t_s) - testing::rampResponse(kF0_Hz, kZeta, kFront_s, t_s))
                < 1e-8);
        const ExponentialSum back = asIfSharp(recorded, kFront_s);
        QVERIFY((back.amplitudes - sharp.amplitudes).norm() < 1e-12);
        QCOMPARE(back.constant, 1.0);
    }

    void asIfSharp_ofASharpStep_changesNothing()
    {
        const ExponentialSum sharp = sharpStep();
        const ExponentialSum same = asIfSharp(sharp, 0.0);
        QVERIFY(same.amplitudes == sharp.amplitudes && same.poles_rad_s == sharp.poles_rad_s);
    }

    void realPoles_growByTheHyperbolicSine()
    {
        // First-order lag: the mean of e^(-t/tau) over the front.
        for (const double share : {0.01, 1.0, 5.0}) {
            const double rate = -2.0 * share / kFront_s;
            const Complex factor = frontFactor(kFront_s, rate);
            QVERIFY(std::abs(factor - std::sinh(share) / share) < 1e-12 * std::abs(factor));
            QCOMPARE(factor.imag(), 0.0);
        }
    }
};

DYNCAL_TEST(TestFrontFactor)
#include "tst_front_factor.moc"

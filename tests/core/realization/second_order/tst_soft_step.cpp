// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The response of a second-order sensor to an even rise, during it and behind it.

#include "core/realization/exponentials/front.h"
#include "core/realization/second_order/soft_step.h"
#include "tests/support/damped_shots.h"
#include "tests/support/ramp_response.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

using namespace dyncal;

namespace {

constexpr double kF0_Hz = 400e3;
constexpr double kOmega_rad_s = 2.0 * std::numbers::pi * kF0_Hz;

} // namespace

class TestSoftStep : public QObject
{
    Q_OBJECT

private slots:
    void sharp_isTheClosedForm()
    {
        for (const double zeta : {0.01, 0.7, 1.0, 1.5, 3.0})
            for (double t_s = -1e-6; t_s < 10e-6; t_s += 0.13e-6)
                QVERIFY(std::abs(softStep(kOmega_rad_s, zeta, 0.0, t_s)
                            - testing::dampedStep(kF0_Hz, zeta, t_s))
                    < 1e-7);
    }

    void front_isTheMeanOfTheSharpResponse()
    {
        for (const double zeta : {0.02, 0.7, 0.95})
            for (const double front_s : {20e-9, 400e-9, 3e-6})
                for (double t_s = -2e-6; t_s < 6e-6; t_s += 0.17e-6)
                    QVERIFY(std::abs(softStep(kOmega_rad_s, zeta, front_s, t_s)
                                - testing::rampResponse(kF0_Hz, zeta, front_s, t_s))
                        < 1e-7);
    }

    /// Behind it the ringing is that of a sharp step times F(s) (docs/method/front.md).
    void behindTheFront_isTheSharpResponseTimesItsFactor()
    {
        const double zeta = 0.3;
        const double front_s = 600e-9;
        const std::complex<double> s
            = kOmega_rad_s * std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta));
        const std::complex<double> c = std::conj(s) / (s - std::conj(s));
        for (double t_s = 0.5 * front_s; t_s < 8e-6; t_s += 0.1e-6) {
            const double expected
                = 1.0 + 2.0 * (c * frontFactor(front_s, s) * std::exp(s * t_s)).real();
            QVERIFY(std::abs(softStep(kOmega_rad_s, zeta, front_s, t_s) - expected) < 1e-10);
        }
    }

    void shortest_doesNotCancel()
    {
        for (const double front_s : {1e-15, 1e-12, 39e-12, 41e-12, 1e-9})
            QVERIFY(std::abs(softStep(kOmega_rad_s, 0.7, front_s, 1e-6)
                        - softStep(kOmega_rad_s, 0.7, 0.0, 1e-6))
                < 1e-6);
    }
};

DYNCAL_TEST(TestSoftStep)
#include "tst_soft_step.moc"

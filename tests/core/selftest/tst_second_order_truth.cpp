// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/second_order_truth.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr SecondOrderTruth kSensor{2.0, 0.3};
constexpr double kW0 = 2.0 * std::numbers::pi * kSensor.f0_Hz;

/// x = (y, y'), y'' = w0^2 (1 - y) - 2 zeta w0 y'.
Eigen::Vector2d slope(const Eigen::Vector2d &x)
{
    return {x[1], kW0 * kW0 * (1.0 - x[0]) - 2.0 * kSensor.zeta * kW0 * x[1]};
}

/// The step response by Runge and Kutta.
double integrated(double t_s)
{
    constexpr int kSteps = 2000;
    const double h = t_s / kSteps;
    Eigen::Vector2d x(0.0, 0.0);
    for (int i = 0; i < kSteps; ++i) {
        const Eigen::Vector2d a = slope(x), b = slope(x + 0.5 * h * a), c = slope(x + 0.5 * h * b),
                              d = slope(x + h * c);
        x += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return x[0];
}

} // namespace

class TestSecondOrderTruth : public QObject
{
    Q_OBJECT

private slots:
    void step_solvesItsDifferentialEquation()
    {
        QCOMPARE(kSensor.step(0.0), 0.0);
        QCOMPARE(kSensor.step(-1.0), 0.0);
        for (const double t_s : {0.01, 0.2, 0.9})
            QVERIFY(std::abs(kSensor.step(t_s) - integrated(t_s)) < 1e-9);
    }

    void response_isOneOverTheCharacteristicPolynomial()
    {
        for (const double f_Hz : {0.0, 0.5, 2.0, 7.0}) {
            const std::complex<double> jw(0.0, 2.0 * std::numbers::pi * f_Hz);
            const auto s = kSensor.pole_rad_s();
            const auto G = kW0 * kW0 / ((jw - s) * (jw - std::conj(s)));
            QVERIFY(std::abs(kSensor.response(f_Hz) - G) < 1e-12);
        }
    }

    void samples_lieWhereTheyAreSaidTo()
    {
        const Eigen::VectorXd y = kSensor.sampled(10.0, 20, -0.25);
        QCOMPARE(y.size(), Index(20));
        QCOMPARE(y[0], 0.0);
        QVERIFY(isNear(y[7], kSensor.step(0.675), 1e-14));
    }
};

DYNCAL_TEST(TestSecondOrderTruth)
#include "tst_second_order_truth.moc"

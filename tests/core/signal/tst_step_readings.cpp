// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/step_readings.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kPerPeriod = 2000.0; ///< samples: linear interpolation is good to 1e-6 of a period

/// Response of a sensor with `lead` samples of rest before the arrival.
Eigen::VectorXd response(double zeta, Index lead, Index length)
{
    const SecondOrder sensor{1.0, zeta};
    return Eigen::VectorXd::NullaryExpr(lead + length,
        [&](Index i) { return sensor.step(static_cast<double>(i - lead) / kPerPeriod); });
}

} // namespace

class TestStepReadings : public QObject
{
    Q_OBJECT

private slots:
    void secondOrder_matchesClosedForm_data();
    void secondOrder_matchesClosedForm();
    void lateStart_stillSeesTenPercent();
    void noise_hidesWhatItWouldDecide();
    void unsettledWindow_hasNoSettlingTime();
    void responseWithoutOvershoot_isZero();
    void incompleteRise_isEmpty();
    void tinyWindows_doNotCrash();
};

/// Oracle values: closed form of the second order step response (metrology of the method, 1.5),
/// times in units of 1/f0.
void TestStepReadings::secondOrder_matchesClosedForm_data()
{
    QTest::addColumn<double>("zeta");
    QTest::addColumn<double>("overshoot_percent");
    QTest::addColumn<double>("rise");
    QTest::addColumn<double>("settling");
    QTest::newRow("0.02") << 0.02 << 93.90896 << 0.164806 << 23.550619;
    QTest::newRow("0.05") << 0.05 << 85.44679 << 0.168749 << 9.531381;
    QTest::newRow("0.1") << 0.10 << 72.92476 << 0.175739 << 4.610377;
    QTest::newRow("0.2") << 0.20 << 52.66206 << 0.191532 << 2.187495;
    QTest::newRow("0.4") << 0.40 << 25.38267 << 0.232922 << 1.210975;
    QTest::newRow("0.5") << 0.50 << 16.30335 << 0.260628 << 0.841785;
    QTest::newRow("0.7") << 0.70 << 4.59879 << 0.338396 << 0.461521;
}

void TestStepReadings::secondOrder_matchesClosedForm()
{
    QFETCH(double, zeta);
    QFETCH(double, overshoot_percent);
    QFETCH(double, rise);
    QFETCH(double, settling);
    const auto length = static_cast<Index>(40 * kPerPeriod);
    const auto found = readStep(response(zeta, 100, length), 100, length, 0.0);
    QVERIFY(found.rise_samples && found.overshoot && found.settling_samples);
    QVERIFY(std::abs(*found.rise_samples / kPerPeriod - rise) < 2e-6);
    QVERIFY(std::abs(100.0 * *found.overshoot - overshoot_percent) < 2e-5);
    QVERIFY(std::abs(*found.settling_samples / kPerPeriod - settling) < 2e-6);
}

void TestStepReadings::lateStart_stillSeesTenPercent()
{
    const Eigen::VectorXd y = response(0.4, 100, 20000);
    const auto early = readStep(y, 100, 19000, 0.0);
    const auto late = readStep(y, 100 + 300, 18700, 0.0); // at 35 % already
    QVERIFY(y[400] > 0.3);
    QCOMPARE(*late.rise_samples, *early.rise_samples);
    QCOMPARE(*late.settling_samples + 300.0, *early.settling_samples);
}

void TestStepReadings::noise_hidesWhatItWouldDecide()
{
    const Eigen::VectorXd y = response(0.4, 100, 20000);
    QVERIFY(readStep(y, 100, 20000, 0.0125).settling_samples);
    const auto coarse = readStep(y, 100, 20000, 0.013);
    QVERIFY(coarse.rise_samples && !coarse.overshoot && !coarse.settling_samples);
    const auto nothing = readStep(y, 100, 20000, 0.11);
    QVERIFY(!nothing.rise_samples && !nothing.overshoot && !nothing.settling_samples);
    QVERIFY(!readStep(y, 100, 20000, std::nan("")).rise_samples);
}

void TestStepReadings::unsettledWindow_hasNoSettlingTime()
{
    const auto found = readStep(response(0.02, 10, 5000), 10, 5000, 0.0);
    QVERIFY(found.rise_samples && found.overshoot && !found.settling_samples);
}

void TestStepReadings::responseWithoutOvershoot_isZero()
{
    const Eigen::VectorXd y = Eigen::VectorXd::NullaryExpr(5000, [](Index i) {
        return i < 50 ? 0.0 : 1.0 - std::exp(-static_cast<double>(i - 50) / 100.0);
    });
    const auto found = readStep(y, 50, 4950, 0.0);
    QCOMPARE(*found.overshoot, 0.0);
    QVERIFY(std::abs(*found.rise_samples - 100.0 * std::log(9.0)) < 0.01);
    QVERIFY(std::abs(*found.settling_samples - 100.0 * std::log(20.0)) < 0.01);
}

void TestStepReadings::incompleteRise_isEmpty()
{
    const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(100, 0.0, 0.8);
    QVERIFY(!readStep(ramp, 10, 90, 0.0).rise_samples);
    const Eigen::VectorXd high = Eigen::VectorXd::Ones(100); // never below 10 %
    const auto found = readStep(high, 10, 90, 0.0);
    QVERIFY(!found.rise_samples && !found.settling_samples);
    QCOMPARE(*found.overshoot, 0.0);
}

void TestStepReadings::tinyWindows_doNotCrash()
{
    for (Index length = 0; length < 5; ++length)
        readStep(Eigen::VectorXd::LinSpaced(length, 0.0, 2.0), 0, length, 0.0);
}

DYNCAL_TEST(TestStepReadings)
#include "tst_step_readings.moc"

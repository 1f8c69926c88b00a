// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/onset_level.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

using namespace dyncal;

namespace {

using Complex = std::complex<double>;

constexpr double kLevel = 1.7;

/// Residues of G(s) P(s), where P = (1 - h)/s + h/(s - slow) is a step that relaxes and G a
/// second-order sensor of gain 1: each is the limit of (s - pole) G P at its pole.
ExponentialSum relaxingStep(double f0_Hz, double zeta, double h, double slow)
{
    const double w0 = 2.0 * std::numbers::pi * f0_Hz;
    const Complex root = w0 * std::sqrt(Complex(zeta * zeta - 1.0));
    const Complex upper = -zeta * w0 + root;
    const Complex lower = -zeta * w0 - root;
    const auto G = [&](Complex s) { return w0 * w0 / ((s - upper) * (s - lower)); };
    const auto P = [&](Complex s) { return (1.0 - h) / s + h / (s - slow); };
    ExponentialSum sum;
    sum.constant = kLevel * (1.0 - h);
    sum.poles_rad_s.resize(3);
    sum.amplitudes.resize(3);
    sum.poles_rad_s << slow, upper, lower;
    sum.amplitudes << h * G(slow), w0 * w0 / (upper - lower) * P(upper),
        w0 * w0 / (lower - upper) * P(lower);
    sum.amplitudes *= kLevel;
    return sum;
}

} // namespace

/// The level of the step itself, against closed forms.
class TestOnsetLevel : public QObject
{
    Q_OBJECT

private slots:
    void withoutSlowPart_itIsTheConstant();
    void relaxingStep_hasItsLevelAtTheOnset_data();
    void relaxingStep_hasItsLevelAtTheOnset();
    void twoSlowParts_bothBelongToTheStep();
    void nothing_isNoLevel();
};

void TestOnsetLevel::withoutSlowPart_itIsTheConstant()
{
    const ExponentialSum sum = relaxingStep(318e3, 0.02, 0.0, -2e3);
    const OnsetLevel level = onsetLevel(sum, {false, false, false});
    QCOMPARE(level.value, sum.constant);
    QVERIFY(level.slow.empty());
    QCOMPARE(level.sensor.value(0.0) * level.value, sum.value(0.0));
}

void TestOnsetLevel::relaxingStep_hasItsLevelAtTheOnset_data()
{
    QTest::addColumn<double>("zeta");
    QTest::addColumn<double>("h");
    QTest::addColumn<double>("slow");
    QTest::newRow("heat of 2 % and 0.5 ms") << 0.02 << 0.02 << -2e3;
    QTest::newRow("heat of 5 % and 0.1 ms, overdamped") << 3.0 << 0.05 << -1e4;
    QTest::newRow("as fast as may be, well damped") << 0.7 << 0.05 << -0.1 * 318e3 * 6.28;
    QTest::newRow("cooling that was measured as a rise") << 0.3 << -0.04 << -5e3;
    QTest::newRow("AC coupling of 5 ms") << 0.02 << 1.0 << -200.0;
    QTest::newRow("AC coupling, overdamped") << 3.0 << 1.0 << -1e4;
    QTest::newRow("a ramp that grows") << 0.1 << 0.03 << 300.0;
}

void TestOnsetLevel::relaxingStep_hasItsLevelAtTheOnset()
{
    QFETCH(double, zeta);
    QFETCH(double, h);
    QFETCH(double, slow);
    const ExponentialSum sum = relaxingStep(318e3, zeta, h, slow);
    const OnsetLevel level = onsetLevel(sum, {true, false, false});
    QVERIFY2(std::abs(level.value / kLevel - 1.0) < 1e-12,
        qPrintable(QString::number(level.value / kLevel - 1.0)));
    QCOMPARE(level.slow.size(), std::size_t(1));
    QVERIFY(std::abs(level.slow[0] - h * kLevel) < 1e-12);
    // The sensor alone: the same two poles, from 0 to 1, without a jump and without slope.
    const ExponentialSum alone = relaxingStep(318e3, zeta, 0.0, slow);
    for (Index k = 0; k < 2; ++k)
        QVERIFY(std::abs(level.sensor.amplitudes[k] - alone.amplitudes[k + 1] / kLevel) < 1e-11);
    QVERIFY(std::abs(level.sensor.value(0.0)) < 1e-11);
}

void TestOnsetLevel::twoSlowParts_bothBelongToTheStep()
{
    // First order sensor of 20 kHz before which stand 1 - 0.03 (1 - e^(-at)) - 0.02 (1 - e^(-bt)).
    const double w = 2.0 * std::numbers::pi * 20e3;
    const double a = -2e3;
    const double b = -7e3;
    const auto G = [&](double s) { return w / (s + w); };
    ExponentialSum sum;
    sum.constant = 0.95;
    sum.poles_rad_s.resize(3);
    sum.amplitudes.resize(3);
    sum.poles_rad_s << a, -w, b;
    sum.amplitudes << 0.03 * G(a), w * (0.95 / -w + 0.03 / (-w - a) + 0.02 / (-w - b)), 0.02 * G(b);
    const OnsetLevel level = onsetLevel(sum, {true, false, true});
    QVERIFY(std::abs(level.value - 1.0) < 1e-12);
    QVERIFY(std::abs(level.slow[0] - 0.03) < 1e-12 && std::abs(level.slow[1] - 0.02) < 1e-12);
}

void TestOnsetLevel::nothing_isNoLevel()
{
    ExponentialSum sum;
    sum.poles_rad_s = Eigen::VectorXcd::Constant(1, Complex(-1.0));
    sum.amplitudes = Eigen::VectorXcd::Zero(1);
    QCOMPARE(onsetLevel(sum, {true}).value, 0.0);
}

DYNCAL_TEST(TestOnsetLevel)
#include "tst_onset_level.moc"

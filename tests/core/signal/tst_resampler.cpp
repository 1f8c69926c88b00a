// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/resampler.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

using namespace dyncal;
using dyncal::testing::Gaussian;

namespace {

/// What resampler.h and docs/method/resampling.md state.
constexpr double kPassRipple_dB = 0.004;
constexpr double kPassEdge = 0.64; ///< of the new Nyquist frequency
constexpr double kStop_dB = -68.0, kStopEdge = 1.36;
constexpr double kDeepStop_dB = -70.0, kDeepStopEdge = 1.42;

constexpr double kRate_Hz = 10e6;

double gain_dB(const AntiAliasFilter &filter, double ofNewNyquist)
{
    const double w
        = std::numbers::pi * kRate_Hz / static_cast<double>(filter.factor) * ofNewNyquist;
    return 20.0 * std::log10(std::abs(filter.gain({0.0, w})));
}

} // namespace

class TestResampler : public QObject
{
    Q_OBJECT

private slots:
    void design_anyFactor_meetsStatedFigures_data();
    void design_anyFactor_meetsStatedFigures();
    void design_factorOne_passesEverything();
    void gain_onFrequencyAxis_isRealAndEven();
    void delayedGain_isTheGainTimesTheDelay_andFiniteBeyondIt();
    void decimate_sumOfExponentials_keepsPolesAndAppliesGain_data();
    void decimate_sumOfExponentials_keepsPolesAndAppliesGain();
    void decimate_linearRamp_staysExact();
    void decimate_firstOutput_isCentredOnFirst();
    void decimate_toneBeyondStopEdge_vanishes();
    void decimate_wholeRecord_usesEverySample();
    void reductionFactor_ratios_wholeWhereTheyAre();
};

void TestResampler::design_anyFactor_meetsStatedFigures_data()
{
    QTest::addColumn<int>("factor");
    for (const int factor : {2, 3, 4, 5, 10, 43, 100})
        QTest::addRow("%d", factor) << factor;
}

void TestResampler::design_anyFactor_meetsStatedFigures()
{
    QFETCH(int, factor);
    const AntiAliasFilter filter = designAntiAliasFilter(factor, kRate_Hz);
    QCOMPARE(filter.taps.size(), Index(12 * factor + 1));
    QCOMPARE(filter.halfLength(), Index(6 * factor));
    QCOMPARE(filter.span_s(), 12.0 * factor / kRate_Hz);
    QVERIFY(filter.taps == filter.taps.reverse());
    QVERIFY(std::abs(filter.taps.sum() - 1.0) < 1e-15);
    QVERIFY(std::abs(gain_dB(filter, 1.0) + 6.02) < 0.03);
    for (int i = 0; i <= 200 * factor; ++i) {
        const double f = i / 200.0;
        const double gain = gain_dB(filter, f);
        if (f <= kPassEdge)
            QVERIFY2(std::abs(gain) <= kPassRipple_dB, qPrintable(QString::number(f)));
        if (f >= kStopEdge)
            QVERIFY2(gain <= kStop_dB, qPrintable(QString::number(f)));
        if (f >= kDeepStopEdge)
            QVERIFY2(gain <= kDeepStop_dB, qPrintable(QString::number(f)));
    }
}

void TestResampler::design_factorOne_passesEverything()
{
    const AntiAliasFilter filter = designAntiAliasFilter(1, kRate_Hz);
    QCOMPARE(filter.taps.size(), Index(1));
    QCOMPARE(filter.span_s(), 0.0);
    QCOMPARE(filter.gain({-1e5, 1e7}), std::complex<double>(1.0));
    const Eigen::VectorXd x = Gaussian(1).vector(20, 1.0);
    QVERIFY(decimate(x, filter, 3, 10) == x.segment(3, 10));
    QCOMPARE(decimate(x, filter, 20, 0).size(), Index(0));
}

void TestResampler::gain_onFrequencyAxis_isRealAndEven()
{
    const AntiAliasFilter filter = designAntiAliasFilter(7, kRate_Hz);
    for (const double w : {0.0, 1e5, 2e6, 3e7}) {
        QCOMPARE(filter.gain({0.0, w}).imag(), 0.0);
        QCOMPARE(filter.gain({0.0, w}), filter.gain({0.0, -w}));
    }
    QVERIFY(std::abs(filter.gain(0.0) - 1.0) < 1e-15);
}

void TestResampler::delayedGain_isTheGainTimesTheDelay_andFiniteBeyondIt()
{
    const AntiAliasFilter filter = designAntiAliasFilter(10, kRate_Hz);
    const double half_s = 0.5 * filter.span_s();
    for (const std::complex<double> s :
        {std::complex<double>(0.0, 2e6), {-1e5, 1e7}, {-3e6, 0.0}}) {
        for (const double delay_s : {0.0, half_s, 3.0 * half_s}) {
            const std::complex<double> expected = filter.gain(s) * std::exp(s * delay_s);
            const double largest = std::exp(std::abs(s.real()) * half_s + s.real() * delay_s);
            QVERIFY(std::abs(filter.delayedGain(s, delay_s) - expected)
                <= 1e-13 * largest * filter.taps.cwiseAbs().sum());
        }
    }
    // A lag far faster than a sample: nothing of it is left, and that is no "inf times 0".
    const std::complex<double> lag(-1e4 * kRate_Hz, 0.0);
    QVERIFY(!std::isfinite((filter.gain(lag) * std::exp(lag * 3.0 * half_s)).real()));
    QCOMPARE(filter.delayedGain(lag, 3.0 * half_s), std::complex<double>(0.0));
}

void TestResampler::decimate_sumOfExponentials_keepsPolesAndAppliesGain_data()
{
    QTest::addColumn<int>("factor");
    QTest::addColumn<double>("f0_Hz");
    QTest::addColumn<double>("zeta");
    QTest::newRow("lightly damped") << 5 << 318e3 << 0.02;
    QTest::newRow("well damped") << 5 << 318e3 << 0.7;
    QTest::newRow("near the new Nyquist") << 10 << 480e3 << 0.05;
    QTest::newRow("far above it") << 10 << 2.3e6 << 0.01;
    QTest::newRow("large factor") << 100 << 6.8e3 << 0.1;
}

void TestResampler::decimate_sumOfExponentials_keepsPolesAndAppliesGain()
{
    QFETCH(int, factor);
    QFETCH(double, f0_Hz);
    QFETCH(double, zeta);
    constexpr double kExact = 1e-13; // defining property of a linear filter; rounding only
    constexpr double c0 = 0.8;
    const std::complex<double> c(-0.4, 0.3);
    const std::complex<double> s = 2.0 * std::numbers::pi * f0_Hz
        * std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta));
    const AntiAliasFilter filter = designAntiAliasFilter(factor, kRate_Hz);

    // time 0 in the middle of the filter's first position, so that the exponential is of order 1
    const Index first = filter.halfLength(), count = 50;
    const auto at = [&](double sample, std::complex<double> gain) {
        return c0 + 2.0 * (c * gain * std::exp(s * (sample / kRate_Hz))).real();
    };
    const Index size = first + (count - 1) * factor + filter.halfLength() + 1;
    const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(
        size, [&](Index i) { return at(static_cast<double>(i - first), 1.0); });
    const Eigen::VectorXd y = decimate(x, filter, first, count);
    const double largest = x.cwiseAbs().maxCoeff(); // e^(-st) grows backwards
    for (Index k = 0; k < count; ++k) {
        const double expected = at(static_cast<double>(k * factor), filter.gain(s));
        QVERIFY2(std::abs(y[k] - expected) <= kExact * largest,
            qPrintable(QString("%1: %2").arg(k).arg(y[k] - expected)));
    }
}

void TestResampler::decimate_linearRamp_staysExact()
{
    const AntiAliasFilter filter = designAntiAliasFilter(4, kRate_Hz);
    const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(200, 0.0, 199.0);
    const Eigen::VectorXd y = decimate(ramp, filter, 30, 20);
    for (Index k = 0; k < y.size(); ++k)
        QVERIFY(std::abs(y[k] - static_cast<double>(30 + 4 * k)) < 1e-11);
}

void TestResampler::decimate_firstOutput_isCentredOnFirst()
{
    const AntiAliasFilter filter = designAntiAliasFilter(3, kRate_Hz);
    Eigen::VectorXd impulse = Eigen::VectorXd::Zero(100);
    impulse[50] = 1.0;
    Index peak = -1;
    decimate(impulse, filter, 20, 20).maxCoeff(&peak);
    QCOMPARE(20 + 3 * peak, Index(50));
}

void TestResampler::decimate_toneBeyondStopEdge_vanishes()
{
    const AntiAliasFilter filter = designAntiAliasFilter(10, kRate_Hz);
    const double f_Hz = 1.5 * kRate_Hz / 20.0;
    const Eigen::VectorXd tone = Eigen::VectorXd::NullaryExpr(2000, [&](Index i) {
        return std::sin(2.0 * std::numbers::pi * f_Hz * static_cast<double>(i) / kRate_Hz);
    });
    const double left = decimate(tone, filter, 60, 180).cwiseAbs().maxCoeff();
    QVERIFY(left < std::pow(10.0, kDeepStop_dB / 20.0));
}

void TestResampler::decimate_wholeRecord_usesEverySample()
{
    const AntiAliasFilter filter = designAntiAliasFilter(2, kRate_Hz);
    const Eigen::VectorXd x = Gaussian(9).vector(12 + 2 * 9 + 1, 1.0);
    const Eigen::VectorXd y = decimate(x, filter, 12, 4); // 12 + 3*2 + 12 is the last sample
    for (Index k = 0; k < 4; ++k) {
        double expected = 0.0;
        for (Index j = 0; j < 25; ++j)
            expected += filter.taps[j] * x[2 * k + j];
        QVERIFY(std::abs(y[k] - expected) < 1e-14);
    }
}

void TestResampler::reductionFactor_ratios_wholeWhereTheyAre()
{
    constexpr double kInf = std::numeric_limits<double>::infinity();
    QCOMPARE(reductionFactor(100e6, 50e6), std::optional<double>(2.0));
    QCOMPARE(reductionFactor(100e6, 100e6), std::optional<double>(1.0));
    QCOMPARE(reductionFactor(1.0 / 1e-8, 1e6), std::optional<double>(100.0));
    QCOMPARE(reductionFactor(51200.0 * (1.0 + 1e-10), 5120.0), std::optional<double>(10.0));
    QCOMPARE(reductionFactor(100e6, 40e6), std::optional<double>(2.5));
    QVERIFY(!reductionFactor(50e6, 100e6));
    QVERIFY(reductionFactor(51200.0 * (1.0 + 1e-8), 5120.0) != std::optional<double>(10.0));
    QVERIFY(!reductionFactor(0.0, 0.0));
    QVERIFY(!reductionFactor(1e6, 0.0));
    QVERIFY(!reductionFactor(-2.0, -1.0));
    QVERIFY(!reductionFactor(kInf, 1.0));
    QVERIFY(!reductionFactor(std::nan(""), 1.0));
    QVERIFY(!reductionFactor(1e30, 1e-30));
}

DYNCAL_TEST(TestResampler)
#include "tst_resampler.moc"

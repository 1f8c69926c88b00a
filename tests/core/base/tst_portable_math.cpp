// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/portable_math.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kMostUlps = 2.0; ///< what the header promises

/// Distance from the exact value (80 bit arithmetic has eleven digits to spare) in units of the
/// last place of the double nearest to it.
double ulps(double actual, long double exact)
{
    const double nearest = static_cast<double>(exact);
    const double unit = std::nextafter(std::abs(nearest), std::numeric_limits<double>::infinity())
        - std::abs(nearest);
    return std::abs(static_cast<double>(
        (static_cast<long double>(actual) - exact) / static_cast<long double>(unit)));
}

} // namespace

class TestPortableMath : public QObject
{
    Q_OBJECT

private slots:
    void exp_wholeDomain_withinTwoUlps();
    void exp_edges_zeroInfinityNan();
    void exp_exactValues();
    void log_wholeDomain_withinTwoUlps();
    void log_nearOne_withinTwoUlps();
    void log_exactValues();
    void sineCosine_wholeDomain_withinOneUnit();
    void sineCosine_anyAngle_onUnitCircle();
    void sineCosine_quadrants();
};

void TestPortableMath::exp_wholeDomain_withinTwoUlps()
{
    double worst = 0.0;
    for (int i = 0; i <= 400000; ++i) {
        const double x = -707.9 + i * (1416.8 / 400000.0);
        worst = std::max(worst, ulps(portableExp(x), expl(static_cast<long double>(x))));
    }
    for (int i = 0; i <= 100000; ++i) {
        const double x = -1.0 + i * 2e-5;
        worst = std::max(worst, ulps(portableExp(x), expl(static_cast<long double>(x))));
    }
    QVERIFY2(worst <= kMostUlps, qPrintable(QString::number(worst)));
}

void TestPortableMath::exp_edges_zeroInfinityNan()
{
    QCOMPARE(portableExp(-708.5), 0.0);
    QCOMPARE(portableExp(-1e300), 0.0);
    QCOMPARE(portableExp(-std::numeric_limits<double>::infinity()), 0.0);
    QVERIFY(std::isinf(portableExp(710.0)));
    QVERIFY(std::isinf(portableExp(std::numeric_limits<double>::infinity())));
    QVERIFY(std::isnan(portableExp(std::nan(""))));
    QVERIFY(portableExp(-708.0) > 0.0);
    QVERIFY(std::isfinite(portableExp(709.0)));
}

void TestPortableMath::exp_exactValues()
{
    QCOMPARE(portableExp(0.0), 1.0);
    QVERIFY(ulps(portableExp(1.0), 2.718281828459045235360287L) <= 1.0);
    QVERIFY(ulps(portableExp(-1.0), 0.367879441171442321595524L) <= 1.0);
}

void TestPortableMath::log_wholeDomain_withinTwoUlps()
{
    double worst = 0.0;
    double x = 2.3e-308;
    while (x < 1e308) {
        worst = std::max(worst, ulps(portableLog(x), logl(static_cast<long double>(x))));
        x *= 1.00371;
    }
    QVERIFY2(worst <= kMostUlps, qPrintable(QString::number(worst)));
}

void TestPortableMath::log_nearOne_withinTwoUlps()
{
    double worst = 0.0;
    for (int i = 1; i <= 200000; ++i) {
        for (const double x : {1.0 + i * 5e-6, 1.0 - i * 4e-6, 1.0 + i * 1e-12})
            worst = std::max(worst, ulps(portableLog(x), logl(static_cast<long double>(x))));
    }
    QVERIFY2(worst <= kMostUlps, qPrintable(QString::number(worst)));
}

void TestPortableMath::log_exactValues()
{
    QCOMPARE(portableLog(1.0), 0.0);
    QVERIFY(ulps(portableLog(2.0), 0.693147180559945309417232L) <= 1.0);
    QVERIFY(ulps(portableLog(0.5), -0.693147180559945309417232L) <= 1.0);
    for (int k = -1000; k <= 1000; k += 7)
        QVERIFY(
            std::abs(portableExp(portableLog(std::ldexp(1.0, k)) / 8.0) / std::exp2(k / 8.0) - 1.0)
            < 5e-14); // an error of one unit of the logarithm's last place, times up to 87
}

void TestPortableMath::sineCosine_wholeDomain_withinOneUnit()
{
    constexpr double kUnit = 0x1p-52;
    double worst = 0.0;
    for (int i = 0; i < 600000; ++i) {
        const double x = (i % 2 == 0 ? 1.0 : -1.0) * (i < 300000 ? i * 1e-4 : i * (1e6 / 600000.0));
        const SineCosine value = portableSineCosine(x);
        const long double exact = static_cast<long double>(x);
        worst = std::max(worst, std::abs(static_cast<double>(value.sine - sinl(exact))));
        worst = std::max(worst, std::abs(static_cast<double>(value.cosine - cosl(exact))));
    }
    QVERIFY2(worst <= kUnit, qPrintable(QString::number(worst / kUnit)));
}

void TestPortableMath::sineCosine_anyAngle_onUnitCircle()
{
    for (double x = -1e6; x < 1e6; x += 37.123) {
        const SineCosine value = portableSineCosine(x);
        QVERIFY(std::abs(value.sine * value.sine + value.cosine * value.cosine - 1.0) < 1e-15);
    }
}

void TestPortableMath::sineCosine_quadrants()
{
    QCOMPARE(portableSineCosine(0.0).sine, 0.0);
    QCOMPARE(portableSineCosine(0.0).cosine, 1.0);
    const double quarter = std::acos(0.0);
    for (int k = -8; k <= 8; ++k) {
        const double expectedSine[] = {0.0, 1.0, 0.0, -1.0};
        const double expectedCosine[] = {1.0, 0.0, -1.0, 0.0};
        const std::size_t quadrant = static_cast<std::size_t>(k & 3);
        const SineCosine value = portableSineCosine(k * quarter);
        QVERIFY(std::abs(value.sine - expectedSine[quadrant]) < 2e-15);
        QVERIFY(std::abs(value.cosine - expectedCosine[quadrant]) < 2e-15);
    }
}

DYNCAL_TEST(TestPortableMath)
#include "tst_portable_math.moc"

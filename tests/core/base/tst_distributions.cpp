// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/distributions.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kRelative = 1e-12; // exp() of a difference of logarithms of order 10^3

void compareClose(double actual, double expected, double relative = kRelative)
{
    QVERIFY2(std::abs(actual - expected) <= relative * std::abs(expected),
        qPrintable(QString("%1 instead of %2").arg(actual, 0, 'g', 17).arg(expected, 0, 'g', 17)));
}

} // namespace

class TestDistributions : public QObject
{
    Q_OBJECT

private slots:
    void upperGamma_wholeNumbers_equalsPoissonSum();
    void upperGamma_halves_equalsErfcRecurrence();
    void upperGamma_limits_areExact();
    void chiSquare_tableValues();
    void normalQuantile_invertsErfc();
    void normalQuantile_tableValues();
    void studentQuantile_withoutDegreesOfFreedom_isUnknownAtOnce();
};

/// Q(n, x) = e^-x sum over k < n of x^k/k!: closed form.
void TestDistributions::upperGamma_wholeNumbers_equalsPoissonSum()
{
    for (const int n : {1, 2, 5, 10, 40, 150}) {
        for (const double ratio : {0.01, 0.3, 0.9, 1.0, 1.1, 2.0, 4.0}) {
            const double x = ratio * n;
            double sum = 0.0, term = std::exp(-x);
            for (int k = 0; k < n; ++k) {
                sum += term;
                term *= x / (k + 1);
            }
            compareClose(upperGammaRatio(n, x), sum);
        }
    }
}

/// Q(a + 1, x) = Q(a, x) + x^a e^-x / Gamma(a + 1), Q(1/2, x) = erfc(sqrt x).
void TestDistributions::upperGamma_halves_equalsErfcRecurrence()
{
    for (const double x : {0.01, 0.5, 1.0, 3.0, 10.0, 30.0}) {
        double expected = std::erfc(std::sqrt(x));
        for (double a = 0.5; a < 12.0; a += 1.0) {
            compareClose(upperGammaRatio(a, x), expected);
            expected += std::pow(x, a) * std::exp(-x) / std::tgamma(a + 1.0);
        }
    }
}

void TestDistributions::upperGamma_limits_areExact()
{
    QCOMPARE(upperGammaRatio(3.0, 0.0), 1.0);
    QCOMPARE(upperGammaRatio(3.0, std::numeric_limits<double>::infinity()), 0.0);
    QCOMPARE(upperGammaRatio(3.0, 1e4), 0.0);
    QVERIFY(
        std::abs(upperGammaRatio(1e6, 1e6) - 0.5) < 1e-3); // the median, 0.5 - 1/(3 sqrt(2 pi a))
}

void TestDistributions::chiSquare_tableValues()
{
    compareClose(chiSquareSurvival(2.0, 2.0), std::exp(-1.0));
    compareClose(chiSquareSurvival(3.841458820694124, 1.0), 0.05);
    compareClose(chiSquareSurvival(31.410432844230918, 20.0), 0.05);
    compareClose(chiSquareSurvival(37.56623478662507, 20.0), 0.01);
}

void TestDistributions::normalQuantile_invertsErfc()
{
    for (const double p : {1e-300, 1e-12, 1e-4, 0.1, 0.3, 0.4999})
        compareClose(0.5 * std::erfc(-normalQuantile(p) / std::sqrt(2.0)), p);
    QVERIFY(std::abs(normalQuantile(0.5)) < 1e-15);
}

void TestDistributions::normalQuantile_tableValues()
{
    compareClose(normalQuantile(0.975), 1.959963984540054, 1e-14);
    compareClose(normalQuantile(0.995), 2.5758293035489004, 1e-14);
    QCOMPARE(normalQuantile(0.025), -normalQuantile(0.975));
}

void TestDistributions::studentQuantile_withoutDegreesOfFreedom_isUnknownAtOnce()
{
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double dof : {0.0, -1.0, -infinite, std::numeric_limits<double>::quiet_NaN()})
        QVERIFY(std::isnan(dyncal::studentQuantile(0.975, dof)));
}

DYNCAL_TEST(TestDistributions)
#include "tst_distributions.moc"

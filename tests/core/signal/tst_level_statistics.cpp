// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/level_statistics.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;
using namespace dyncal::testing;

class TestLevelStatistics : public QObject
{
    Q_OBJECT

private slots:
    void fitLine_exactLine_isRecovered();
    void fitLine_fewSamples_isDefined();
    void fitLine_noise_givesUnbiasedSd();
    void withoutLine_isOrthogonalToLine();
    void median_oddEvenEmpty();
    void finiteOnly_keepsOrder();
    void robustNoiseSd_gaussian_isUnbiased();
    void robustNoiseSd_outliersAndDrift_hardlyMatter();
    void robustNoiseSd_mostlyEqualCodes_isNotZero();
    void robustNoiseSd_shortOrEmpty_isDefined();
    void isAtRest_followsTenthOfHeight();
    void countSize_linearAndCurved();
};

void TestLevelStatistics::fitLine_exactLine_isRecovered()
{
    const LineFit fit = fitLine(Eigen::VectorXd::LinSpaced(11, 3.0, 8.0));
    QCOMPARE(fit.mean, 5.5);
    QCOMPARE(fit.slope, 0.5);
    QVERIFY(fit.sd < 1e-15);
}

void TestLevelStatistics::fitLine_fewSamples_isDefined()
{
    QCOMPARE(fitLine(Eigen::VectorXd()).mean, 0.0);
    QCOMPARE(fitLine(Eigen::VectorXd::Constant(1, 4.0)).mean, 4.0);
    QCOMPARE(fitLine(Eigen::VectorXd::Constant(1, 4.0)).slope, 0.0);
    QCOMPARE(fitLine(Eigen::Vector2d(1.0, 3.0)).slope, 2.0);
    QCOMPARE(fitLine(Eigen::Vector2d(1.0, 3.0)).sd, 0.0);
    // residuals 1/6, -1/3, 1/6 with one degree of freedom
    QCOMPARE(fitLine(Eigen::Vector3d(0.0, 0.0, 0.5)).sd, std::sqrt(1.0 / 24.0));
}

void TestLevelStatistics::fitLine_noise_givesUnbiasedSd()
{
    double variance = 0.0;
    Gaussian noise(1);
    for (int i = 0; i < 2000; ++i)
        variance += std::pow(fitLine(noise.vector(10, 2.0)).sd, 2) / 2000.0;
    QVERIFY(std::abs(variance - 4.0) < 0.2); // sd of the mean of 2000: 0.045
}

void TestLevelStatistics::withoutLine_isOrthogonalToLine()
{
    const Eigen::VectorXd rest = withoutLine(Gaussian(2).vector(101, 1.0));
    QVERIFY(std::abs(rest.sum()) < 1e-12);
    QVERIFY(std::abs(rest.dot(Eigen::VectorXd::LinSpaced(101, -50.0, 50.0))) < 1e-10);
    QCOMPARE(withoutLine(Eigen::VectorXd()).size(), Index(0));
}

void TestLevelStatistics::median_oddEvenEmpty()
{
    QCOMPARE(median(Eigen::VectorXd()), 0.0);
    QCOMPARE(median(Eigen::Vector3d(9.0, -1.0, 4.0)), 4.0);
    QCOMPARE(median(Eigen::Vector4d(9.0, -1.0, 4.0, 5.0)), 4.5);
    QCOMPARE(median(Eigen::Vector2d(1.0, 2.0)), 1.5);
}

void TestLevelStatistics::finiteOnly_keepsOrder()
{
    constexpr double kInf = std::numeric_limits<double>::infinity();
    Eigen::VectorXd values(6);
    values << kInf, 1.0, std::nan(""), 2.0, -kInf, 3.0;
    QVERIFY(finiteOnly(values) == Eigen::VectorXd(Eigen::Vector3d(1.0, 2.0, 3.0)));
    QCOMPARE(finiteOnly(Eigen::VectorXd::Constant(3, kInf)).size(), Index(0));
}

void TestLevelStatistics::robustNoiseSd_gaussian_isUnbiased()
{
    const double sd = robustNoiseSd(Gaussian(3).vector(100'000, 0.7), 1000);
    QVERIFY(std::abs(sd / 0.7 - 1.0) < 0.015); // MAD of 1e5: 0.37 %, line per 1000: 0.1 %
}

void TestLevelStatistics::robustNoiseSd_outliersAndDrift_hardlyMatter()
{
    Eigen::VectorXd values = Gaussian(4).vector(20'000, 1.0);
    values += Eigen::VectorXd::LinSpaced(20'000, 0.0, 500.0);
    for (Index i = 0; i < values.size(); i += 100)
        values[i] += 50.0;
    // the ordinary deviation is 5.1; the lines move by 0.5, which is what remains
    QVERIFY(std::abs(robustNoiseSd(values, 500) - 1.0) < 0.2);
}

void TestLevelStatistics::robustNoiseSd_mostlyEqualCodes_isNotZero()
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero(1000);
    for (Index i = 0; i < values.size(); i += 5)
        values[i] = 1.0;
    const double sd = robustNoiseSd(values, 1000);
    QVERIFY(sd > 0.1 && sd < 0.5); // true deviation 0.4
    QCOMPARE(robustNoiseSd(Eigen::VectorXd::Zero(100), 10), 0.0);
}

void TestLevelStatistics::robustNoiseSd_shortOrEmpty_isDefined()
{
    QCOMPARE(robustNoiseSd(Eigen::VectorXd(), 100), 0.0);
    QCOMPARE(robustNoiseSd(Eigen::VectorXd::Ones(1), 100), 0.0);
    QVERIFY(std::isfinite(robustNoiseSd(Eigen::Vector3d(1.0, 5.0, 1.0), 1)));
}

void TestLevelStatistics::isAtRest_followsTenthOfHeight()
{
    const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(1000, 0.0, 1.0);
    QVERIFY(isAtRest(ramp, 10.0, 0.0));
    QVERIFY(isAtRest(ramp, -10.0, 0.0));
    QVERIFY(!isAtRest(ramp, 9.0, 0.0));
    QVERIFY(isAtRest(ramp, 9.0, 2.0)); // cannot be told apart for noise
    QVERIFY(isAtRest(Eigen::VectorXd(), 1.0, 0.0));
    QVERIFY(isAtRest(Gaussian(5).vector(1000, 1.0), 0.1, 1.0));
}

void TestLevelStatistics::countSize_linearAndCurved()
{
    Channel channel = countsChannel(Eigen::VectorXd::Zero(4), 1.0, 5.0, 14);
    QCOMPARE(countSize(channel, 100.0), 10.0 / 16384.0);
    channel.polarity = -1.0;
    channel.userScale = 2.0;
    QCOMPARE(countSize(channel, 100.0), 20.0 / 16384.0);
    channel.polynomial = {0.0, 1.0, 0.5};
    QCOMPARE(countSize(channel, 3.0), 2.0 * (4.5)); // (4 + 8) - (3 + 4.5) = 4.5
    QCOMPARE(countSize(doubleChannel(Eigen::VectorXd::Zero(4), 1.0), 1.0), 0.0);
}

DYNCAL_TEST(TestLevelStatistics)
#include "tst_level_statistics.moc"

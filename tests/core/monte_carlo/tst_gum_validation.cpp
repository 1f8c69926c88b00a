// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/gum_validation.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

DrawnQuantity interval(double low, double high)
{
    DrawnQuantity drawn;
    drawn.low = low;
    drawn.high = high;
    drawn.expanded = drawn.leastExpanded = drawn.mostExpanded = 0.5 * (high - low);
    return drawn;
}

} // namespace

class TestGumValidation : public QObject
{
    Q_OBJECT

private slots:
    /// u = 0.98 of one digit: its half is 0.05 (JCGM 101, 7.9.2, 8.1).
    void ends_areHeldAgainstHalfADigit()
    {
        const double U = 0.98 * coverageFactor(kInfinite, 0.95);
        const GumValidation inside
            = validateGum(3.0, 0.98, kInfinite, 0.95, interval(3.0 - U - 0.049, 3.0 + U));
        QVERIFY(isNear(inside.tolerance, 0.05));
        QVERIFY(isNear(inside.d_low, 0.049, 1e-6) && inside.d_high < 1e-12);
        QVERIFY(inside.validated);
        QVERIFY(
            !validateGum(3.0, 0.98, kInfinite, 0.95, interval(3.0 - U - 0.051, 3.0 + U)).validated);
        QVERIFY(
            !validateGum(3.0, 0.98, kInfinite, 0.95, interval(3.0 - U, 3.0 + U - 0.051)).validated);
    }

    void tolerance_followsTheDigitOfU_data()
    {
        QTest::addColumn<double>("u");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("1") << 1.0 << 0.5;
        QTest::newRow("9.9") << 9.9 << 0.5;
        QTest::newRow("10") << 10.0 << 5.0;
        QTest::newRow("0.035") << 0.035 << 0.005;
        QTest::newRow("2e-7") << 2e-7 << 5e-8;
    }
    void tolerance_followsTheDigitOfU()
    {
        QFETCH(double, u);
        QFETCH(double, tolerance);
        QVERIFY(isNear(validateGum(0.0, u, kInfinite, 0.95, interval(-u, u)).tolerance, tolerance));
    }

    void k_isStudentsOfTheCoverage()
    {
        const GumValidation gum = validateGum(0.0, 1.0, 2.0, 0.95, interval(-4.3, 4.3));
        QVERIFY(isNear(gum.k, 4.302653, 1e-6) && isNear(gum.expanded(), 4.302653, 1e-6));
        QVERIFY(
            isNear(validateGum(0.0, 1.0, kInfinite, 0.99, interval(-1.0, 1.0)).k, 2.575829, 1e-6));
    }

    void withoutTrialsOrU_isNotValidated()
    {
        QVERIFY(!validateGum(1.0, 0.1, kInfinite, 0.95, DrawnQuantity()).validated);
        QVERIFY(!validateGum(1.0, 0.0, kInfinite, 0.95, interval(1.0, 1.0)).validated);
        QCOMPARE(
            sizeOfGum(validateGum(1.0, 0.1, kInfinite, 0.95, DrawnQuantity()), DrawnQuantity()), 0);
    }

    /// A CMC makes U larger by decision; what is compared is what the budget says.
    void cmc_isLeftOut()
    {
        ReportedValue reported{
            "f0_hz", 1000.0, "Hz", {directLine("noise", 3.0), directLine("clock", 4.0)}};
        combineLines(reported);
        const double k = reported.k;
        reported.leastExpanded = 50.0;
        combineLines(reported);
        QVERIFY(*reported.u > 20.0);
        const GumValidation gum
            = validateGum(reported, 0.95, interval(1000.0 - 5.0 * k, 1000.0 + 5.0 * k));
        QVERIFY(isNear(gum.u, 5.0) && isNear(gum.k, k) && gum.validated);
    }

    void largestInput_isMoreThanHalfOfTheVariance()
    {
        const auto largest = [](double noise, double clock) {
            ReportedValue reported{"f0_hz", 1000.0, "Hz",
                {directLine("noise", noise), directLine("clock", -clock), directLine("gain", 1.0)}};
            combineLines(reported);
            return validateGum(reported, 0.95, interval(990.0, 1010.0)).largest;
        };
        QCOMPARE(largest(3.0, 4.0), std::string("clock"));
        QCOMPARE(largest(4.0, 3.0), std::string("noise"));
        QCOMPARE(largest(3.0, 3.0), std::string());
    }

    void size_isToldFromFivePercentOn()
    {
        const auto size = [](double drawn) {
            const double k = coverageFactor(kInfinite, 0.95);
            return sizeOfGum(validateGum(0.0, 1.0 / k, kInfinite, 0.95, interval(-drawn, drawn)),
                interval(-drawn, drawn));
        };
        QCOMPARE(size(1.0), 0);
        QCOMPARE(size(1.049), 0);
        QCOMPARE(size(1.051), -1);
        QCOMPARE(size(1.0 / 1.049), 0);
        QCOMPARE(size(1.0 / 1.051), 1);
    }
};

DYNCAL_TEST(TestGumValidation)
#include "tst_gum_validation.moc"

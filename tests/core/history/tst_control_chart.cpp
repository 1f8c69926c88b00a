// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/control_chart.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <Eigen/Dense>
#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Eigen::VectorXd column(std::initializer_list<double> values)
{
    return Eigen::Map<const Eigen::VectorXd>(values.begin(), std::ssize(values));
}

Eigen::VectorXd years(std::initializer_list<double> values)
{
    return column(values) * kDaysOfYear;
}

double standardDeviation(const Eigen::VectorXd &values)
{
    return std::sqrt(
        (values.array() - values.mean()).square().sum() / static_cast<double>(values.size() - 1));
}

} // namespace

/// Statistics of a series against closed forms, known truths and another way to compute them.
class TestControlChart : public QObject
{
    Q_OBJECT

private slots:
    void normalisedError_isTheDifferenceOverBothU();
    void normalisedError_turnsItsSignAndHasNoUnit();
    void normalisedError_needsBothU();
    void limits_areThoseOfTheClosedForm();
    void limits_haveTheFactorsOfTheStandard();
    void sigma_isThatOfNormalValues();
    void limits_needFive();
    void outlierAmongSix_isSeen();
    void drift_isNotTakenForScatter();
    void equalValues_areInside();
    void state_beginsBehindTheLimit();
    void straightLine_isFound();
    void uOfTheSlope_isThatOfTheClosedForm();
    void scatterBeyondU_widensIt();
    void badCalibration_countsLittle();
    void order_andOriginDoNotMatter();
    void slope_isThatOfTheNormalEquations();
    void slope_isCoveredByItsU();
    void drift_needsThreeOfDifferentDaysWithU();
};

void TestControlChart::normalisedError_isTheDifferenceOverBothU()
{
    QVERIFY(isNear(normalisedError(10.3, 0.3, 10.0, 0.4), 0.6, 1e-12));
    QVERIFY(isNear(normalisedError(9.0, 3.0, 14.0, 4.0), -1.0, 1e-12));
    QCOMPARE(normalisedError(7.0, 1.0, 7.0, 1.0), 0.0);
}

void TestControlChart::normalisedError_turnsItsSignAndHasNoUnit()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(0.1, 10.0);
    for (int i = 0; i < 200; ++i) {
        const double x = any(random), U = any(random), y = any(random), V = any(random);
        const double En = normalisedError(x, U, y, V);
        QCOMPARE(normalisedError(y, V, x, U), -En);
        QVERIFY(isNear(normalisedError(1e-6 * x, 1e-6 * U, 1e-6 * y, 1e-6 * V), En));
        QVERIFY(std::abs(En) < std::abs(x - y) / std::max(U, V));
    }
}

void TestControlChart::normalisedError_needsBothU()
{
    for (const double U : {0.0, -1.0, kUnknown, kInfinite}) {
        QVERIFY(std::isnan(normalisedError(1.0, U, 2.0, 1.0)));
        QVERIFY(std::isnan(normalisedError(1.0, 1.0, 2.0, U)));
    }
    QVERIFY(std::isnan(normalisedError(kUnknown, 1.0, 2.0, 1.0)));
    QVERIFY(std::isnan(normalisedError(1.0, 1.0, kInfinite, 1.0)));
}

void TestControlChart::limits_areThoseOfTheClosedForm()
{
    const auto limits = controlLimits(column({1.0, 2.0, 1.0, 2.0, 1.0})); // all ranges are 1
    QVERIFY(limits.has_value());
    const double sigma = std::sqrt(std::numbers::pi) / 2.0;
    QVERIFY(isNear(limits->mean, 1.4));
    QVERIFY(isNear(limits->sigma, sigma));
    QVERIFY(isNear(limits->warningLow(), 1.4 - 2.0 * sigma));
    QVERIFY(isNear(limits->warningHigh(), 1.4 + 2.0 * sigma));
    QVERIFY(isNear(limits->actionLow(), 1.4 - 3.0 * sigma));
    QVERIFY(isNear(limits->actionHigh(), 1.4 + 3.0 * sigma));
}

/// ISO 7870-2 prints 2,660 times the mean moving range, d2 of two being 1,128.
void TestControlChart::limits_haveTheFactorsOfTheStandard()
{
    const auto limits = controlLimits(column({0.0, 3.0, 1.0, 2.0, 0.0, 4.0})); // mean range 2.4
    QVERIFY(isNear(limits->sigma, 2.4 / 1.128, 5e-4));
    QVERIFY(isNear(limits->actionHigh() - limits->mean, 2.660 * 2.4, 5e-4));
}

void TestControlChart::sigma_isThatOfNormalValues()
{
    std::mt19937 random(11);
    std::normal_distribution<double> scatter(100.0, 2.0);
    Eigen::VectorXd values(20000);
    for (double &value : values)
        value = scatter(random);
    const auto limits = controlLimits(values);
    QVERIFY(isNear(limits->sigma, 2.0, 0.03));
    QVERIFY(isNear(limits->mean, 100.0, 1e-3));
}

void TestControlChart::limits_needFive()
{
    QVERIFY(!controlLimits(column({})));
    QVERIFY(!controlLimits(column({1.0, 2.0, 3.0, 4.0})));
    QVERIFY(controlLimits(column({1.0, 2.0, 3.0, 4.0, 5.0})));
    QVERIFY(!controlLimits(column({1.0, 2.0, kUnknown, 4.0, 5.0, 6.0})));
    QVERIFY(!controlLimits(column({1.0, 2.0, kInfinite, 4.0, 5.0, 6.0})));
}

/// With the standard deviation of all no value of six could ever be beyond (n - 1)/sqrt(n) = 2.04.
void TestControlChart::outlierAmongSix_isSeen()
{
    const Eigen::VectorXd values = column({10.0, 10.1, 9.9, 10.0, 10.1, 12.0});
    const auto limits = controlLimits(values);
    QCOMPARE(controlState(*limits, values[5]), ControlState::Action);
    for (Index i = 0; i < 5; ++i)
        QCOMPARE(controlState(*limits, values[i]), ControlState::Inside);
    QVERIFY((values[5] - values.mean()) / standardDeviation(values) < 2.05);
}

void TestControlChart::drift_isNotTakenForScatter()
{
    const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(10, 0.0, 9.0);
    const auto limits = controlLimits(values);
    QVERIFY(limits->sigma < 0.3 * standardDeviation(values));
    QCOMPARE(controlState(*limits, values[0]), ControlState::Action);
    QCOMPARE(controlState(*limits, values[9]), ControlState::Action);
    QCOMPARE(controlState(*limits, values[5]), ControlState::Inside);
}

void TestControlChart::equalValues_areInside()
{
    const double value = 0.1 + 0.2;
    const auto limits = controlLimits(Eigen::VectorXd::Constant(7, value));
    QCOMPARE(limits->sigma, 0.0);
    QCOMPARE(controlState(*limits, value), ControlState::Inside);
    QCOMPARE(controlState(*limits, 1.001 * value), ControlState::Action);
}

void TestControlChart::state_beginsBehindTheLimit()
{
    const ControlLimits limits{10.0, 1.0};
    QCOMPARE(controlState(limits, 12.0), ControlState::Inside);
    QCOMPARE(controlState(limits, 12.001), ControlState::Warning);
    QCOMPARE(controlState(limits, 7.999), ControlState::Warning);
    QCOMPARE(controlState(limits, 13.0), ControlState::Warning);
    QCOMPARE(controlState(limits, 13.001), ControlState::Action);
    QCOMPARE(controlState(limits, 6.9), ControlState::Action);
    QCOMPARE(controlStateName(ControlState::Inside), "inside");
    QCOMPARE(controlStateName(ControlState::Warning), "warning");
    QCOMPARE(controlStateName(ControlState::Action), "action");
}

void TestControlChart::straightLine_isFound()
{
    const Eigen::VectorXd day = years({0.0, 0.9, 2.2, 3.0});
    const Eigen::VectorXd value = (5.0 + 0.3 * day.array() / kDaysOfYear).matrix();
    const auto drift = yearlyDrift(day, value, column({0.1, 0.2, 0.05, 0.1}));
    QVERIFY(drift.has_value());
    QVERIFY(isNear(drift->perYear, 0.3));
    QVERIFY(drift->birge < 1e-9);
    QCOMPARE(drift->k, 2.0);
    QCOMPARE(drift->U(), 2.0 * drift->u);
    QCOMPARE(drift->count, Index(4));
}

/// Equal u at -1, 0 and 1 years: u/sqrt(2).
void TestControlChart::uOfTheSlope_isThatOfTheClosedForm()
{
    const auto drift
        = yearlyDrift(years({9.0, 10.0, 11.0}), column({1.0, 1.0, 1.0}), column({0.4, 0.4, 0.4}));
    QVERIFY(isNear(drift->u, 0.4 / std::sqrt(2.0)));
    QVERIFY(std::abs(drift->perYear) < 1e-15);
}

/// 0, 1, 0 leave -1/3, 2/3, -1/3: s^2 = 2/3 with one degree of freedom, u = sqrt(s^2/2).
void TestControlChart::scatterBeyondU_widensIt()
{
    for (const double u : {0.1, 0.01}) {
        const auto drift
            = yearlyDrift(years({0.0, 1.0, 2.0}), column({0.0, 1.0, 0.0}), column({u, u, u}));
        QVERIFY(std::abs(drift->perYear) < 1e-12);
        QVERIFY(isNear(drift->birge, std::sqrt(2.0 / 3.0) / u));
        QVERIFY(isNear(drift->u, std::sqrt(1.0 / 3.0)));
        QVERIFY(isNear(drift->k, 12.7062047364, 1e-9)); // Student, 1 degree of freedom
    }
}

void TestControlChart::badCalibration_countsLittle()
{
    const auto drift = yearlyDrift(
        years({0.0, 1.0, 2.0, 3.0}), column({1.0, 2.0, 50.0, 4.0}), column({0.1, 0.1, 1e6, 0.1}));
    QVERIFY(isNear(drift->perYear, 1.0, 1e-6));
    QVERIFY(isNear(drift->u, 0.1 / std::sqrt(42.0 / 9.0), 1e-6)); // of 0, 1 and 3 years
}

void TestControlChart::order_andOriginDoNotMatter()
{
    const auto drift = yearlyDrift(
        years({0.0, 1.0, 2.5, 3.0}), column({1.0, 1.4, 2.0, 2.1}), column({0.1, 0.2, 0.1, 0.3}));
    const auto turned = yearlyDrift(
        years({2.5, 0.0, 3.0, 1.0}), column({2.0, 1.0, 2.1, 1.4}), column({0.1, 0.1, 0.3, 0.2}));
    const auto moved = yearlyDrift(years({56.0, 57.0, 58.5, 59.0}),
        column({1e6 + 1.0, 1e6 + 1.4, 1e6 + 2.0, 1e6 + 2.1}), column({0.1, 0.2, 0.1, 0.3}));
    for (const auto &other : {turned, moved}) {
        QVERIFY(isNear(other->perYear, drift->perYear, 1e-8));
        QVERIFY(isNear(other->u, drift->u, 1e-8));
        QVERIFY(isNear(other->birge, drift->birge, 1e-6));
    }
}

void TestControlChart::slope_isThatOfTheNormalEquations()
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0.1, 3.0);
    for (int i = 0; i < 50; ++i) {
        const Index n = 3 + i % 8;
        Eigen::VectorXd t(n), x(n), u(n);
        for (Index j = 0; j < n; ++j) {
            t[j] = any(random);
            x[j] = any(random);
            u[j] = any(random);
        }
        Eigen::MatrixXd A(n, 2);
        A << Eigen::VectorXd::Ones(n), t;
        const Eigen::MatrixXd W = u.array().square().inverse().matrix().asDiagonal();
        const Eigen::MatrixXd covariance = (A.transpose() * W * A).inverse();
        const Eigen::VectorXd line = covariance * A.transpose() * W * x;
        const Eigen::VectorXd left = x - A * line;
        const double birge = std::sqrt(left.dot(W * left) / static_cast<double>(n - 2));
        const auto drift = yearlyDrift(t * kDaysOfYear, x, u);
        QVERIFY(isNear(drift->perYear, line[1], 1e-6));
        QVERIFY(isNear(drift->birge, birge, 1e-6));
        QVERIFY(isNear(drift->u, std::sqrt(covariance(1, 1)) * std::max(1.0, birge), 1e-6));
    }
}

/// Independent errors of the stated u: at least 95 % within U, and not much more of them all.
void TestControlChart::slope_isCoveredByItsU()
{
    std::mt19937 random(17);
    std::normal_distribution<double> normal;
    const Eigen::VectorXd day = years({0.0, 1.0, 2.1, 2.9, 4.0, 5.0});
    const Eigen::VectorXd u = column({0.1, 0.2, 0.1, 0.15, 0.1, 0.2});
    int within = 0;
    constexpr int kTrials = 4000;
    for (int i = 0; i < kTrials; ++i) {
        Eigen::VectorXd value = 0.2 * day / kDaysOfYear;
        for (Index j = 0; j < u.size(); ++j)
            value[j] += u[j] * normal(random);
        const auto drift = yearlyDrift(day, value, u);
        within += std::abs(drift->perYear - 0.2) <= drift->U() ? 1 : 0;
    }
    QVERIFY2(within > 0.95 * kTrials, std::to_string(within).c_str());
    QVERIFY2(within < kTrials, std::to_string(within).c_str());
}

void TestControlChart::drift_needsThreeOfDifferentDaysWithU()
{
    const Eigen::VectorXd day = years({0.0, 1.0, 2.0}), u = column({1.0, 1.0, 1.0}), x = u;
    QVERIFY(yearlyDrift(day, x, u));
    QVERIFY(!yearlyDrift(day.head(2), x.head(2), u.head(2)));
    QVERIFY(!yearlyDrift(years({1.0, 1.0, 1.0}), x, u));
    QVERIFY(yearlyDrift(years({1.0, 1.0, 2.0}), x, u));
    QVERIFY(!yearlyDrift(day, x, u.head(2)));
    QVERIFY(!yearlyDrift(day.head(2), x, u));
    for (const double odd : {0.0, -1.0, kUnknown, kInfinite})
        QVERIFY(!yearlyDrift(day, x, column({1.0, odd, 1.0})));
    QVERIFY(!yearlyDrift(day, column({1.0, kUnknown, 1.0}), u));
    QVERIFY(!yearlyDrift(column({0.0, kInfinite, 9.0}), x, u));
    QVERIFY(!yearlyDrift({}, {}, {}));
}

DYNCAL_TEST(TestControlChart)
#include "tst_control_chart.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/propagation.h"
#include "tests/support/common_covariance.h"
#include "tests/support/test_program.h"

#include "core/base/distributions.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;
using testing::commonCovariance;

namespace {

const double kInfinity = std::numeric_limits<double>::infinity();

Result<Eigen::VectorXd> sumAndProduct(const Eigen::VectorXd &x)
{
    return Eigen::Vector2d(x.sum(), x.prod());
}

UncertainInput input(const char *name, double value, double u,
    Distribution distribution = Distribution::Normal, double dof = kInfinity, bool common = false)
{
    return {name, value, u, distribution, dof, common};
}

MonteCarloSettings trials(Index count, std::uint64_t seed = 1)
{
    MonteCarloSettings settings;
    settings.trials = count;
    settings.seed = seed;
    return settings;
}

} // namespace

class TestPropagation : public QObject
{
    Q_OBJECT

private slots:
    void student_printedQuantiles_data();
    void student_printedQuantiles();
    void student_closedForms();
    void gum_sumAndProduct_closedForm();
    void gum_zeroUncertainty_contributesNothing();
    void gum_scaling_isLinear();
    void gum_welchSatterthwaite_closedForm();
    void gum_commonLines_makeCovariance();
    void monteCarlo_sumOfRectangulars_isTriangular();
    void monteCarlo_momentsOfEveryDistribution();
    void monteCarlo_drawsDependOnNameSeedAndShotOnly();
    void monteCarlo_commonInputs_sameInEveryShot();
    void monteCarlo_adaptive_stopsWhenStable();
    void monteCarlo_failingTrials_areSaid();
    void settings_nonsense_usage();
    void validation_linearYes_stronglyCurvedNo();
};

void TestPropagation::student_printedQuantiles_data()
{
    QTest::addColumn<double>("probability");
    QTest::addColumn<double>("dof");
    QTest::addColumn<double>("t");
    // GUM table G.2 and scipy.stats.t.ppf (last digits).
    QTest::addRow("1") << 0.975 << 1.0 << 12.706204736432095;
    QTest::addRow("2") << 0.975 << 2.0 << 4.302652729911275;
    QTest::addRow("2, 95.45") << 0.97725 << 2.0 << 4.526559459;
    QTest::addRow("3.5") << 0.975 << 3.5 << 2.936;
    QTest::addRow("10") << 0.975 << 10.0 << 2.2281388519649385;
    QTest::addRow("100") << 0.995 << 100.0 << 2.6258905214380173;
    QTest::addRow("normal") << 0.975 << kInfinity << 1.959963984540054;
}

void TestPropagation::student_printedQuantiles()
{
    QFETCH(double, probability);
    QFETCH(double, dof);
    QFETCH(double, t);
    const double kDigits = dof == 3.5 ? 1e-2 : 2e-5;
    QVERIFY2(std::abs(studentQuantile(probability, dof) / t - 1.0) < kDigits,
        qPrintable(QString::number(studentQuantile(probability, dof), 'g', 15)));
    QVERIFY(std::abs(
                studentSurvival(studentQuantile(probability, dof), dof) / (1.0 - probability) - 1.0)
        < 1e-10);
}

void TestPropagation::student_closedForms()
{
    for (const double t : {-30.0, -1.0, 0.0, 0.3, 1.0, 4.0, 100.0}) {
        const double cauchy = 0.5 - std::atan(t) / std::acos(-1.0);
        const double two = 0.5 - t / (2.0 * std::sqrt(2.0 + t * t));
        QVERIFY(std::abs(studentSurvival(t, 1.0) - cauchy) < 1e-13);
        QVERIFY(std::abs(studentSurvival(t, 2.0) - two) < 1e-13);
        QVERIFY(std::abs(studentSurvival(t, 1e9) - 0.5 * std::erfc(t / std::sqrt(2.0))) < 1e-9);
    }
    QCOMPARE(studentQuantile(0.25, 7.0), -studentQuantile(0.75, 7.0));
}

void TestPropagation::gum_sumAndProduct_closedForm()
{
    const auto budget = propagateGum({input("a", 3.0, 0.1), input("b", 4.0, 0.2)}, sumAndProduct);
    QVERIFY(budget.has_value());
    QCOMPARE(budget->value[0], 7.0);
    QCOMPARE(budget->value[1], 12.0);
    constexpr double kDifference = 1e-12; // both are linear in each input
    QVERIFY(std::abs(budget->u[0] - std::hypot(0.1, 0.2)) < kDifference);
    QVERIFY(std::abs(budget->u[1] - std::hypot(4.0 * 0.1, 3.0 * 0.2)) < kDifference);
    QVERIFY(std::abs(budget->lines[0].sensitivity[1] - 4.0) < kDifference);
    QVERIFY(std::abs(budget->sharePercent(0, 1) - 100.0 * 0.16 / 0.52) < 1e-9);
    QVERIFY(std::isinf(budget->dof[0]));
}

void TestPropagation::gum_zeroUncertainty_contributesNothing()
{
    const auto budget = propagateGum({input("a", 3.0, 0.0), input("b", 4.0, 0.0)}, sumAndProduct);
    QCOMPARE(budget->u[0], 0.0);
    QCOMPARE(budget->sharePercent(0, 0), 0.0);
    QVERIFY(std::isinf(budget->dof[1]));
}

void TestPropagation::gum_scaling_isLinear()
{
    const auto one = propagateGum({input("a", 3.0, 0.1), input("b", 4.0, 0.2)}, sumAndProduct);
    const auto ten = propagateGum({input("a", 3.0, 1.0), input("b", 4.0, 2.0)}, sumAndProduct);
    QVERIFY((ten->u - 10.0 * one->u).norm() < 1e-11);
}

void TestPropagation::gum_welchSatterthwaite_closedForm()
{
    const auto budget
        = propagateGum({input("a", 0.0, 3.0, Distribution::Normal, 2.0), input("b", 0.0, 4.0),
                           input("c", 0.0, 1.0, Distribution::Normal, 5.0)},
            [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
                return Eigen::VectorXd::Constant(1, x.sum()).eval();
            });
    const double expected = 26.0 * 26.0 / (81.0 / 2.0 + 1.0 / 5.0); // GUM G.2b
    QVERIFY(std::abs(budget->dof[0] / expected - 1.0) < 1e-10);
    // A single line keeps its own degrees of freedom: k = 12.7 for one.
    const auto single = propagateGum({input("a", 0.0, 1.0, Distribution::Normal, 1.0)},
        [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> { return x; });
    QVERIFY(std::abs(coverageFactor(single->dof[0], 0.95) - 12.706204736) < 1e-6);
}

void TestPropagation::gum_commonLines_makeCovariance()
{
    const auto shot = [](double own) {
        return propagateGum(
            {input("T1", 1.0, 0.1, Distribution::Normal, kInfinity, true), input("t", own, 0.2)},
            sumAndProduct)
            .value();
    };
    const GumBudget a = shot(2.0), b = shot(5.0);
    QVERIFY(std::abs(commonCovariance(a, b, 0) - 0.01) < 1e-12);
    QVERIFY(std::abs(commonCovariance(a, b, 1) - 2.0 * 5.0 * 0.01) < 1e-11);
}

void TestPropagation::monteCarlo_sumOfRectangulars_isTriangular()
{
    const double u = 1.0 / std::sqrt(3.0); // half width 1
    const auto result = propagateMonteCarlo({input("a", 0.0, u, Distribution::Rectangular),
                                                input("b", 0.0, u, Distribution::Rectangular)},
        sumAndProduct, trials(200000));
    // The sum is triangular on -2 .. 2: P(|S| > c) = (2 - c)^2/4 = 0.05.
    const double expected = 2.0 - std::sqrt(0.2);
    QVERIFY(std::abs(result->high[0] - expected) < 0.01); // 3 sigma of the quantile
    QVERIFY(std::abs(result->low[0] + expected) < 0.01);
    QVERIFY(std::abs(result->u[0] - std::sqrt(2.0 / 3.0)) < 0.005);
    QVERIFY(std::abs(result->mean[0]) < 0.008);
    QCOMPARE(result->trials, Index(200000));
}

void TestPropagation::monteCarlo_momentsOfEveryDistribution()
{
    const auto single = [](const UncertainInput &x) {
        return propagateMonteCarlo(
            {x}, [](const Eigen::VectorXd &v) -> Result<Eigen::VectorXd> { return v; },
            trials(100000))
            .value();
    };
    for (const Distribution distribution :
        {Distribution::Normal, Distribution::Rectangular, Distribution::Triangular}) {
        const MonteCarloResult result = single(input("x", 5.0, 0.5, distribution));
        QVERIFY(std::abs(result.mean[0] - 5.0) < 5.0 * 0.5 / std::sqrt(1e5));
        QVERIFY(std::abs(result.u[0] - 0.5) < 0.01);
    }
    const MonteCarloResult student = single(input("x", 0.0, 1.0, Distribution::Normal, 10.0));
    QVERIFY(std::abs(student.u[0] - std::sqrt(10.0 / 8.0)) < 0.02);
    QVERIFY(std::abs(student.high[0] - 2.2281) < 0.05);
}

void TestPropagation::monteCarlo_drawsDependOnNameSeedAndShotOnly()
{
    const auto first = [](const std::vector<UncertainInput> &inputs, std::uint64_t seed) {
        return propagateMonteCarlo(
            inputs,
            [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
                return Eigen::VectorXd::Constant(1, x[x.size() - 1]).eval();
            },
            trials(1000, seed))
            ->mean[0];
    };
    const double alone = first({input("a", 0.0, 1.0)}, 1);
    QCOMPARE(first({input("b", 0.0, 1.0), input("a", 0.0, 1.0)}, 1), alone);
    QVERIFY(first({input("a", 0.0, 1.0)}, 2) != alone);
    QVERIFY(first({input("b", 0.0, 1.0)}, 1) != alone);
    QCOMPARE(first({input("a", 0.0, 1.0)}, 1), alone);
}

void TestPropagation::monteCarlo_commonInputs_sameInEveryShot()
{
    const auto meanOf = [](Index shot, bool common) {
        MonteCarloSettings settings = trials(500);
        settings.shot = shot;
        return propagateMonteCarlo(
            {input("T1", 0.0, 1.0, Distribution::Normal, kInfinity, common)},
            [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> { return x; }, settings)
            ->mean[0];
    };
    QCOMPARE(meanOf(1, true), meanOf(2, true));
    QVERIFY(meanOf(1, false) != meanOf(2, false));
}

void TestPropagation::monteCarlo_adaptive_stopsWhenStable()
{
    const auto result = propagateMonteCarlo(
        {input("a", 100.0, 1.0)},
        [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> { return x; }, trials(0));
    QVERIFY(result->trials >= 20000);
    QVERIFY(result->trials <= 1000000);
    QVERIFY(std::abs(result->u[0] - 1.0) < 0.05);
    QVERIFY(std::abs(result->high[0] - 101.95996) < 0.05);
}

void TestPropagation::monteCarlo_failingTrials_areSaid()
{
    const auto result = propagateMonteCarlo(
        {input("a", 0.0, 1.0)},
        [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            if (x[0] > 2.0)
                return fail(ErrorKind::DataBlocked, Message{"too far", {}});
            return x;
        },
        trials(1000));
    QVERIFY(!result);
    const std::string text = english(result.error().message);
    QVERIFY2(text.find("of 1000 trials") != std::string::npos, text.c_str());
    QVERIFY2(text.find("too far") != std::string::npos, text.c_str());
}

void TestPropagation::settings_nonsense_usage()
{
    const auto kindOf = [](const MonteCarloSettings &settings) {
        return propagateMonteCarlo(
            {input("a", 0.0, 1.0), input("b", 0.0, 1.0)}, sumAndProduct, settings)
            .error()
            .kind;
    };
    QCOMPARE(kindOf(trials(99)), ErrorKind::Usage);
    QCOMPARE(kindOf(trials(-1)), ErrorKind::Usage);
    QCOMPARE(kindOf(trials(2000000)), ErrorKind::Usage);
    MonteCarloSettings bad = trials(1000);
    bad.coverage = 1.0;
    QCOMPARE(kindOf(bad), ErrorKind::Usage);
}

void TestPropagation::validation_linearYes_stronglyCurvedNo()
{
    const auto validated = [](double power) {
        const Measurement f = [power](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            return Eigen::VectorXd::Constant(1, std::pow(std::abs(x[0]), power)).eval();
        };
        const std::vector<UncertainInput> inputs{input("a", 1.0, 0.3)};
        return isValidated(
            *propagateGum(inputs, f), *propagateMonteCarlo(inputs, f, trials(100000)), 0, 0.95);
    };
    QVERIFY(validated(1.0));
    QVERIFY(!validated(6.0));
}

DYNCAL_TEST(TestPropagation)
#include "tst_propagation.moc"

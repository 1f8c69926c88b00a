// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What every budget must satisfy whatever the measurement is, and inputs that are none.

#include "core/base/propagation.h"
#include "tests/support/common_covariance.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace dyncal;
using testing::commonCovariance;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9; ///< central differences of a linear f over a tenth of u
const double kNan = std::nan("");

UncertainInput input(const std::string &name, double value, double u,
    Distribution distribution = Distribution::Normal, double dof = kInfinity)
{
    return {name, value, u, distribution, dof, false};
}

Result<Eigen::VectorXd> itself(const Eigen::VectorXd &x)
{
    return x;
}

/// x, x^2 and x^4 of the first input.
Result<Eigen::VectorXd> powers(const Eigen::VectorXd &x)
{
    return Eigen::Vector3d(x[0], x[0] * x[0], std::pow(x[0], 4));
}

MonteCarloSettings trials(Index count, Index shot = 0)
{
    MonteCarloSettings settings;
    settings.trials = count;
    settings.shot = shot;
    return settings;
}

/// The sentence and kind with which both ways of propagation refuse the inputs.
std::string refusal(const std::vector<UncertainInput> &inputs)
{
    const auto gum = propagateGum(inputs, itself);
    const auto monteCarlo = propagateMonteCarlo(inputs, itself, trials(100));
    if (gum || monteCarlo)
        return "(accepted)";
    if (gum.error().kind != ErrorKind::Usage || monteCarlo.error().kind != ErrorKind::Usage)
        return "(wrong kind)";
    const std::string sentence = english(gum.error().message);
    return sentence == english(monteCarlo.error().message) ? sentence : "(two sentences)";
}

} // namespace

class TestPropagationInputs : public QObject
{
    Q_OBJECT

private slots:
    void inputThatIsNone_isRefusedByName_data();
    void inputThatIsNone_isRefusedByName();
    void nameTwice_isRefused();
    void resultThatIsNoNumber_isNoResult_data();
    void resultThatIsNoNumber_isNoResult();
    void gum_ofALinearMap_isTheClosedForm();
    void gum_otherUnitsAndOrder_sameBudget();
    void gum_shares_addUpToHundred();
    void commonCovariance_isSymmetricAndThatOfTheDraws();
    void draws_haveTheMomentsOfTheirShape_data();
    void draws_haveTheMomentsOfTheirShape();
    void uShaped_coverageIsThatOfTheArcsine();
    void boundedShapes_stayInTheirBounds();
    void names_areThoseOfTheRecipe();
    void validation_atTheEdgeOfItsTolerance_data();
    void validation_atTheEdgeOfItsTolerance();
    void adaptive_makesWholeBatchesAndStops();
    void stop_isCancelled();
};

void TestPropagationInputs::inputThatIsNone_isRefusedByName_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("u");
    QTest::addColumn<double>("dof");
    QTest::addRow("value not a number") << kNan << 1.0 << kInfinity;
    QTest::addRow("value infinite") << kInfinity << 1.0 << kInfinity;
    QTest::addRow("u not a number") << 1.0 << kNan << kInfinity;
    QTest::addRow("u negative") << 1.0 << -1e-300 << kInfinity;
    QTest::addRow("u infinite") << 1.0 << kInfinity << kInfinity;
    QTest::addRow("no degrees of freedom") << 1.0 << 1.0 << 0.0;
    QTest::addRow("negative degrees") << 1.0 << 1.0 << -3.0;
    QTest::addRow("degrees not a number") << 1.0 << 1.0 << kNan;
}

void TestPropagationInputs::inputThatIsNone_isRefusedByName()
{
    QFETCH(double, value);
    QFETCH(double, u);
    QFETCH(double, dof);
    const std::string sentence
        = refusal({input("fine", 1.0, 1.0), input("t1_k", value, u, Distribution::Normal, dof)});
    QVERIFY2(sentence.starts_with("The quantity t1_k = "), sentence.c_str());
}

void TestPropagationInputs::nameTwice_isRefused()
{
    // The name is the random stream: two inputs of one name would be drawn as one.
    const std::string sentence = refusal({input("a", 1.0, 1.0), input("a", 2.0, 1.0)});
    QVERIFY2(sentence.starts_with("The quantity a is there twice"), sentence.c_str());
}

void TestPropagationInputs::resultThatIsNoNumber_isNoResult_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("gives");
    QTest::addRow("at the value") << -kInfinity << kNan;
    QTest::addRow("beside it") << 1.01 << kNan;
    QTest::addRow("infinite") << 1.01 << kInfinity;
    QTest::addRow("in few trials") << 3.0 << -kInfinity;
}

void TestPropagationInputs::resultThatIsNoNumber_isNoResult()
{
    QFETCH(double, from);
    QFETCH(double, gives);
    const Measurement f = [&](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
        return Eigen::VectorXd::Constant(1, x[0] > from ? gives : x[0]).eval();
    };
    const std::vector<UncertainInput> inputs{input("a", 1.0, 1.0)};
    const auto gum = propagateGum(inputs, f);
    QCOMPARE(gum.has_value(), from > 1.1); // the differences reach a tenth of u
    if (!gum)
        QCOMPARE(gum.error().kind, ErrorKind::DataBlocked);
    const auto monteCarlo = propagateMonteCarlo(inputs, f, trials(1000));
    QVERIFY(!monteCarlo);
    QCOMPARE(monteCarlo.error().kind, ErrorKind::DataBlocked);
    QVERIFY(english(monteCarlo.error().message).find("of 1000 trials") != std::string::npos);
}

/// y = A x: u^2 = (A o A) u^2, nu = u^4 / sum (A u)^4/nu.
void TestPropagationInputs::gum_ofALinearMap_isTheClosedForm()
{
    Eigen::MatrixXd A(3, 4);
    A << 1.0, -2.0, 0.0, 1e3, 0.5, 0.5, 0.5, 0.0, 0.0, 0.0, 7.0, -1e-3;
    const Eigen::Vector4d x(3.0, -1.0, 1e4, 2e-3), u(0.1, 0.2, 3.0, 1e-5), dof(5.0, 1e3, 2.5, 9.0);
    std::vector<UncertainInput> inputs;
    for (Index i = 0; i < 4; ++i)
        inputs.push_back(input(
            std::string("x").append(std::to_string(i)), x[i], u[i], Distribution::Normal, dof[i]));
    const auto budget = propagateGum(
        inputs, [&](const Eigen::VectorXd &v) -> Result<Eigen::VectorXd> { return A * v; });
    QVERIFY(budget.has_value());
    const Eigen::ArrayXXd parts = (A * u.asDiagonal()).array();
    for (Index r = 0; r < 3; ++r) {
        const double variance = parts.row(r).square().sum();
        QVERIFY(std::abs(budget->u[r] / std::sqrt(variance) - 1.0) < kRounding);
        const double degrees
            = variance * variance / (parts.row(r).pow(4) / dof.transpose().array()).sum();
        QVERIFY(std::abs(budget->dof[r] / degrees - 1.0) < 4.0 * kRounding);
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(std::abs(budget->lines[i].contribution[r] - parts(r, static_cast<Index>(i)))
                < kRounding * std::sqrt(variance) + 1e-9 * u[static_cast<Index>(i)]);
    }
}

void TestPropagationInputs::gum_otherUnitsAndOrder_sameBudget()
{
    // A product of powers: relative contributions do not know the units.
    const auto budgetOf = [](double unit, bool turned) {
        std::vector<UncertainInput> inputs{
            input("p", 101e3 * unit, 40.0 * unit, Distribution::Normal, 4.0),
            input("T", 294.0, 0.3)};
        if (turned)
            std::swap(inputs[0], inputs[1]);
        return propagateGum(inputs, [turned](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            return Eigen::VectorXd::Constant(1, x[turned ? 1 : 0] / std::sqrt(x[turned ? 0 : 1]))
                .eval();
        }).value();
    };
    const GumBudget pascals = budgetOf(1.0, false);
    for (const bool turned : {false, true}) {
        const GumBudget bars = budgetOf(1e-5, turned);
        QVERIFY(std::abs(bars.u[0] * 1e5 / pascals.u[0] - 1.0) < kRounding);
        QVERIFY(std::abs(bars.dof[0] / pascals.dof[0] - 1.0) < kRounding);
        for (std::size_t line = 0; line < 2; ++line)
            QVERIFY(std::abs(bars.sharePercent(turned ? 1 - line : line, 0)
                        - pascals.sharePercent(line, 0))
                < 100.0 * kRounding);
    }
    const double expected = std::hypot(40.0 / 101e3, 0.5 * 0.3 / 294.0) * pascals.value[0];
    QVERIFY(std::abs(pascals.u[0] / expected - 1.0) < 1e-7); // curvature over a tenth of u
}

void TestPropagationInputs::gum_shares_addUpToHundred()
{
    const auto budget = propagateGum(
        {input("a", 1.0, 0.1), input("b", 2.0, 0.0), input("c", 3.0, 0.7, Distribution::UShaped)},
        [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            return Eigen::Vector2d(x.prod(), 5.0);
        });
    double sum = 0.0;
    for (std::size_t line = 0; line < 3; ++line) {
        sum += budget->sharePercent(line, 0);
        QCOMPARE(budget->sharePercent(line, 1), 0.0); // a constant has no variance to share
    }
    QVERIFY(std::abs(sum - 100.0) < 1e-10);
    QCOMPARE(budget->sharePercent(1, 0), 0.0);
    QCOMPARE(budget->u[1], 0.0);
    QVERIFY(std::isinf(budget->dof[1]));
}

/// Two shots share T1 and have an arrival of their own: what the budgets say they share is what
/// the drawn results show.
void TestPropagationInputs::commonCovariance_isSymmetricAndThatOfTheDraws()
{
    constexpr Index kTrials = 40000;
    const auto inputsOf = [](double own) {
        UncertainInput common = input("t1_k", 294.0, 0.5);
        common.common = true;
        return std::vector<UncertainInput>{common, input("arrival_s", own, 0.4)};
    };
    const auto measurementOf = [](double factor, std::vector<double> &seen) -> Measurement {
        return [factor, &seen](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            const double y = factor * x[0] + x[1];
            seen.push_back(y);
            return Eigen::VectorXd::Constant(1, y).eval();
        };
    };
    std::vector<double> one, two;
    const Measurement first = measurementOf(2.0, one), second = measurementOf(-3.0, two);
    const GumBudget a = propagateGum(inputsOf(1.0), first).value();
    const GumBudget b = propagateGum(inputsOf(7.0), second).value();
    QVERIFY(std::abs(commonCovariance(a, b, 0) - 2.0 * -3.0 * 0.25) < kRounding);
    QCOMPARE(commonCovariance(b, a, 0), commonCovariance(a, b, 0));
    QVERIFY(std::abs(commonCovariance(a, a, 0) - 4.0 * 0.25) < kRounding);
    one.clear();
    two.clear();
    QVERIFY(propagateMonteCarlo(inputsOf(1.0), first, trials(kTrials, 1)).has_value());
    QVERIFY(propagateMonteCarlo(inputsOf(7.0), second, trials(kTrials, 2)).has_value());
    const Eigen::Map<const Eigen::ArrayXd> x(one.data(), kTrials), y(two.data(), kTrials);
    const double covariance = ((x - x.mean()) * (y - y.mean())).mean();
    const double spread = std::sqrt(
        (a.u[0] * a.u[0] * b.u[0] * b.u[0] + std::pow(commonCovariance(a, b, 0), 2)) / kTrials);
    QVERIFY2(std::abs(covariance - commonCovariance(a, b, 0)) < 4.0 * spread,
        qPrintable(QString::number(covariance)));
}

void TestPropagationInputs::draws_haveTheMomentsOfTheirShape_data()
{
    QTest::addColumn<int>("distribution");
    QTest::addColumn<double>("kurtosis"); // E x^4 / u^4
    QTest::addColumn<double>("eighth"); // E x^8 / u^8
    QTest::addRow("normal") << static_cast<int>(Distribution::Normal) << 3.0 << 105.0;
    QTest::addRow("rectangular") << static_cast<int>(Distribution::Rectangular) << 9.0 / 5.0 << 9.0;
    QTest::addRow("triangular") << static_cast<int>(Distribution::Triangular) << 12.0 / 5.0
                                << 144.0 / 5.0;
    QTest::addRow("u-shaped") << static_cast<int>(Distribution::UShaped) << 3.0 / 2.0 << 35.0 / 8.0;
}

void TestPropagationInputs::draws_haveTheMomentsOfTheirShape()
{
    QFETCH(int, distribution);
    QFETCH(double, kurtosis);
    QFETCH(double, eighth);
    constexpr Index kTrials = 100000;
    constexpr double u = 0.2, kSigmas = 5.0;
    const auto result = propagateMonteCarlo(
        {input("x", 0.0, u, static_cast<Distribution>(distribution))}, powers, trials(kTrials));
    const double root = std::sqrt(static_cast<double>(kTrials));
    QVERIFY(std::abs(result->mean[0]) < kSigmas * u / root);
    QVERIFY(std::abs(result->mean[1] / (u * u) - 1.0) < kSigmas * std::sqrt(kurtosis - 1.0) / root);
    QVERIFY(std::abs(result->mean[2] / std::pow(u, 4) - kurtosis)
        < kSigmas * std::sqrt(eighth - kurtosis * kurtosis) / root);
    // x -> -x changes no shape: the interval lies even.
    QVERIFY(std::abs(result->low[0] + result->high[0]) < 0.03 * u);
}

void TestPropagationInputs::uShaped_coverageIsThatOfTheArcsine()
{
    // P(|x| < a sin(pi q/2)) = q with a = sqrt(2) u.
    for (const double coverage : {0.5, 0.95}) {
        MonteCarloSettings settings = trials(100000);
        settings.coverage = coverage;
        const auto result
            = propagateMonteCarlo({input("x", 10.0, 1.0, Distribution::UShaped)}, itself, settings);
        const double half = std::sqrt(2.0) * std::sin(0.5 * std::numbers::pi * coverage);
        QVERIFY2(std::abs(result->high[0] - 10.0 - half) < 0.02,
            qPrintable(QString::number(result->high[0])));
        QVERIFY(std::abs(result->low[0] - 10.0 + half) < 0.02);
    }
}

void TestPropagationInputs::boundedShapes_stayInTheirBounds()
{
    const std::vector<std::pair<Distribution, double>> halfWidths{
        {Distribution::Rectangular, std::sqrt(3.0)}, {Distribution::Triangular, std::sqrt(6.0)},
        {Distribution::UShaped, std::sqrt(2.0)}};
    for (const auto &[distribution, half] : halfWidths) {
        double largest = 0.0;
        const auto result = propagateMonteCarlo(
            {input("x", 0.0, 1.0, distribution)},
            [&](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
                largest = std::max(largest, std::abs(x[0]));
                return x;
            },
            trials(50000));
        QVERIFY(result.has_value());
        QVERIFY(largest <= half * (1.0 + 1e-15));
        QVERIFY(largest > half * 0.99); // and fill them
    }
}

void TestPropagationInputs::names_areThoseOfTheRecipe()
{
    std::set<std::string> names;
    for (const Distribution distribution : {Distribution::Normal, Distribution::Rectangular,
             Distribution::Triangular, Distribution::UShaped})
        names.insert(distributionName(distribution));
    QCOMPARE(names, (std::set<std::string>{"normal", "rectangular", "triangular", "u-shaped"}));
}

void TestPropagationInputs::validation_atTheEdgeOfItsTolerance_data()
{
    QTest::addColumn<double>("u");
    QTest::addColumn<int>("digits");
    QTest::addColumn<double>("tolerance"); // JCGM 101, 7.9.2: half of the last digit of u
    QTest::addRow("0.35, one digit") << 0.35 << 1 << 0.05;
    QTest::addRow("0.35, two digits") << 0.35 << 2 << 0.005;
    QTest::addRow("1234, one digit") << 1234.0 << 1 << 500.0;
    QTest::addRow("9.9e-7, two digits") << 9.9e-7 << 2 << 5e-9;
    QTest::addRow("1, one digit") << 1.0 << 1 << 0.5;
}

void TestPropagationInputs::validation_atTheEdgeOfItsTolerance()
{
    QFETCH(double, u);
    QFETCH(int, digits);
    QFETCH(double, tolerance);
    const auto one = [](double value) { return Eigen::VectorXd::Constant(1, value).eval(); };
    const GumBudget gum{one(0.0), one(u), one(kInfinity), {}};
    const double half = coverageFactor(kInfinity, 0.95) * u;
    const auto agrees = [&](double low, double high) {
        return isValidated(
            gum, {1000, one(0.0), one(u), one(low - half), one(half + high)}, 0, 0.95, digits);
    };
    for (const double sign : {-1.0, 1.0}) {
        QVERIFY(agrees(0.999 * sign * tolerance, 0.0) && agrees(0.0, 0.999 * sign * tolerance));
        QVERIFY(!agrees(1.001 * sign * tolerance, 0.0) && !agrees(0.0, 1.001 * sign * tolerance));
        QVERIFY(!agrees(kNan, 0.0) && !agrees(0.0, kNan));
    }
}

void TestPropagationInputs::adaptive_makesWholeBatchesAndStops()
{
    // A Cauchy quotient never becomes stable: the limit must hold. A constant is stable at once.
    const auto wild = propagateMonteCarlo(
        {input("a", 0.0, 1.0), input("b", 0.0, 1.0)},
        [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            return Eigen::VectorXd::Constant(1, x[0] / x[1]).eval();
        },
        trials(0));
    QCOMPARE(wild->trials, Index(1000000));
    const auto constant = propagateMonteCarlo({input("a", 5.0, 0.0)}, itself, trials(0));
    QCOMPARE(constant->trials, Index(20000));
    QCOMPARE(constant->u[0], 0.0);
    QCOMPARE(constant->low[0], 5.0);
}

void TestPropagationInputs::stop_isCancelled()
{
    std::stop_source source;
    source.request_stop();
    for (const Index count : {Index(0), Index(100)}) {
        const auto result = propagateMonteCarlo(
            {input("a", 5.0, 1.0)}, itself, trials(count), {source.get_token(), {}});
        QVERIFY(!result && result.error().kind == ErrorKind::Cancelled);
    }
}

DYNCAL_TEST(TestPropagationInputs)
#include "tst_propagation_inputs.moc"

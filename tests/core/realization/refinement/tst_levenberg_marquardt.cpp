// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/levenberg_marquardt.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <Eigen/LU>

#include <array>
#include <functional>
#include <limits>

using namespace dyncal;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Equations of the least squares of `residual`, by central differences: no derivative of the test
/// is typed twice.
using Residual = std::function<Eigen::VectorXd(const Eigen::VectorXd &)>;

RegressionEquations equationsOf(const Residual &residual, const Eigen::VectorXd &theta)
{
    const Eigen::VectorXd r = residual(theta);
    Eigen::MatrixXd jacobian(r.size(), theta.size()); // of the model, so minus that of r
    for (Index i = 0; i < theta.size(); ++i) {
        const double step = 1e-6 * std::max(std::abs(theta[i]), 1e-6);
        Eigen::VectorXd above = theta, below = theta;
        above[i] += step;
        below[i] -= step;
        jacobian.col(i) = (residual(below) - residual(above)) / (2.0 * step);
    }
    return {jacobian.transpose() * jacobian, jacobian.transpose() * r, r.squaredNorm()};
}

const auto kAnywhere = [](const Eigen::VectorXd &) { return true; };

struct Descent
{
    Eigen::VectorXd theta;
    std::optional<RegressionEquations> equations;
    int evaluations = 0;
};

template <typename IsAllowed>
Descent descended(const Residual &residual, const Eigen::VectorXd &start,
    const IsAllowed &isAllowed, DescentLimits limits = {}, const JobControl &control = {})
{
    Descent result{start, {}, 0};
    result.equations = descend(
        result.theta, limits,
        [&](const Eigen::VectorXd &theta) {
            ++result.evaluations;
            return equationsOf(residual, theta);
        },
        isAllowed, control);
    return result;
}

Eigen::VectorXd rosenbrock(const Eigen::VectorXd &at)
{
    return Eigen::Vector2d(10.0 * (at[1] - at[0] * at[0]), 1.0 - at[0]);
}

constexpr DescentLimits kMany{200, 1e-4};

/// NIST StRD, Misra1a: y = b1 (1 - exp(-b2 x)).
constexpr std::array<double, 14> kMisraX{77.6, 114.9, 141.1, 190.8, 239.9, 289.0, 332.8, 378.4,
    434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
constexpr std::array<double, 14> kMisraY{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02, 44.82,
    50.76, 55.05, 61.01, 66.40, 75.47, 81.78};

Eigen::VectorXd misra(const Eigen::VectorXd &b)
{
    Eigen::VectorXd r(std::ssize(kMisraX));
    for (Index i = 0; i < r.size(); ++i)
        r[i] = kMisraY[static_cast<std::size_t>(i)]
            + b[0] * std::expm1(-b[1] * kMisraX[static_cast<std::size_t>(i)]);
    return r;
}

/// Distance to 5 in one parameter, off by 1 at best.
Eigen::VectorXd towardsFive(const Eigen::VectorXd &at)
{
    return Eigen::Vector2d(at[0] - 5.0, 1.0);
}

} // namespace

class TestLevenbergMarquardt : public QObject
{
    Q_OBJECT

private slots:
    void endOfTheCaller_equationsAreThoseOfThePlaceReached()
    {
        // The caller ends it where the cost (24.2 at first) is below 5; Rosenbrock's valley goes
        // on.
        Eigen::VectorXd theta = Eigen::Vector2d(-1.2, 1.0);
        const auto at = [](const Eigen::VectorXd &place) { return equationsOf(rosenbrock, place); };
        int asked = 0;
        const auto found = descend(theta, kMany, at, kAnywhere, {},
            [&](const Eigen::VectorXd &, const RegressionEquations &equations) {
                ++asked;
                return equations.cost < 5.0;
            });
        QVERIFY(found.has_value());
        QVERIFY(asked >= 2);
        QVERIFY(found->cost < 5.0);
        QVERIFY(found->cost > 1e-3);
        QCOMPARE(found->cost, rosenbrock(theta).squaredNorm());
    }

    void linearProblem_solutionOfTheNormalEquations()
    {
        // y = 2 + 3 t with errors +1, -1, -1, +1: the line through them is 2 + 3 t still.
        const Eigen::Vector4d t(0.0, 1.0, 2.0, 3.0);
        const Eigen::Vector4d y(3.0, 4.0, 7.0, 12.0);
        const Descent found = descended(
            [&](const Eigen::VectorXd &c) -> Eigen::VectorXd {
                return y - Eigen::VectorXd(c[0] + c[1] * t.array());
            },
            Eigen::Vector2d(-40.0, 700.0), kAnywhere);
        QVERIFY(found.equations.has_value());
        QVERIFY((found.theta - Eigen::Vector2d(2.0, 3.0)).norm() < 1e-6);
        QVERIFY(std::abs(found.equations->cost - 4.0) < 1e-10);
        QVERIFY(found.evaluations <= 8); // a few, as the damping falls
    }

    void rosenbrock_bottomOfTheValley()
    {
        for (const Eigen::Vector2d &start :
            {Eigen::Vector2d(-1.2, 1.0), Eigen::Vector2d(3.0, -4.0), Eigen::Vector2d(0.0, 10.0)}) {
            const Descent found = descended(rosenbrock, start, kAnywhere);
            QVERIFY(found.equations.has_value());
            QVERIFY((found.theta - Eigen::Vector2d::Ones()).norm() < 1e-6);
        }
    }

    void misra1a_certifiedValues_data()
    {
        QTest::addColumn<double>("b1");
        QTest::addColumn<double>("b2");
        QTest::newRow("far") << 500.0 << 1e-4;
        QTest::newRow("near") << 250.0 << 5e-4;
    }
    void misra1a_certifiedValues()
    {
        QFETCH(double, b1);
        QFETCH(double, b2);
        // The far start leads along a bent valley, in which every other step is refused.
        const Descent found = descended(misra, Eigen::Vector2d(b1, b2), kAnywhere, kMany);
        QVERIFY(found.equations.has_value());
        constexpr double kStop = 1e-6; // the cost is flat to 1e-12 there
        QVERIFY(std::abs(found.theta[0] / 2.3894212918e2 - 1.0) < kStop);
        QVERIFY(std::abs(found.theta[1] / 5.5015643181e-4 - 1.0) < kStop);
        QVERIFY(std::abs(found.equations->cost / 1.2455138894e-1 - 1.0) < 1e-9);
        // The equations handed back are those of the end: sd of b1 as certified.
        const Eigen::MatrixXd covariance
            = found.equations->matrix.inverse() * found.equations->cost / 12.0;
        QVERIFY(std::abs(std::sqrt(covariance(0, 0)) / 2.7070075241 - 1.0) < 1e-5);
        QVERIFY(std::abs(std::sqrt(covariance(1, 1)) / 7.2668688436e-6 - 1.0) < 1e-5);
    }

    void unitsOfTheParameters_changeNothing()
    {
        const Eigen::VectorXd unit = Eigen::Vector2d(1e-7, 1e5);
        const Eigen::VectorXd start = Eigen::Vector2d(500.0, 1e-4);
        const Descent plain = descended(misra, start, kAnywhere, kMany);
        const Descent scaled
            = descended([&](const Eigen::VectorXd &at) { return misra(at.cwiseProduct(unit)); },
                start.cwiseQuotient(unit), kAnywhere, kMany);
        QVERIFY(plain.equations && scaled.equations);
        const Eigen::VectorXd back = scaled.theta.cwiseProduct(unit);
        for (Index i = 0; i < back.size(); ++i)
            QVERIFY(std::abs(back[i] / plain.theta[i] - 1.0) < 1e-6);
    }

    void forbiddenSteps_areNeitherTakenNorLookedAt()
    {
        constexpr double kWall = 2.0;
        const auto isAllowed = [](const Eigen::VectorXd &at) { return at[0] <= kWall; };
        bool wentOver = false;
        const Descent found = descended(
            [&](const Eigen::VectorXd &at) {
                wentOver = wentOver || at[0] > kWall + 1e-5; // differences reach that far
                return towardsFive(at);
            },
            Eigen::VectorXd::Constant(1, 0.0), isAllowed);
        QVERIFY(found.equations.has_value());
        QVERIFY(!wentOver);
        QVERIFY(found.theta[0] > 1.5 && found.theta[0] <= kWall); // as near as damping brings it
        QVERIFY(std::abs(found.equations->cost - towardsFive(found.theta).squaredNorm()) < 1e-9);
    }

    void nothingAllowed_staysWhereItIs()
    {
        const Eigen::VectorXd start = Eigen::VectorXd::Constant(1, 0.5);
        const Descent found
            = descended(towardsFive, start, [](const Eigen::VectorXd &) { return false; });
        QVERIFY(found.equations.has_value());
        QCOMPARE(found.theta[0], 0.5);
        QCOMPARE(found.equations->cost, towardsFive(start).squaredNorm());
        QCOMPARE(found.evaluations, 1);
    }

    void regionWithoutValues_isStayedOutOf()
    {
        // ln x = 0 from x = 3: the full step, 3 - 3 ln 3, leads to where there is no logarithm.
        const Descent found = descended(
            [](const Eigen::VectorXd &x) -> Eigen::VectorXd {
                return Eigen::VectorXd::Constant(1, std::log(x[0]));
            },
            Eigen::VectorXd::Constant(1, 3.0), kAnywhere);
        QVERIFY(found.equations.has_value());
        QVERIFY(std::abs(found.theta[0] - 1.0) < 1e-6);
    }

    void startWithoutCost_isNoResult_data()
    {
        QTest::addColumn<double>("start");
        QTest::newRow("NaN") << kNaN;
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("too large to square") << 1e200;
    }
    void startWithoutCost_isNoResult()
    {
        QFETCH(double, start);
        const Descent found
            = descended(towardsFive, Eigen::VectorXd::Constant(1, start), kAnywhere);
        QVERIFY(!found.equations.has_value());
    }

    void exactStart_staysExact()
    {
        const Descent found = descended(rosenbrock, Eigen::Vector2d::Ones(), kAnywhere);
        QVERIFY(found.equations.has_value());
        QCOMPARE(found.equations->cost, 0.0);
        QCOMPARE(found.theta, Eigen::VectorXd(Eigen::Vector2d::Ones()));
    }

    void parameterWithoutInfluence_staysWhereItIs()
    {
        const Descent found = descended(towardsFive, Eigen::Vector2d(0.0, 17.0), kAnywhere);
        QVERIFY(found.equations.has_value());
        QVERIFY(std::abs(found.theta[0] - 5.0) < 1e-6);
        QCOMPARE(found.theta[1], 17.0);
    }

    void iterations_areTheMostThatAreDone()
    {
        const double before = rosenbrock(Eigen::Vector2d(-1.2, 1.0)).squaredNorm();
        for (const int most : {1, 2, 5}) {
            const Descent found = descended(
                rosenbrock, Eigen::Vector2d(-1.2, 1.0), kAnywhere, DescentLimits{most, 1e-4});
            QVERIFY(found.evaluations <= 1 + most);
            QVERIFY(found.equations->cost <= before);
            const double cost = rosenbrock(found.theta).squaredNorm();
            QVERIFY(std::abs(found.equations->cost - cost) < 1e-9);
        }
    }

    void distanceToGo_inStandardUncertainties()
    {
        // (theta - 5)/u, u = 1/4: 2 off are 8 uncertainties, whatever the unit of theta.
        for (const double unit : {1.0, 1e-9, 1e6}) {
            const auto residual = [&](const Eigen::VectorXd &at) -> Eigen::VectorXd {
                return Eigen::Vector2d(4.0 * (at[0] * unit - 5.0), 1.0);
            };
            const RegressionEquations off
                = equationsOf(residual, Eigen::VectorXd::Constant(1, 7.0 / unit));
            QVERIFY(std::abs(distanceToGo(off) / 8.0 - 1.0) < 1e-6);
        }
        // On the way it tells that the end is not reached, and there that it is.
        const auto early
            = descended(misra, Eigen::Vector2d(500.0, 1e-4), kAnywhere, DescentLimits{60, 1e-4});
        QVERIFY(distanceToGo(*early.equations) > 0.5);
        const auto late = descended(misra, Eigen::Vector2d(500.0, 1e-4), kAnywhere, kMany);
        QVERIFY(distanceToGo(*late.equations) < 1e-5);
    }

    void stopped_noResult()
    {
        std::stop_source source;
        int calls = 0;
        const Descent found = descended(
            [&](const Eigen::VectorXd &at) {
                if (++calls == 20) // some steps later
                    source.request_stop();
                return rosenbrock(at);
            },
            Eigen::Vector2d(-1.2, 1.0), kAnywhere, {}, {source.get_token(), {}});
        QVERIFY(!found.equations.has_value());
        QVERIFY(found.evaluations < 8);
    }
};

DYNCAL_TEST(TestLevenbergMarquardt)
#include "tst_levenberg_marquardt.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The lowest cost of a second-order sensor, how it rises with the damping ratio, and the intervals
// that come of it for records that begin where noise let a threshold be crossed.

#include "core/realization/refinement/draft_fit.h"
#include "core/realization/second_order/second_order_fit.h"
#include "core/realization/second_order/second_order_minimum.h"
#include "tests/support/damped_shots.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"

#include <Eigen/Cholesky>

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>

using namespace dyncal;

namespace {

constexpr double kF0_Hz = 318e3, kRate_Hz = 10e6;
constexpr double kUnit_s = 1.0 / (2.0 * std::numbers::pi * kF0_Hz);

/// One record of a damped step as the mean of all noises of a standard deviation leaves it, and
/// where its cost is lowest. It begins behind the onset, as records do.
struct Minimised
{
    std::vector<RefinementRecord> records;
    SecondOrderProblem problem;
    SecondOrderMinimum lowest;

    Minimised(double zeta, double noise)
        : records(recordsOf(zeta, noise))
        , problem(records, kUnit_s, 0.0, false)
    {
        lowest.theta = Eigen::Vector4d(0.0, std::log(zeta), 1.0, -1.5 / kRate_Hz / kUnit_s);
        lowest.equations = *minimise(problem, lowest.theta, {});
    }

    static std::vector<RefinementRecord> recordsOf(double zeta, double noise)
    {
        Eigen::VectorXd y(800);
        for (Index k = 0; k < y.size(); ++k)
            y[k] = testing::dampedStep(kF0_Hz, zeta, (static_cast<double>(k) + 1.5) / kRate_Hz);
        return {{y, kRate_Hz, 1.0 / noise}};
    }

    double u() const
    {
        return std::sqrt(
            lowest.equations.matrix.ldlt().solve(Eigen::VectorXd::Unit(4, kLogZeta))[kLogZeta]);
    }
    double riseFor(double increase, double start) const
    {
        return riseOfLogZeta(problem, lowest, increase, start, {});
    }
};

std::optional<SecondOrderFit> fitted(const ModelInput &input, double zeta)
{
    return fitSecondOrder(
        input, refinementRecords(input), {{kF0_Hz, zeta, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}}});
}

} // namespace

class TestSecondOrderMinimum : public QObject
{
    Q_OBJECT

private slots:
    void aFixedParameterStays_theOthersAreAtTheirLowest()
    {
        const Minimised free(1.5, 0.005);
        Eigen::VectorXd theta = free.lowest.theta;
        theta[kLogZeta] += 0.1;
        const auto held = minimise(free.problem, theta, {}, kLogZeta);
        QVERIFY(held.has_value());
        QCOMPARE(theta[kLogZeta], free.lowest.theta[kLogZeta] + 0.1);
        QVERIFY(held->cost > free.lowest.equations.cost);
        const RegressionEquations slopes = free.problem.normalEquations(theta);
        for (const Index i : {0, 2, 3})
            QVERIFY(std::abs(slopes.gradient[i]) < 1e-3 * std::sqrt(slopes.matrix(i, i)));
        QVERIFY(std::abs(slopes.gradient[kLogZeta]) > 1.0); // it is pulled back
    }

    /// What the word "rise" means, at three heights, from below and from above.
    void rise_isWhereTheCostIsHigherByTheIncrease()
    {
        const Minimised one(1.5, 0.01);
        for (const double increase : {1.0, 3.84, 6.6}) {
            for (const double start : {0.5, 2.0}) {
                const double rise = one.riseFor(increase, start * std::sqrt(increase) * one.u());
                Eigen::VectorXd theta = one.lowest.theta;
                theta[kLogZeta] += rise;
                const auto there = minimise(one.problem, theta, {}, kLogZeta);
                QVERIFY(there.has_value());
                const double found = there->cost - one.lowest.equations.cost;
                QVERIFY2(std::abs(found / increase - 1.0) < 0.03,
                    qPrintable(QString("%1 for %2").arg(found).arg(increase)));
            }
        }
    }

    void rise_isThatOfTheLaw_whereTheDampingIsKnownWell()
    {
        const Minimised well(1.2, 1e-4);
        const double linear = 1.96 * well.u();
        QVERIFY(std::abs(well.riseFor(1.96 * 1.96, linear) / linear - 1.0) < 0.02);
    }

    /// Of a second pole that noise nearly hides the damping ratio has hardly an upper limit.
    void rise_isFartherTheLessASecondPoleShows_andEndsAtTenTimes()
    {
        double before = 1.0;
        for (const double noise : {0.001, 0.0025, 0.005, 0.01, 0.02}) {
            const Minimised one(1.7, noise);
            const double linear = 1.96 * one.u();
            const double farther = one.riseFor(1.96 * 1.96, linear) / linear;
            QVERIFY2(farther > before, qPrintable(QString("%1").arg(farther)));
            before = farther;
        }
        const Minimised hidden(6.0, 0.05);
        QCOMPARE(hidden.riseFor(1.96 * 1.96, 0.5), std::numbers::ln10);
    }

    /// The first sample is what the start was found by: whatever it holds, the sensor is the same.
    void theSampleOfTheStart_hasNoSay()
    {
        ModelInput input = testing::dampedShots(kF0_Hz, 1.5, 4);
        const auto before = fitted(input, 1.5);
        for (ModelSeries &series : input.series)
            series.fullRate[0] += 0.02;
        const auto after = fitted(input, 1.5);
        QVERIFY(before && after);
        QCOMPARE(after->sensor.zeta, before->sensor.zeta);
        QCOMPARE(after->sensor.u_zeta, before->sensor.u_zeta);
        QCOMPARE(after->sensor.f0_Hz, before->sensor.f0_Hz);
    }

    /// Starts that noise helped to find: f0 and zeta without bias (the mean of n errors over u has
    /// a standard deviation of 1/sqrt(n); the second pole's skewness is left) and within U.
    void startsFoundByNoise_biasNothing()
    {
        constexpr double kZeta = 1.7;
        const int runs = trials::count(100, 1000);
        double mean = 0.0;
        std::array<int, 2> inside{};
        for (int seed = 1; seed <= runs; ++seed) {
            const auto fit
                = fitted(testing::shotsFromTheirCrossings(
                             {.f0_Hz = kF0_Hz, .zeta = kZeta}, static_cast<std::uint64_t>(seed)),
                    kZeta);
            QVERIFY(fit.has_value());
            const SecondOrderModel &sensor = fit->sensor;
            // The fast pole's time constant over the slow one's, in which the records are linear.
            const auto share = [](double zeta) {
                return std::pow(zeta + std::sqrt(std::max(0.0, zeta * zeta - 1.0)), -2.0);
            };
            mean += (share(sensor.zeta) - share(kZeta)) / share(kZeta) / runs;
            inside[0] += std::abs(sensor.f0_Hz - kF0_Hz) <= sensor.coverageFactor * sensor.u_f0_Hz;
            inside[1] += std::abs(sensor.zeta - kZeta) <= sensor.coverageFactor * sensor.u_zeta;
        }
        qInfo("of %d: mean error of the second pole %.1f %%, f0 %d, zeta %d", runs, 100.0 * mean,
            inside[0], inside[1]);
        for (const int count : inside)
            QVERIFY(count >= 0.91 * runs);
        QVERIFY(std::abs(mean) < 0.03);
    }
};

DYNCAL_TEST(TestSecondOrderMinimum)
#include "tst_second_order_minimum.moc"

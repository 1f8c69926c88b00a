// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Correlated inputs: against closed forms and against independent inputs that make the correlation.

#include "core/base/input_draws.h"
#include "core/base/propagation.h"
#include "core/base/uncertain_value.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::vector<VariancePart> pairOf(double a, double b, double r, double dof = kInfinite)
{
    return {{"a", a, dof, 0, {{"b", r}}}, {"b", b, dof, 0, {{"a", r}}}};
}

UncertaintyLine line(const char *quantity, double contribution, Correlations correlated = {})
{
    UncertaintyLine made = directLine(quantity, contribution);
    made.correlated = std::move(correlated);
    return made;
}

/// 3 x - 2 y and x y at (2, 5), with u of 0.1 and 0.2.
Result<Eigen::VectorXd> twoResults(const Eigen::VectorXd &x)
{
    Eigen::VectorXd y(2);
    y << 3.0 * x[0] - 2.0 * x[1], x[0] * x[1];
    return y;
}

std::vector<UncertainInput> twoInputs(double r, Distribution distribution = Distribution::Normal)
{
    return {{"x", 2.0, 0.1, distribution, kInfinite, false, {{"y", r}}},
        {"y", 5.0, 0.2, distribution, kInfinite, false, {{"x", r}}}};
}

} // namespace

class TestCorrelation : public QObject
{
    Q_OBJECT

private slots:
    /// (a + b)^2, (a - b)^2 and a^2 + b^2.
    void ends_areSumAndDifference()
    {
        QVERIFY(isNear(combinedParts(pairOf(3.0, 2.0, 1.0)).u, 5.0));
        QVERIFY(isNear(combinedParts(pairOf(3.0, 2.0, -1.0)).u, 1.0));
        QVERIFY(isNear(combinedParts(pairOf(3.0, -2.0, 1.0)).u, 1.0));
        QVERIFY(isNear(combinedParts(pairOf(3.0, 2.0, 0.0)).u, std::sqrt(13.0)));
        QCOMPARE(combinedParts(pairOf(2.0, 2.0, -1.0)).u, 0.0);
    }

    void shares_addUpAndMayBeNegative()
    {
        const auto parts = pairOf(3.0, -1.0, 0.8);
        const std::vector<double> shares = varianceShares(parts);
        QVERIFY(isNear(shares[0] + shares[1], std::pow(combinedParts(parts).u, 2)));
        QVERIFY(isNear(shares[0], 9.0 - 2.4));
        QVERIFY(isNear(shares[1], 1.0 - 2.4));
    }

    /// The same observations behind both: no more degrees of freedom than they have.
    void dof_ofOneCause_areItsOwn()
    {
        QVERIFY(isNear(combinedParts(pairOf(1.0, 1.0, 1.0, 4.0)).dof, 4.0));
        std::vector<VariancePart> parts = pairOf(1.0, 1.0, 1.0, 4.0);
        parts.push_back({"other", 2.0, 10.0, 0, {}});
        QVERIFY(isNear(combinedParts(parts).dof, 64.0 / (16.0 / 4.0 + 16.0 / 10.0)));
        parts[0].dof = 3.0; // the fewest of the two
        QVERIFY(isNear(combinedParts(parts).dof, 64.0 / (16.0 / 3.0 + 16.0 / 10.0)));
        QVERIFY(std::isinf(combinedParts(pairOf(1.0, 1.0, 0.5)).dof));
    }

    void otherShot_isIndependent()
    {
        std::vector<VariancePart> parts = pairOf(3.0, 2.0, 1.0);
        parts[0].shot = 1;
        QVERIFY(isNear(combinedParts(parts).u, 5.0)); // with what all shots share
        parts[1].shot = 2;
        QVERIFY(isNear(combinedParts(parts).u, std::sqrt(13.0)));
        parts[1].shot = 1;
        QVERIFY(isNear(combinedParts(parts).u, 5.0));
    }

    /// Stated at one of the two is enough; without any, the sum is the one of before, bit by bit.
    void lines_areCombinedAsTheirParts()
    {
        const auto plain = combined({line("a", 0.3), line("b", 0.1), line("c", 0.7)});
        QCOMPARE(plain.u, std::sqrt(0.3 * 0.3 + 0.1 * 0.1 + 0.7 * 0.7));
        const auto one = combined({line("a", 0.3, {{"b", 0.5}}), line("b", 0.1)});
        QVERIFY(isNear(one.u, std::sqrt(0.09 + 0.01 + 0.03)));
        QVERIFY(!areCorrelated({line("a", 1.0)}));
        QVERIFY(areCorrelated({line("a", 1.0, {{"b", 0.5}})}));
    }

    /// GUM 5.2.2 for 3 x - 2 y: 9 u_x^2 + 4 u_y^2 - 12 r u_x u_y.
    void budget_closedForm()
    {
        for (const double r : {-1.0, -0.3, 0.6, 1.0}) {
            const GumBudget budget = propagateGum(twoInputs(r), twoResults).value();
            QVERIFY(isNear(budget.u[0], std::sqrt(0.09 + 0.16 - 0.24 * r), 1e-9));
            QVERIFY(isNear(budget.u[1], std::sqrt(0.25 + 0.16 + 2.0 * r * 0.5 * 0.4), 1e-9));
            QVERIFY(isNear(budget.sharePercent(0, 0) + budget.sharePercent(1, 0), 100.0));
        }
    }

    /// x = x' + z, y = y' + z by one cause z is the same as r = u_z^2/(u_x u_y).
    void commonCause_isTheSameBudget()
    {
        const double u_z = 0.08;
        const std::vector<UncertainInput> causes{{"x'", 2.0, std::sqrt(0.01 - u_z * u_z)},
            {"y'", 5.0, std::sqrt(0.04 - u_z * u_z)}, {"z", 0.0, u_z}};
        const GumBudget byCause = propagateGum(causes, [](const Eigen::VectorXd &x) {
            return twoResults(Eigen::Vector2d(x[0] + x[2], x[1] + x[2]));
        }).value();
        const GumBudget byR = propagateGum(twoInputs(u_z * u_z / 0.02), twoResults).value();
        QVERIFY(isNear(byCause.u[0], byR.u[0], 1e-9));
        QVERIFY(isNear(byCause.u[1], byR.u[1], 1e-9));
    }

    void monteCarlo_agreesWithTheBudget()
    {
        MonteCarloSettings settings;
        settings.trials = 100000;
        for (const double r : {-0.9, 0.5, 1.0}) {
            const auto drawn = propagateMonteCarlo(twoInputs(r), twoResults, settings).value();
            const GumBudget budget = propagateGum(twoInputs(r), twoResults).value();
            QVERIFY(isNear(drawn.u[0], budget.u[0], 0.01)); // 4 sigma of 100 000
            QVERIFY(isNear(drawn.u[1], budget.u[1], 0.02));
        }
    }

    /// Each keeps its distribution; of rectangles r is 6/pi asin(r/2) (Pearson 1907).
    void rectangles_stayRectangles()
    {
        const double r = 0.8;
        const auto inputs = twoInputs(r, Distribution::Rectangular);
        const auto drawn = propagateMonteCarlo(inputs,
            [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
                const double a = (x[0] - 2.0) / 0.1, b = (x[1] - 5.0) / 0.2;
                Eigen::VectorXd y(3);
                y << a * a, std::max(std::abs(a), std::abs(b)), a * b;
                return y;
            },
            {})
                               .value();
        QVERIFY(isNear(drawn.mean[0], 1.0, 0.03)); // u^2
        QVERIFY(drawn.high[1] <= std::sqrt(3.0) && drawn.high[1] > 1.70);
        QVERIFY(std::abs(drawn.mean[2] - 6.0 / std::numbers::pi * std::asin(r / 2.0)) < 0.03);
    }

    void others_keepTheirDraws()
    {
        const std::vector<UncertainInput> alone{{"z", 1.0, 0.5}};
        std::vector<UncertainInput> all = twoInputs(0.7);
        all.push_back(alone.front());
        const auto last = [](const Eigen::VectorXd &x) -> Result<Eigen::VectorXd> {
            return Eigen::VectorXd(x.tail(1));
        };
        const auto a = propagateMonteCarlo(alone, last, {}).value();
        const auto b = propagateMonteCarlo(all, last, {}).value();
        QCOMPARE(a.mean[0], b.mean[0]);
        QCOMPARE(a.u[0], b.u[0]);
    }
};

DYNCAL_TEST(TestCorrelation)
#include "tst_correlation.moc"

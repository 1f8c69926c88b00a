// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/distributions.h"
#include "core/monte_carlo/source_draws.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr Index kTrials = 20000;

UncertainInput common(const char *name, double u = 1.0)
{
    UncertainInput input{name, 0.0, u};
    input.common = true;
    return input;
}

double correlation(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
{
    const Eigen::ArrayXd x = a.array() - a.mean(), y = b.array() - b.mean();
    return (x * y).sum() / std::sqrt(x.square().sum() * y.square().sum());
}

/// Largest distance between the distribution of the values and P(X <= x), times root n.
template <typename Cumulative>
double kolmogorov(std::vector<double> values, const Cumulative &cumulative)
{
    std::ranges::sort(values);
    const auto n = static_cast<double>(values.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double p = cumulative(values[i]);
        worst = std::max({worst, std::abs(p - static_cast<double>(i) / n),
            std::abs(p - static_cast<double>(i + 1) / n)});
    }
    return worst * std::sqrt(n);
}

} // namespace

class TestSourceDraws : public QObject
{
    Q_OBJECT

private slots:
    /// A source has the same numbers whatever else is drawn, in whatever order.
    void source_doesNotDependOnTheOthers()
    {
        SourceDraws alone, last;
        alone.add(common("t1_k"));
        last.add(common("p1_pa"));
        last.add({"arrival_s[A]", 0.0, 1.0}, 2);
        const Index at = last.add(common("t1_k"));
        for (const Index trial : {0, 1, 77, 123456})
            QCOMPARE(last.probabilities(5, trial)[at], alone.probabilities(5, trial)[0]);
    }

    void seedAndTrial_makeOtherNumbers()
    {
        SourceDraws sources;
        sources.add(common("t1_k"));
        const double p = sources.probabilities(1, 0)[0];
        QVERIFY(p > 0.0 && p < 1.0);
        QVERIFY(sources.probabilities(2, 0)[0] != p);
        QVERIFY(sources.probabilities(1, 1)[0] != p);
    }

    void commonSource_isOneForAllShots_ownOnesAreNot()
    {
        SourceDraws sources;
        const Index first = sources.add(common("t1_k"), 1);
        QCOMPARE(sources.add(common("t1_k", 2.0), 2), first);
        const Index own = sources.add({"arrival_s[A]", 0.0, 1.0}, 1);
        QVERIFY(sources.add({"arrival_s[A]", 0.0, 1.0}, 2) != own);
        QCOMPARE(sources.size(), Index(3));
    }

    void inputs_followTheirOwnDistribution()
    {
        UncertainInput wide{"x", 5.0, 2.0, Distribution::Rectangular};
        const DrawnInput input{wide, 0};
        QVERIFY(isNear(input.value(Eigen::VectorXd::Constant(1, 0.5)), 5.0));
        QVERIFY(isNear(input.value(Eigen::VectorXd::Constant(1, 1.0 - 1e-12)),
            5.0 + 2.0 * std::sqrt(3.0), 1e-9));
        wide.u = 0.0;
        QCOMPARE(DrawnInput({wide, 0}).value(Eigen::VectorXd::Constant(1, 0.9)), 5.0);
    }

    void correlatedSources_areJoined()
    {
        UncertainInput a = common("p1_pa"), b = common("t1_k");
        a.correlated = {{"t1_k", 0.7}};
        b.correlated = {{"p1_pa", 0.7}};
        SourceDraws sources;
        const DrawnInput x{a, sources.add(a)}, y{b, sources.add(b)};
        Eigen::VectorXd first(kTrials), second(kTrials);
        for (Index i = 0; i < kTrials; ++i) {
            const Eigen::VectorXd p = sources.probabilities(3, i);
            first[i] = x.value(p);
            second[i] = y.value(p);
        }
        QVERIFY(std::abs(correlation(first, second) - 0.7) < 0.02);
        QVERIFY(isNear(std::sqrt(second.squaredNorm() / kTrials), 1.0, 0.02));
    }

    void sources_areIndependentFromTrialToTrial()
    {
        SourceDraws sources;
        sources.add(common("t1_k"));
        sources.add(common("p1_pa"));
        Eigen::VectorXd a(kTrials), b(kTrials), next(kTrials);
        for (Index i = 0; i < kTrials; ++i) {
            const Eigen::VectorXd p = sources.probabilities(1, i);
            a[i] = p[0];
            b[i] = p[1];
            next[i] = sources.probabilities(1, i + 1)[0];
        }
        QVERIFY(std::abs(correlation(a, b)) < 4.0 / std::sqrt(kTrials));
        QVERIFY(std::abs(correlation(a, next)) < 4.0 / std::sqrt(kTrials));
        std::vector<double> values(a.begin(), a.end());
        QVERIFY(kolmogorov(values, [](double p) { return p; }) < 1.95); // 0.1 %
    }

    void variance_isChiSquare_data()
    {
        QTest::addColumn<double>("dof");
        for (const double dof : {1.0, 2.0, 4.5, 30.0, 12000.0})
            QTest::addRow("%g", dof) << dof;
    }
    void variance_isChiSquare()
    {
        QFETCH(double, dof);
        std::vector<double> values;
        for (Index i = 0; i < kTrials; ++i) {
            RandomStream stream(1, i, 7);
            values.push_back(drawnVariance(stream, dof));
        }
        const double distance
            = kolmogorov(values, [&](double v) { return 1.0 - chiSquareSurvival(v * dof, dof); });
        QVERIFY2(distance < 1.95, qPrintable(QString::number(distance)));
    }

    void variance_isExactWithoutAnEstimate()
    {
        RandomStream stream(1, 1, 1);
        QCOMPARE(drawnVariance(stream, std::numeric_limits<double>::infinity()), 1.0);
        QCOMPARE(drawnVariance(stream, 0.0), 1.0);
        QCOMPARE(drawnVariance(stream, std::nan("")), 1.0);
    }
};

DYNCAL_TEST(TestSourceDraws)
#include "tst_source_draws.moc"

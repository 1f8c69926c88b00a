// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Correlations that the recipe states, through the whole calibration.

#include "core/pipeline/pipeline.h"
#include "core/uncertainty/wanted_u.h"
#include "tests/support/budget_lines.h"
#include "tests/support/near.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using testing::isNear;
using testing::lineOf;

namespace {

Recipe stated(std::vector<CorrelationEntry> correlations)
{
    Recipe recipe;
    recipe.uncertainty.budget = {{"p1_pa", 400.0}, {"t1_k", 1.5}, {"gain_relative", 0.004}};
    recipe.uncertainty.correlations = std::move(correlations);
    return recipe;
}

} // namespace

class TestCorrelatedBudget : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;

    CalibrationResults run(const Recipe &recipe, StageId last = StageId::Uncertainty) const
    {
        ResultCache cache;
        return runPipeline(m_set, recipe, cache, last).results;
    }

private slots:
    void initTestCase() { m_set = testing::simulatedExample(2e7); }

    /// u^2 of sensitivity, rows and step grow by 2 r c_i c_j.
    void sensitivity_hasTheCrossTerm_data()
    {
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("other");
        QTest::addColumn<double>("r");
        QTest::newRow("inputs of the step") << "p1_pa"
                                            << "t1_k" << 0.7;
        QTest::newRow("of step and chain") << "t1_k"
                                           << "gain_relative" << -1.0;
    }
    void sensitivity_hasTheCrossTerm()
    {
        QFETCH(QString, one);
        QFETCH(QString, other);
        QFETCH(double, r);
        const CalibrationResults without = run(stated({}));
        const CalibrationResults with = run(stated({{one.toStdString(), other.toStdString(), r}}));
        const ReportedValue &S = *with.uncertainty->sensitivity;
        const double crossed = 2.0 * r * lineOf(S, one.toStdString())->contribution
            * lineOf(S, other.toStdString())->contribution;
        QVERIFY(std::abs(crossed) > 0.02 * *S.u * *S.u); // it counts
        const double before = *without.uncertainty->sensitivity->u;
        QVERIFY(isNear(*S.u, std::sqrt(before * before + crossed)));
        double shares = 0.0;
        for (const UncertaintyLine &line : S.lines)
            shares += S.sharePercent(line);
        QVERIFY(isNear(shares, 100.0));
        const double relative = crossed / (S.value * S.value);
        const RowUncertainty &rows = with.uncertainty->rows;
        const double common = without.uncertainty->rows.u_common_relative;
        QVERIFY(isNear(rows.u_common_relative, std::sqrt(common * common + relative)));
        const Index row = 3;
        QVERIFY(isNear(std::pow(rows.u_magnitude[row], 2),
            std::pow(without.uncertainty->rows.u_magnitude[row], 2)
                + relative * std::pow(with.response->magnitude[row], 2),
            1e-9));
    }

    /// A level of one shot and that shot are the same value: one U.
    void shot_hasItAsItsLevel()
    {
        const CalibrationResults without = run(stated({}));
        for (const char *other : {"p1_pa", "gain_relative"}) {
            const CalibrationResults with = run(stated({{"t1_k", other, -0.9}}));
            const UncertaintyReport &report = *with.uncertainty;
            QCOMPARE(report.perLevel.size(), report.ofShots.size());
            for (std::size_t i = 0; i < report.ofShots.size(); ++i) {
                const ReportedValue &shot = report.ofShots[i];
                QVERIFY(isNear(*shot.u, *report.perLevel[i].u));
                QVERIFY(std::abs(*shot.u / *without.uncertainty->ofShots[i].u - 1.0) > 0.01);
                double shares = 0.0;
                for (const UncertaintyLine &line : shot.lines)
                    shares += shot.sharePercent(line);
                QVERIFY(isNear(shares, 100.0));
            }
        }
    }

    void step_hasItsOwn_andMonteCarloAgrees()
    {
        Recipe recipe = stated({{"p1_pa", "t1_k", 0.9}});
        recipe.uncertainty.monteCarloTrials = 20000;
        const CalibrationResults results = run(recipe, StageId::MonteCarlo);
        const ShockConditions &shot = results.shock->shots.front();
        const double u = *shot.uncertainty->u(StepResult::Step);
        const double before
            = *run(stated({})).shock->shots.front().uncertainty->u(StepResult::Step);
        QVERIFY(std::abs(u / before - 1.0) > 0.005);
        const auto &drawn = results.monteCarlo->shots.front().outcome;
        QVERIFY(drawn.has_value());
        QVERIFY(isNear(drawn->result.u[static_cast<Index>(StepResult::Step)], u, 0.02));
    }

    /// What an input has to become is what it is then.
    void wantedU_isReachedByItsFactor()
    {
        ReportedValue value{
            "sensitivity", 100.0, "V/Pa", {directLine("a", 1.0), directLine("b", -0.6)}};
        value.lines[0].correlated = {{"b", 0.5}};
        value.lines[1].correlated = {{"a", 0.5}};
        combineLines(value);
        QVERIFY(isNear(*value.u, std::sqrt(1.36 - 0.6)));
        const auto way = wayToU(value, {0.013, 2.0});
        QVERIFY(way && way->inputs[0].factor);
        value.lines[0].contribution *= *way->inputs[0].factor;
        combineLines(value);
        QVERIFY(isNear(*value.u, 0.65));
    }
};

DYNCAL_TEST(TestCorrelatedBudget)
#include "tst_correlated_budget.moc"

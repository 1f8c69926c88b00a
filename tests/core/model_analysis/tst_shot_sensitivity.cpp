// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/distributions.h"
#include "core/model_analysis/shot_sensitivity.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <vector>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr auto kStep = static_cast<Index>(StepResult::Step);

BudgetLine line(const char *quantity, double contribution, bool common, double dof)
{
    BudgetLine result;
    result.input.quantity = quantity;
    result.input.dof = dof;
    result.input.common = common;
    result.contribution = Eigen::VectorXd::Zero(kStepResults);
    result.contribution[kStep] = contribution;
    return result;
}

/// Shots whose own and common relative parts of the step's uncertainty are given.
struct Shots
{
    std::vector<ShotSensitivity> list;
    std::vector<StepUncertainty> steps;

    void add(double sensitivity, double step_Pa, double own, double common,
        ShotLevel level = ShotLevel::None)
    {
        StepUncertainty step;
        step.budget.lines = {line("t1_k", common * step_Pa, true, kInfinite),
            line("arrival_s", own * step_Pa, false, kInfinite)};
        step.budget.u = Eigen::VectorXd::Constant(kStepResults, std::hypot(own, common) * step_Pa);
        step.budget.dof = Eigen::VectorXd::Constant(kStepResults, kInfinite);
        steps.push_back(step);
        ShotSensitivity shot;
        shot.shot = static_cast<Index>(list.size()) + 1;
        shot.sensitivity = sensitivity;
        shot.step_Pa = step_Pa;
        shot.level = level;
        shot.uLevel_relative = 0.0;
        addUncertainty(&steps.back(), kInfinite, shot);
        list.push_back(shot);
    }

    SensitivitySummary summary() const
    {
        std::vector<const StepUncertainty *> pointers;
        for (const StepUncertainty &step : steps)
            pointers.push_back(&step);
        return summarise(list, pointers);
    }
};

} // namespace

class TestShotSensitivity : public QObject
{
    Q_OBJECT

private slots:
    void oneShot_hasTheUncertaintiesOfStepAndLevel();
    void twoShots_areComparedWithTheirOwnParts();
    void commonParts_cancelInTheComparison();
    void mean_averagesOwnPartsOnly();
    void shotsThatDisagree_haveTheirScatterAndACause();
    void levels_poolTheirScatter();
    void trend_isTheSlopeThatWasMade();
    void unknownUncertainty_isComparedWithOnePercent();
};

void TestShotSensitivity::oneShot_hasTheUncertaintiesOfStepAndLevel()
{
    Shots shots;
    shots.add(2e-9, 4e5, 0.003, 0.004);
    QVERIFY(isNear(*shots.list[0].u, 0.005 * 2e-9));
    ShotSensitivity noisy = shots.list[0];
    noisy.uLevel_relative = 0.012;
    addUncertainty(&shots.steps[0], 9.0, noisy);
    QVERIFY(isNear(*noisy.u, 0.013 * 2e-9));
    QVERIFY(isNear(noisy.dof, 9.0 * std::pow(13.0 / 12.0, 4)));
    QVERIFY(isNear(noisy.k, coverageFactor(noisy.dof, 0.95)));
    const SensitivitySummary summary = shots.summary();
    QVERIFY(isNear(*summary.mean->u, 0.005 * 2e-9) && !summary.homogeneity_p);
}

void TestShotSensitivity::twoShots_areComparedWithTheirOwnParts()
{
    Shots shots;
    shots.add(1.00, 1e5, 0.01, 0.0);
    shots.add(1.03, 1e5, 0.01, 0.0);
    const double difference = 0.03 / 1.015;
    const double expected
        = chiSquareSurvival(difference * difference / (2.0 * (1e-4 + 25e-8)), 1.0);
    QVERIFY(isNear(*shots.summary().homogeneity_p, expected));
}

void TestShotSensitivity::commonParts_cancelInTheComparison()
{
    Shots without;
    Shots with;
    for (const double value : {1.00, 1.03, 1.01}) {
        without.add(value, 1e5, 0.01, 0.0);
        with.add(value, 1e5, 0.01, 0.3);
    }
    QVERIFY(isNear(*with.summary().homogeneity_p, *without.summary().homogeneity_p, 1e-6));
}

void TestShotSensitivity::mean_averagesOwnPartsOnly()
{
    Shots shots;
    for (int i = 0; i < 4; ++i)
        shots.add(1.0, 1e5, 0.006, 0.004);
    const SensitivitySummary summary = shots.summary();
    QVERIFY(isNear(*summary.mean->u, std::hypot(0.006 / 2.0, 0.004)));
    QVERIFY(summary.shotsAgree && summary.findings.empty());
    QVERIFY(!summary.linearity_per_Pa);
}

void TestShotSensitivity::shotsThatDisagree_haveTheirScatterAndACause()
{
    Shots shots;
    shots.add(1.0, 1e5, 0.002, 0.004);
    shots.add(1.5, 1e5, 0.002, 0.004);
    shots.add(1.0, 1e5, 0.002, 0.004);
    const SensitivitySummary summary = shots.summary();
    QVERIFY(!summary.shotsAgree);
    QCOMPARE(summary.findings.size(), std::size_t(1));
    QCOMPARE(summary.findings[0].id, std::string("RSP-002"));
    QCOMPARE(summary.findings[0].causes, std::vector{FindingCause::Shots});
    QVERIFY(summary.findings[0].message.arguments[2] == "2");
    const double mean = 3.5 / 3.0;
    const double scatter
        = std::sqrt(0.5 * (2.0 * std::pow(1.0 - mean, 2) + std::pow(1.5 - mean, 2)));
    QVERIFY(isNear(*summary.mean->u, std::hypot(scatter / std::sqrt(3.0), 0.004 * mean)));
    QVERIFY(summary.mean->k > 4.2 && summary.mean->k < 4.31);
}

void TestShotSensitivity::levels_poolTheirScatter()
{
    Shots shots;
    shots.add(1.00, 1e5, 1e-4, 0.0, ShotLevel::Low);
    shots.add(1.02, 1e5, 1e-4, 0.0, ShotLevel::Low);
    shots.add(1.20, 2e5, 1e-4, 0.0, ShotLevel::High);
    shots.add(1.24, 2e5, 1e-4, 0.0, ShotLevel::High);
    const SensitivitySummary summary = shots.summary();
    QCOMPARE(summary.perLevel.size(), std::size_t(2));
    QCOMPARE(summary.perLevel[1].level, ShotLevel::High);
    QVERIFY(isNear(summary.perLevel[0].value, 1.01) && isNear(summary.perLevel[1].value, 1.22));
    const double mean = 1.115;
    const double pooled = std::sqrt((2 * 0.01 * 0.01 + 2 * 0.02 * 0.02) / 2.0) / mean;
    QVERIFY(isNear(*summary.perLevel[0].u, 1.01 * pooled / std::sqrt(2.0)));
    QVERIFY(isNear(summary.perLevel[0].dof, 2.0));
}

void TestShotSensitivity::trend_isTheSlopeThatWasMade()
{
    constexpr double kSlope = 5e-8;
    Shots shots;
    for (const double step_Pa : {1e5, 2e5, 4.5e5})
        shots.add(3e-9 * (1.0 + kSlope * (step_Pa - 2.5e5)), step_Pa, 0.01, 0.02);
    const SensitivitySummary summary = shots.summary();
    QVERIFY(isNear(*summary.linearity_per_Pa, kSlope, 1e-6));
    // Ordinary least squares of equal weights: u(b) = u/sqrt(sum (x - mean)^2).
    const double squares = std::pow(1.5e5, 2) + std::pow(0.5e5, 2) + std::pow(2.0e5, 2);
    QVERIFY(isNear(*summary.uLinearity_per_Pa, std::hypot(0.01, 5e-4) / std::sqrt(squares), 1e-6));
}

void TestShotSensitivity::unknownUncertainty_isComparedWithOnePercent()
{
    Shots shots;
    shots.add(1.0, 1e5, 0.01, 0.0);
    shots.add(3.0, 1e5, 0.01, 0.0);
    const SensitivitySummary summary = summarise(shots.list, {nullptr, &shots.steps[1]});
    QVERIFY(isNear(summary.mean->value, 2.0));
    QVERIFY(!summary.mean->u && !summary.linearity_per_Pa);
    QCOMPARE(summary.findings.size(), std::size_t(1));
    shots.list[1].sensitivity = 1.015;
    QVERIFY(summarise(shots.list, {nullptr, &shots.steps[1]}).findings.empty());
    shots.list[0].sensitivity.reset();
    QVERIFY(!shots.summary().mean);
}

DYNCAL_TEST(TestShotSensitivity)
#include "tst_shot_sensitivity.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Shots and levels of a sensor that does not ring, each for itself.

#include "core/realization/model/second_order_shots.h"

#include "core/realization/model/homogeneity.h"
#include "core/realization/model/model_description.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/second_order/second_order_choice.h"
#include "tests/support/damped_shots.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace dyncal;

namespace {

constexpr double kF0_Hz = 318e3;

testing::RealizedModel modelOf(const ModelInput &input)
{
    const auto hankel = decomposeHankel(input, {});
    return testing::realizeModel(input, *hankel, 2).value();
}

/// The second-order sensor as the model, whether or not it is the better one.
testing::RealizedModel sensorOf(const ModelInput &input, double zeta)
{
    const auto fit = fitSecondOrder(
        input, refinementRecords(input), {{kF0_Hz, zeta, {0.3, 0.6, 0.9}, {0.0, 0.0, 0.0}}});
    ModelDraft draft;
    takeSecondOrder(*fit, draft);
    testing::RealizedModel result;
    describeModel(input, draft, std::nullopt, result.model);
    result.model.secondOrder = fit->sensor;
    result.model.draft = draft;
    result.assessment.poles = result.model.poles;
    addUncertainties(draft, result.assessment.poles);
    result.assessment.secondOrder = fit->sensor;
    compareShots(input, result.model, result.assessment, {});
    result.assessment.findings = judgeShots(result.assessment);
    return result;
}

ModelInput shotsOf(
    const std::vector<double> &f0_Hz, double zeta, std::uint64_t seed, double noise = 0.002)
{
    return testing::dampedShots(
        [&](std::size_t shot, double t_s) { return testing::dampedStep(f0_Hz[shot], zeta, t_s); },
        seed, {noise});
}

bool isFlagged(const Pole &pole)
{
    return std::ranges::find(pole.flags, kShotsDisagreeFlag) != pole.flags.end();
}

} // namespace

class TestSecondOrderShots : public QObject
{
    Q_OBJECT

private slots:
    void everyShot_isTheSensor()
    {
        ModelInput input = shotsOf({kF0_Hz, kF0_Hz, kF0_Hz}, 1.1, 2);
        input.series[0].level = ShotLevel::Low;
        input.series[1].level = input.series[2].level = ShotLevel::High;
        const auto [model, assessment] = modelOf(input);
        QVERIFY(model.secondOrder.has_value());
        QCOMPARE(assessment.perShot.size(), std::size_t(3));
        QCOMPARE(assessment.perLevel.size(), std::size_t(2));
        QCOMPARE(assessment.perLevel[0].frequency_Hz, assessment.perShot[0].frequency_Hz);
        QCOMPARE(assessment.perLevel[1].shots, (std::vector<Index>{2, 3}));
        for (const LevelPole &part : assessment.perShot) {
            QVERIFY(std::abs(part.frequency_Hz - kF0_Hz) < 4.0 * part.u_frequency_Hz);
            QVERIFY(std::abs(part.dampingRatio - 1.1) < 4.0 * part.u_dampingRatio);
            QVERIFY(std::abs(part.plateauGain - part.step) < 4.0 * part.u_plateauGain);
        }
        // Independent shots of the same noise: their weighted mean is as certain as the joint fit.
        double weights = 0.0;
        for (const LevelPole &part : assessment.perShot)
            weights += std::pow(part.dampingRatio / part.u_dampingRatio, 2);
        const double u = assessment.secondOrder->u_zeta / assessment.secondOrder->zeta;
        QVERIFY(std::abs(u * std::sqrt(weights) - 1.0) < 0.15);
    }

    /// At 1 % one of 100 fails; five or more have a probability of 0.3 %. At a damping ratio of 1
    /// the poles of some shots are pairs, of others real.
    void consistentShots_pass()
    {
        int failed = 0;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const auto [model, assessment] = modelOf(shotsOf({kF0_Hz, kF0_Hz, kF0_Hz}, 1.0, seed));
            QVERIFY(model.secondOrder && assessment.homogeneity);
            QCOMPARE(assessment.homogeneity->dof, 4.0);
            failed += !assessment.homogeneity->passed;
        }
        qInfo("%d of 100 told apart", failed);
        QVERIFY(failed <= 4);
    }

    void shotsThatDiffer_areStatedWithTheirScatter()
    {
        for (const double zeta : {0.9, 1.5}) {
            const auto [model, assessment]
                = sensorOf(shotsOf({0.95 * kF0_Hz, kF0_Hz, 1.05 * kF0_Hz}, zeta, 4, 2e-4), zeta);
            QVERIFY(assessment.homogeneity.has_value());
            QVERIFY(!assessment.homogeneity->passed);
            QVERIFY(std::ranges::any_of(assessment.findings,
                [](const Finding &finding) { return finding.id == "MOD-010"; }));
            const SecondOrderModel &sensor = *assessment.secondOrder;
            // By definition, over the shots as stated: sum w (x - m)^2 / ((n - 1) sum w).
            double weights = 0.0, sum = 0.0, squares = 0.0;
            for (const LevelPole &shot : assessment.perShot) {
                const double w = 1.0 / (shot.u_frequency_Hz * shot.u_frequency_Hz);
                weights += w;
                sum += w * shot.frequency_Hz;
                squares += w * shot.frequency_Hz * shot.frequency_Hz;
            }
            const double scatter_Hz = std::sqrt((squares - sum * sum / weights) / (2.0 * weights));
            QVERIFY(std::abs(sensor.u_f0_Hz / scatter_Hz - 1.0) < 1e-6);
            QVERIFY(std::abs(scatter_Hz / (0.05 * kF0_Hz / std::sqrt(3.0)) - 1.0) < 0.2);
            QVERIFY(std::abs(sensor.coverageFactor - 4.30265) < 1e-4); // t of 2 degrees of freedom
            for (const Pole &pole : assessment.poles) {
                QVERIFY(isFlagged(pole));
                QCOMPARE(std::isfinite(pole.u_frequency_Hz), zeta < 1.0);
            }
            const auto shown = sensorResonance(&model, &assessment);
            QCOMPARE(shown->u_frequency_Hz, sensor.u_f0_Hz);
            QCOMPARE(shown->coverageFactor, sensor.coverageFactor);
            QVERIFY(std::isnan(sensorResonance(&model, nullptr)->u_frequency_Hz)); // not assessed
        }
    }
};

DYNCAL_TEST(TestSecondOrderShots)
#include "tst_second_order_shots.moc"

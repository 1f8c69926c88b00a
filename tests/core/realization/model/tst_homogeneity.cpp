// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/homogeneity.h"
#include "tests/support/pole_coverage.h"
#include "tests/support/realized_model.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;

namespace {

testing::RealizedModel modelOf(const ModelInput &input, Index order = 2)
{
    RealizationSettings settings;
    settings.maxOrder = order + 2;
    const auto hankel = decomposeHankel(input, settings);
    return testing::realizeModel(input, *hankel, order, settings).value();
}

testing::SimulatedCalibration resonance(double snr_dB, double ar1 = 0.0)
{
    return {{{1.0, 30e3, 0.05}}, snr_dB, ar1};
}

ModelAssessment assessed(const ModelInput &input, Index order = 2)
{
    return modelOf(input, order).assessment;
}

bool isTold(const ModelAssessment &assessment)
{
    return std::any_of(assessment.findings.begin(), assessment.findings.end(),
        [](const Finding &finding) { return finding.id == "MOD-010"; });
}

} // namespace

class TestHomogeneity : public QObject
{
    Q_OBJECT

private slots:
    void consistentShots_pass_data()
    {
        QTest::addColumn<double>("snr_dB");
        QTest::addColumn<double>("ar1");
        QTest::newRow("40 dB") << 40.0 << 0.0;
        QTest::newRow("20 dB") << 20.0 << 0.0;
        QTest::newRow("30 dB, AR(0.9)") << 30.0 << 0.9;
    }
    void consistentShots_pass()
    {
        // At 1 % one of 100 fails; five or more have a probability of 0.3 %. The whole figure:
        // tests/accuracy/pole_coverage.
        QFETCH(double, snr_dB);
        QFETCH(double, ar1);
        int failed = 0;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const ModelAssessment found
                = assessed(testing::simulateCalibration(resonance(snr_dB, ar1), seed));
            QVERIFY(found.homogeneity.has_value());
            QCOMPARE(found.homogeneity->dof, 4.0);
            QCOMPARE(found.homogeneity->passed, !isTold(found));
            failed += !found.homogeneity->passed;
        }
        qInfo("%d of 100 told apart", failed);
        QVERIFY(failed <= 4);
    }

    void onePercentInOneShot_isFound()
    {
        testing::SimulatedCalibration calibration = resonance(40.0);
        calibration.shiftOfShot = {0.0, 0.01, 0.0};
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const ModelAssessment found = assessed(testing::simulateCalibration(calibration, seed));
            QVERIFY(found.homogeneity && !found.homogeneity->passed);
            QVERIFY(isTold(found));
        }
    }

    void shotsThatDiffer_areStatedWithTheirScatter()
    {
        testing::SimulatedCalibration calibration = resonance(60.0);
        calibration.shiftOfShot = {-0.01, 0.0, 0.01};
        const auto result = modelOf(testing::simulateCalibration(calibration, 3));
        const ModelAssessment &found = result.assessment;
        const Pole &pole = *result.main();
        // Equal noise relative to the step: equal weights, so u is the sample's sd over sqrt(3).
        QVERIFY2(std::abs(pole.u_frequency_Hz / (300.0 / std::sqrt(3.0)) - 1.0) < 0.02,
            qPrintable(QString::number(pole.u_frequency_Hz)));
        QVERIFY(std::abs(pole.coverageFactor - 4.30265) < 1e-4); // t of 2 degrees of freedom
        QVERIFY(
            std::find(pole.flags.begin(), pole.flags.end(), "shots-disagree") != pole.flags.end());
        // Both halves of the pair say the same.
        QCOMPARE(found.poles[1].u_frequency_Hz, found.poles[0].u_frequency_Hz);
        QCOMPARE(found.poles[1].coverageFactor, found.poles[0].coverageFactor);
    }

    void perShot_showsTheTrend()
    {
        testing::SimulatedCalibration calibration = resonance(60.0);
        calibration.shiftOfShot = {-0.01, 0.0, 0.01};
        ModelInput input = testing::simulateCalibration(calibration, 4);
        const double steps[] = {0.33, 0.6, 0.9};
        for (std::size_t i = 0; i < 3; ++i)
            input.series[i].step = steps[i];
        const ModelAssessment found = assessed(input);
        QCOMPARE(found.perShot.size(), std::size_t(3));
        QVERIFY(found.perLevel.empty()); // no shot carries a level
        for (std::size_t i = 0; i < 3; ++i) {
            const LevelPole &shot = found.perShot[i];
            QCOMPARE(shot.shots, std::vector<Index>{static_cast<Index>(i) + 1});
            QCOMPARE(shot.step, steps[i]);
            const double truth_Hz = 30e3 * (1.0 + calibration.shiftOfShot[i]);
            QVERIFY(std::abs(shot.frequency_Hz - truth_Hz) < 4.0 * shot.u_frequency_Hz);
            QVERIFY(std::abs(shot.dampingRatio - 0.05) < 4.0 * shot.u_dampingRatio);
            QVERIFY(std::abs(shot.plateauGain - steps[i]) < 4.0 * shot.u_plateauGain);
            QVERIFY(shot.coverageFactor > 1.95 && shot.coverageFactor < 2.0);
        }
    }

    void shotsOfOneLevel_areFittedTogether()
    {
        ModelInput input = testing::simulateCalibration(resonance(40.0), 6);
        input.series[0].level = ShotLevel::High;
        input.series[1].level = ShotLevel::Low;
        input.series[2].level = ShotLevel::High;
        const ModelAssessment found = assessed(input);
        QCOMPARE(found.perLevel.size(), std::size_t(2));
        QCOMPARE(found.perLevel[0].level, ShotLevel::Low);
        QCOMPARE(found.perLevel[0].shots, std::vector<Index>{2});
        QCOMPARE(found.perLevel[0].frequency_Hz, found.perShot[1].frequency_Hz);
        QCOMPARE(found.perLevel[1].shots, (std::vector<Index>{1, 3}));
        // Two shots of equal relative noise: u falls by sqrt(2).
        const double ratio = found.perLevel[1].u_frequency_Hz / found.perShot[0].u_frequency_Hz;
        QVERIFY2(std::abs(ratio * std::sqrt(2.0) - 1.0) < 0.1, qPrintable(QString::number(ratio)));
    }

    void consistentShots_keepTheNoisesUncertainty()
    {
        const auto result = modelOf(testing::simulateCalibration(resonance(40.0), 1));
        const ModelAssessment &found = result.assessment;
        QVERIFY(found.homogeneity->passed);
        const Pole &pole = *result.main();
        QVERIFY(pole.flags.empty());
        QVERIFY(pole.coverageFactor > 1.95 && pole.coverageFactor < 1.97);
        QCOMPARE(result.model.uncertaintyMethod, std::string("white"));
        // Three shots of equal relative noise.
        QVERIFY(std::abs(pole.u_frequency_Hz / found.perShot[0].u_frequency_Hz * std::sqrt(3.0) - 1)
            < 0.15);
    }

    void colouredNoise_isNamed()
    {
        const auto result = modelOf(testing::simulateCalibration(resonance(30.0, 0.9), 2));
        QCOMPARE(result.model.uncertaintyMethod, std::string("AR(1)"));
    }

    void ofAnAverageOrWithoutRefinement_nothingIsSaid()
    {
        ModelInput input = testing::simulateCalibration(resonance(40.0), 1);
        input.series.resize(1);
        const ModelAssessment found = assessed(input);
        QCOMPARE(found.perShot.size(), std::size_t(1));
        QVERIFY(!found.homogeneity);
        input.series[0].shot = 0;
        QVERIFY(assessed(input).perShot.empty());

        input = testing::simulateCalibration(resonance(40.0), 1);
        RealizationSettings settings;
        settings.refine = false;
        const auto plain
            = testing::realizeModel(input, *decomposeHankel(input, settings), 2, settings).value();
        QVERIFY(plain.assessment.perShot.empty() && !plain.assessment.homogeneity);
        QVERIFY(plain.model.uncertaintyMethod.empty());
    }

    void highOrders_stayFinite()
    {
        const ModelInput input = testing::simulateCalibration(resonance(30.0), 1);
        for (const Index order : {Index(1), Index(3), Index(6), Index(12)}) {
            const ModelAssessment found = assessed(input, order);
            if (!found.homogeneity)
                continue;
            QVERIFY(found.homogeneity->statistic >= 0.0);
            QVERIFY(found.homogeneity->probability >= 0.0 && found.homogeneity->probability <= 1.0);
        }
    }
};

DYNCAL_TEST(TestHomogeneity)
#include "tst_homogeneity.moc"

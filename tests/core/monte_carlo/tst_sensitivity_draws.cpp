// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Sensitivities of one trial, from shots and factors that are written down.

#include "core/model_analysis/transducer_steps.h"
#include "core/monte_carlo/sensitivity_draws.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using testing::isNear;

namespace {

/// Two shots of 2 and 4 uV/Pa; both steps have the common factor x[0] and their own x[1].
struct TwoShots
{
    ModelInput input;
    SensorModel model;
    ModelAssessment assessment;
    ResponseResult response;
    ShockConditionsSet shock;
    UncertaintyReport report;
    std::vector<StatedUncertainty> stated;
    ChainInputs inputs;

    TwoShots()
    {
        response.sensitivity = 3e-6;
        response.unit = response.sensitivityUnit = "V/Pa";
        inputs.shots = {shot(1, 2e-6), shot(2, 4e-6)};
        inputs.means = {{{0, 1}, std::nullopt}};
    }

    ChainSubject subject() const
    {
        return {input, model, assessment, response, shock, report, stated};
    }

    ShotChain shot(Index number, double sensitivity)
    {
        UncertainInput common{"t1_k", 1.0, 0.1};
        common.common = true;
        const UncertainInput own{"arrival_s", 1.0, 0.2};
        const UncertainInput level{kLevelRelative, 0.0, 0.01};
        ShotChain one{number, ShotLevel::None, sensitivity, 1e5, {}, {}, {}};
        one.ofStep = {
            {common, inputs.sources.add(common, number)}, {own, inputs.sources.add(own, number)}};
        one.stepAt_Pa
            = [](const Eigen::VectorXd &x) -> Result<double> { return 1e5 * x[0] * x[1]; };
        one.ofLevel = {level, inputs.sources.add(level, number)};
        return one;
    }

    void addFactor(const char *name, bool divides, bool ofLevelsOnly = false)
    {
        UncertainInput x{name, 0.0, 0.05};
        x.common = true;
        inputs.factors.push_back({{x, inputs.sources.add(x)}, divides, ofLevelsOnly});
    }

    /// Probabilities of the deviates `z` of the sources, in their order; 0 of those left out.
    DrawnSensitivities at(const std::vector<double> &z) const
    {
        Eigen::VectorXd p = Eigen::VectorXd::Constant(inputs.sources.size(), 0.5);
        for (std::size_t i = 0; i < z.size(); ++i)
            p[static_cast<Index>(i)] = 0.5 * std::erfc(-z[i] / std::sqrt(2.0));
        return drawnSensitivities(subject(), inputs, p);
    }
};

} // namespace

class TestSensitivityDraws : public QObject
{
    Q_OBJECT

private slots:
    void noError_givesWhatWasFound()
    {
        const TwoShots two;
        const DrawnSensitivities drawn = two.at({});
        QVERIFY(isNear(drawn.ofMeans[0], 3e-6));
        QVERIFY(isNear(drawn.ofShots[0], 2e-6) && isNear(drawn.ofShots[1], 4e-6));
        QVERIFY(isNear(drawn.common, 1.0));
    }

    /// Sources: t1, own of 1, level of 1, own of 2, level of 2. A larger step makes S smaller.
    void commonError_isInEveryShot()
    {
        const TwoShots two;
        const DrawnSensitivities drawn = two.at({1.0});
        QVERIFY(isNear(drawn.ofShots[0], 2e-6 / 1.1) && isNear(drawn.ofShots[1], 4e-6 / 1.1));
        QVERIFY(isNear(drawn.ofMeans[0], 3e-6 / 1.1) && isNear(drawn.common, 1.0 / 1.1));
    }

    void ownError_isInItsShot()
    {
        const TwoShots two;
        const DrawnSensitivities drawn = two.at({0.0, 1.0, 2.0, -1.0});
        QVERIFY(isNear(drawn.ofShots[0], 2e-6 / 1.2 * 1.02));
        QVERIFY(isNear(drawn.ofShots[1], 4e-6 / 0.8));
        QVERIFY(isNear(drawn.ofMeans[0], 0.5 * (drawn.ofShots[0] + drawn.ofShots[1])));
        // The rows have their own noise in the place of that of the levels.
        QVERIFY(isNear(drawn.common, (2e-6 / 1.2 + 4e-6 / 0.8) / 6e-6));
    }

    void factors_multiplyOrDivide()
    {
        TwoShots two;
        two.addFactor("gain_relative", true);
        two.addFactor("mounting_relative", false);
        two.addFactor(kChainLevel, true, true);
        const DrawnSensitivities drawn = two.at({0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0, -1.0});
        QVERIFY(isNear(drawn.ofMeans[0], 3e-6 / 1.05 * 1.1 / 0.95));
        QVERIFY(isNear(drawn.ofShots[1], 4e-6 / 1.05 * 1.1 / 0.95));
        QVERIFY(isNear(drawn.common, 1.1 / 1.05)); // the chain's table is each row's own
    }

    /// The scatter stands for what the shots do not share; their own values keep theirs.
    void scatter_takesThePlaceOfOwnErrors()
    {
        TwoShots two;
        UncertainInput scatter{kScatterOfShots, 0.0, 0.1, Distribution::Normal, 1.0, true};
        two.inputs.means[0].scatter = DrawnInput{scatter, two.inputs.sources.add(scatter)};
        const DrawnSensitivities drawn = two.at({1.0, 1.0, 2.0, -1.0});
        QVERIFY(isNear(drawn.ofMeans[0], 3e-6 / 1.1) && isNear(drawn.common, 1.0 / 1.1));
        QVERIFY(isNear(drawn.ofShots[0], 2e-6 / 1.1 / 1.2 * 1.02));
        // Student's of one degree of freedom: tan(pi (p - 1/2)) of its probability.
        const double p = 0.5 * std::erfc(-1.0 / std::sqrt(2.0));
        const DrawnSensitivities far = two.at({0.0, 0.0, 0.0, 0.0, 0.0, 1.0});
        QVERIFY(isNear(
            far.ofMeans[0], 3e-6 * (1.0 + 0.1 * std::tan(std::numbers::pi * (p - 0.5))), 1e-9));
        QVERIFY(isNear(far.common, far.ofMeans[0] / 3e-6));
    }

    void meansOfLevels_haveTheirShots()
    {
        TwoShots two;
        two.inputs.means.push_back({{1}, std::nullopt});
        const DrawnSensitivities drawn = two.at({0.0, 1.0});
        QVERIFY(isNear(drawn.ofMeans[1], 4e-6) && drawn.ofMeans[0] < 3e-6);
    }

    void stepThatDoesNotExist_isNoNumber()
    {
        TwoShots two;
        two.inputs.shots[1].stepAt_Pa = [](const Eigen::VectorXd &) -> Result<double> {
            return fail(ErrorKind::DataBlocked, {"not above Mach 1", {}});
        };
        const DrawnSensitivities drawn = two.at({});
        QVERIFY(isNear(drawn.ofShots[0], 2e-6));
        QVERIFY(std::isnan(drawn.ofShots[1]) && std::isnan(drawn.ofMeans[0])
            && std::isnan(drawn.common));
        two.inputs.shots[1].stepAt_Pa
            = [](const Eigen::VectorXd &) -> Result<double> { return -1.0; };
        QVERIFY(std::isnan(two.at({}).ofShots[1]));
    }

    /// Relative to its own level a response has the noise of the levels, and no step.
    void relativeResponse_hasItsLevels()
    {
        TwoShots two;
        two.response.unit = "1";
        for (const ShotChain &shot : two.inputs.shots)
            two.inputs.levels.push_back(shot.ofLevel);
        two.addFactor("gain_relative", true);
        const DrawnSensitivities drawn = two.at({1.0, 1.0, 2.0, 1.0, -1.0, 1.0});
        QVERIFY(isNear(drawn.common, 2.0 / (1.02 + 0.99)));
    }

    /// Against a transducer all rows share its chain; its sensitivity is each row's own.
    void transducer_sharesItsGain()
    {
        TwoShots two;
        two.response.isByTransducer = true;
        for (ShotChain &shot : two.inputs.shots) {
            UncertainInput gain{kReferenceGain, 1.0, 0.02};
            gain.common = true;
            shot.ofStep.push_back({gain, two.inputs.sources.add(gain, shot.shot)});
        }
        QVERIFY(isNear(two.at({1.0, 1.0, 0.0, 0.0, 0.0, 1.0}).common, 1.02));
    }
};

DYNCAL_TEST(TestSensitivityDraws)
#include "tst_sensitivity_draws.moc"

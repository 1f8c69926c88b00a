// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a calibration's trials draw: from the same inputs as the budget.

#include "core/model_analysis/transducer_steps.h"
#include "core/monte_carlo/chain_inputs.h"
#include "tests/support/calibrated_chain.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;
using testing::CalibratedChain;
using testing::isNear;

namespace {

const DrawnInput *inputOf(const ShotChain &shot, const std::string &quantity)
{
    const auto found = std::ranges::find_if(
        shot.ofStep, [&](const DrawnInput &one) { return one.input.quantity == quantity; });
    return found == shot.ofStep.end() ? nullptr : &*found;
}

Eigen::VectorXd foundValues(const ShotChain &shot)
{
    Eigen::VectorXd x(std::ssize(shot.ofStep));
    for (Index i = 0; i < x.size(); ++i)
        x[i] = shot.ofStep[static_cast<std::size_t>(i)].input.value;
    return x;
}

} // namespace

class TestChainInputs : public QObject
{
    Q_OBJECT

private:
    std::optional<CalibratedChain> m_chain;

private slots:
    void initTestCase() { m_chain.emplace(); }

    /// With no error every step is the one that was used.
    void steps_areFoundAgain()
    {
        const ChainInputs inputs = chainInputs(m_chain->subject());
        QCOMPARE(std::ssize(inputs.shots), Index(3));
        for (const ShotChain &shot : inputs.shots) {
            const auto step_Pa = shot.stepAt_Pa(foundValues(shot));
            QVERIFY(step_Pa.has_value());
            QVERIFY(isNear(*step_Pa, shot.step_Pa, 1e-12));
        }
    }

    /// Each input is known as the budget of the step has it.
    void inputs_areThoseOfTheBudget()
    {
        const ChainInputs inputs = chainInputs(m_chain->subject());
        for (const ShotChain &shot : inputs.shots) {
            const auto &budget = m_chain->results.shock->ofShot(shot.shot)->uncertainty->budget;
            QCOMPARE(shot.ofStep.size(), budget.lines.size());
            for (const BudgetLine &line : budget.lines) {
                const DrawnInput *input = inputOf(shot, line.input.quantity);
                QVERIFY2(input, line.input.quantity.c_str());
                QCOMPARE(input->input.u, line.input.u);
                QCOMPARE(input->input.distribution, line.input.distribution);
            }
        }
    }

    void commonInputs_areOneSource_ownOnesAreNot()
    {
        const ChainInputs inputs = chainInputs(m_chain->subject());
        const auto source = [&](std::size_t shot, const char *quantity) {
            const DrawnInput *input = inputOf(inputs.shots[shot], quantity);
            return input ? input->source : Index(-1);
        };
        QVERIFY(source(0, "t1_k") >= 0);
        QCOMPARE(source(0, "t1_k"), source(2, "t1_k"));
        for (const DrawnInput &one : inputs.shots[0].ofStep)
            if (!one.input.common)
                QVERIFY(one.source != source(1, one.input.quantity.c_str()));
        QVERIFY(inputs.shots[0].ofLevel.source != inputs.shots[1].ofLevel.source);
        QCOMPARE(
            inputs.shots[1].ofLevel.input.u, m_chain->results.response->shots[1].uLevel_relative);
    }

    void means_areOfAllAndOfEachLevel()
    {
        const ChainInputs inputs = chainInputs(m_chain->subject());
        QCOMPARE(std::ssize(inputs.means), Index(4));
        QCOMPARE(std::ssize(inputs.means[0].of), Index(3));
        for (std::size_t level = 1; level < 4; ++level)
            QCOMPARE(std::ssize(inputs.means[level].of), Index(1));
        QVERIFY(!inputs.means[0].scatter);
        QVERIFY(inputs.levels.empty()); // per pressure
    }

    /// A gain that is larger than stated makes S smaller.
    void factors_haveTheirDirection()
    {
        const ChainInputs inputs = chainInputs(m_chain->subject());
        QCOMPARE(std::ssize(inputs.factors), Index(3));
        for (const ChainFactor &factor : inputs.factors) {
            QCOMPARE(factor.divides, factor.x.input.quantity == "gain_relative");
            QVERIFY(!factor.ofLevelsOnly);
            QCOMPARE(factor.x.input.value, 0.0);
        }
    }

    void front_isWhatIsKnownOfIt()
    {
        const ChainInputs unknown = chainInputs(m_chain->subject());
        QCOMPARE(unknown.front.input.distribution, Distribution::Rectangular);
        QVERIFY(isNear(unknown.front.input.u, 50e-9 / std::sqrt(3.0)));
        ResponseResult stated = *m_chain->results.response;
        stated.front = {200e-9, 10e-9};
        const ChainSubject all = m_chain->subject();
        const ChainInputs known = chainInputs(
            {all.input, all.model, all.assessment, stated, all.shock, all.report, all.stated});
        QCOMPARE(known.front.input.distribution, Distribution::Normal);
        QCOMPARE(known.front.input.value, 200e-9);
        QCOMPARE(known.front.input.u, 10e-9);
    }

    /// Where the shots disagree their scatter is drawn, Student's.
    void scatter_isAnInput()
    {
        ResponseResult response = *m_chain->results.response;
        UncertaintyLine scatter = directLine(kScatterOfShots, 0.02, 2.0);
        response.summary.mean->lines.push_back(scatter);
        const ChainSubject all = m_chain->subject();
        const ChainInputs inputs = chainInputs(
            {all.input, all.model, all.assessment, response, all.shock, all.report, all.stated});
        QVERIFY(inputs.means[0].scatter.has_value() && !inputs.means[1].scatter);
        QCOMPARE(inputs.means[0].scatter->input.u, 0.02);
        QCOMPARE(inputs.means[0].scatter->input.dof, 2.0);
    }

    /// All shots of one level: its mean is the mean, one draw.
    void levelOfAllShots_hasTheScatterOfTheMean()
    {
        ResponseResult response = *m_chain->results.response;
        for (ShotSensitivity &shot : response.shots)
            shot.level = ShotLevel::High;
        response.summary.mean->lines.push_back(directLine(kScatterOfShots, 0.02, 2.0));
        response.summary.perLevel = {*response.summary.mean};
        response.summary.perLevel[0].level = ShotLevel::High;
        const ChainSubject all = m_chain->subject();
        const ChainInputs inputs = chainInputs(
            {all.input, all.model, all.assessment, response, all.shock, all.report, all.stated});
        QCOMPARE(std::ssize(inputs.means), Index(2));
        QVERIFY(inputs.means[0].scatter && inputs.means[1].scatter);
        QCOMPARE(inputs.means[0].scatter->source, inputs.means[1].scatter->source);
    }

    void shotWithoutU_leavesNoSensitivity()
    {
        ResponseResult response = *m_chain->results.response;
        response.shots[1].u.reset();
        const ChainSubject all = m_chain->subject();
        const ChainInputs inputs = chainInputs(
            {all.input, all.model, all.assessment, response, all.shock, all.report, all.stated});
        QVERIFY(inputs.shots.empty() && inputs.means.empty());
    }

    /// Relative to its own level: the noise of the levels, of each shot.
    void relativeResponse_hasItsLevels()
    {
        ResponseResult response = *m_chain->results.response;
        response.unit = "1";
        const ChainSubject all = m_chain->subject();
        const ChainInputs inputs = chainInputs(
            {all.input, all.model, all.assessment, response, all.shock, all.report, all.stated});
        QCOMPARE(std::ssize(inputs.levels), Index(3));
        response.shots[0].uLevel_relative = kUnknown;
        const ChainInputs unknown = chainInputs(
            {all.input, all.model, all.assessment, response, all.shock, all.report, all.stated});
        QVERIFY(unknown.levels.empty());
    }

    /// A step that is typed has its stated factor and nothing else.
    void typedStep_hasItsFactor()
    {
        ShockConditionsSet shock = *m_chain->results.shock;
        for (ShockConditions &shot : shock.shots) {
            shot.measurement.reset();
            const UncertaintyRequest request{
                true, {{"step_relative", 0.01, Distribution::Normal, std::nullopt}}};
            shot.uncertainty = uncertaintyOfTypedStep(*shot.step_Pa, request);
        }
        const ChainSubject all = m_chain->subject();
        const ChainInputs inputs = chainInputs(
            {all.input, all.model, all.assessment, all.response, shock, all.report, all.stated});
        const ShotChain &shot = inputs.shots.front();
        QCOMPARE(std::ssize(shot.ofStep), Index(1));
        QVERIFY(isNear(*shot.stepAt_Pa(Eigen::VectorXd::Constant(1, 1.02)), 1.02 * shot.step_Pa));
    }

    /// Against a transducer: its level over its sensitivity and the gain of its chain.
    void transducersStep_isItsOwnRelation()
    {
        ResponseResult response = *m_chain->results.response;
        response.isByTransducer = true;
        ShockConditionsSet shock = *m_chain->results.shock;
        const auto lineOf = [](const char *quantity, bool common) {
            UncertainInput input{quantity, 1.0, 0.01};
            input.common = common;
            return BudgetLine{input, {}, {}};
        };
        for (ShockConditions &shot : shock.shots)
            shot.uncertainty->budget.lines = {lineOf("reference_sensitivity_relative", true),
                lineOf(kReferenceGain, true), lineOf("reference_level_relative", false)};
        const ChainSubject all = m_chain->subject();
        const ChainInputs inputs = chainInputs(
            {all.input, all.model, all.assessment, response, shock, all.report, all.stated});
        const ShotChain &shot = inputs.shots.front();
        QVERIFY(isNear(
            *shot.stepAt_Pa(Eigen::Vector3d(1.1, 1.2, 1.3)), shot.step_Pa * 1.3 / (1.1 * 1.2)));
    }
};

DYNCAL_TEST(TestChainInputs)
#include "tst_chain_inputs.moc"

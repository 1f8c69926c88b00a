// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws of the model's parameters against fits of new records.

#include "core/monte_carlo/full_refits.h"
#include "core/monte_carlo/model_draws.h"
#include "core/uncertainty/model_values.h"
#include "tests/support/calibrated_chain.h"
#include "tests/support/damped_shots.h"
#include "tests/support/realized_model.h"
#include "tests/support/stated_chain.h"
#include "tests/support/test_program.h"
#include "tests/support/wide_response.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;

class TestFullRefits : public QObject
{
    Q_OBJECT

private:
    std::optional<testing::CalibratedChain> m_chain;

    Result<RefitCheck> check(
        const ChainSubject &subject, const JobControl &control = {}, Index trials = 10000) const
    {
        return fullRefits(
            subject, chainInputs(subject),
            [&](const ModelInput &input, const JobControl &ofRefit) {
                return m_chain->fitAgain(input, ofRefit);
            },
            trials, 1, control);
    }

private slots:
    void initTestCase() { m_chain.emplace(); }

    void draws_scatterAsFiftyRefitsDo()
    {
        const RefitCheck found = *check(m_chain->subject());
        QCOMPARE(found.refits, Index(50));
        QCOMPARE(found.failed, Index(0));
        QVERIFY(std::ssize(found.values) >= 9);
        for (const RefittedValue &one : found.values) {
            qInfo("%s: u of refits over u of draws %.3f, shift over u %.3f", one.of.c_str(),
                one.u_refits / one.u_draws, one.shift / one.u_draws);
            QVERIFY2(one.agrees, one.of.c_str());
        }
        QVERIFY(found.agrees());
    }

    /// A covariance that is four times too large is told.
    void wrongCovariance_isTold()
    {
        SensorModel wrong = *m_chain->results.model;
        wrong.draft.refinement->covariance *= 4.0;
        ChainSubject subject{*m_chain->results.input, wrong, *m_chain->results.assessment,
            *m_chain->results.response, *m_chain->results.shock, *m_chain->results.uncertainty,
            m_chain->stated};
        const RefitCheck found = *check(subject);
        QVERIFY(!found.agrees());
        QVERIFY(std::ranges::none_of(
            found.values, [](const RefittedValue &one) { return one.agrees; }));
    }

    /// A sensor without overshoot has none in any refit nor draw: no disagreement.
    void valueThatNeverMoves_agrees()
    {
        testing::DampedShots made;
        made.noise = 0.002;
        const ModelInput input = testing::dampedShots(318e3, 1.3, 1, made);
        const auto hankel = decomposeHankel(input, {});
        const testing::RealizedModel of = *testing::realizeModel(input, *hankel, 2);
        ResponseResult response = testing::wideOpen(of.model);
        UncertaintyReport report;
        report.ofModel = modelValues(of.model, of.assessment, response,
            modelVariations(input, of.model), input.treatment, testing::statedChain());
        const ChainSubject subject{input, of.model, of.assessment, response,
            *m_chain->results.shock, report, m_chain->stated};
        const auto again = [&](const ModelInput &records, const JobControl &) {
            auto refitted = testing::realizeModel(records, *hankel, 2);
            return refitted ? Result<SensorModel>(refitted->model)
                            : Result<SensorModel>(tl::unexpected(refitted.error()));
        };
        const RefitCheck found = *fullRefits(subject, chainInputs(subject), again, 4000, 1);
        const auto overshoot
            = std::ranges::find(found.values, std::string("overshoot_percent"), &RefittedValue::of);
        QVERIFY(overshoot != found.values.end());
        QCOMPARE(overshoot->u_refits, 0.0);
        QCOMPARE(overshoot->u_draws, 0.0);
        QVERIFY(overshoot->agrees);
    }

    void failedRefits_areCounted()
    {
        const ChainSubject subject = m_chain->subject();
        const auto none = fullRefits(
            subject, chainInputs(subject),
            [&](const ModelInput &, const JobControl &) -> Result<SensorModel> {
                return fail(ErrorKind::DataBlocked, {"no", {}});
            },
            10000, 1);
        QCOMPARE(none->failed, none->refits);
        QVERIFY(!none->agrees());
    }

    void withoutARefinement_thereIsNothing()
    {
        SensorModel bare = *m_chain->results.model;
        bare.draft.refinement.reset();
        ChainSubject subject{*m_chain->results.input, bare, *m_chain->results.assessment,
            *m_chain->results.response, *m_chain->results.shock, *m_chain->results.uncertainty,
            m_chain->stated};
        QVERIFY(!ModelDraws::canDraw(subject));
        QCOMPARE(check(subject)->refits, Index(0));
        QVERIFY(!check(subject)->agrees());
    }

    /// One for 200 trials: few trials are not worth a refit.
    void number_followsThatOfTheTrials()
    {
        QCOMPARE(check(m_chain->subject(), {}, 2000)->refits, Index(10));
        QCOMPARE(check(m_chain->subject(), {}, 1999)->refits, Index(0));
    }

    void stopped_isCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto found = check(m_chain->subject(), {stop.get_token(), {}});
        QVERIFY(!found);
        QCOMPARE(found.error().kind, ErrorKind::Cancelled);
    }

    /// The parameters' covariance, from 20000 draws of it.
    void deltas_haveTheCovariance()
    {
        const ChainSubject subject = m_chain->subject();
        const ModelDraws draws(subject, chainInputs(subject));
        const Eigen::MatrixXd &V = subject.model.draft.refinement->covariance;
        constexpr Index kDraws = 20000;
        Eigen::MatrixXd found = Eigen::MatrixXd::Zero(V.rows(), V.rows());
        for (Index i = 0; i < kDraws; ++i) {
            const Eigen::VectorXd one = draws.deltas(3, i);
            found += one * one.transpose() / static_cast<double>(kDraws);
        }
        const Eigen::VectorXd sd = V.diagonal().cwiseSqrt().cwiseInverse();
        const Eigen::MatrixXd rest = sd.asDiagonal() * (found - V) * sd.asDiagonal();
        QVERIFY2(rest.cwiseAbs().maxCoeff() < 0.05,
            qPrintable(QString::number(rest.cwiseAbs().maxCoeff())));
    }
};

DYNCAL_TEST(TestFullRefits)
#include "tst_full_refits.moc"

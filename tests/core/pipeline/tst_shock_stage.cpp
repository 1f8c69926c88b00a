// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/pipeline.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <chrono>
#include <cmath>

using namespace dyncal;

/// What is computed when, and from what: the shock stage of the pipeline.
class TestShockStage : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;

private slots:
    void initTestCase() { m_set = testing::simulatedExample(2e7); }

    void anotherOrder_takesReadingsFromTheRecordsAsTheyAre()
    {
        ResultCache cache;
        Recipe recipe;
        const auto before = runPipeline(m_set, recipe, cache, StageId::MonteCarlo).results;
        recipe.realization.order.value = 6;
        const auto after = runPipeline(m_set, recipe, cache, StageId::MonteCarlo).results;
        QVERIFY(before.shock && after.shock && before.monteCarlo && after.monteCarlo);
        QCOMPARE(after.starts.get(), before.starts.get());
        QCOMPARE(after.expected.get(), before.expected.get());
        QCOMPARE(after.shock->shots.size(), std::size_t(3));
        for (std::size_t i = 0; i < 3; ++i) {
            const ShockConditions &a = before.shock->shots[i], &b = after.shock->shots[i];
            QVERIFY(a.seen.at(0).found.has_value());
            QCOMPARE(b.seen.at(0).found->time_s, a.seen.at(0).found->time_s);
            // The onset, and so the velocity, is the model's.
            constexpr double kOnset = 1e-6; // relative: 1 ns of the 1.5 ms
            QVERIFY(std::abs(b.states->velocity_m_s / a.states->velocity_m_s - 1.0) < kOnset);
            QCOMPARE(b.measured.size(), a.measured.size());
        }
    }

    void shockStage_anew_readsNoRecord()
    {
        constexpr double kLimit_ms
            = 20.0; // 0.3 ms alone on a machine; 80 ms where records are read
        ResultCache cache;
        Recipe recipe;
        double best_ms = 1e9;
        for (const Index order : {2, 3, 4, 5, 6}) {
            recipe.realization.order.value = order;
            QVERIFY(!runPipeline(m_set, recipe, cache, StageId::Model).error);
            const auto begin = std::chrono::steady_clock::now();
            QVERIFY(runPipeline(m_set, recipe, cache, StageId::Shock).results.shock);
            const std::chrono::duration<double, std::milli> took
                = std::chrono::steady_clock::now() - begin;
            best_ms = std::min(best_ms, took.count());
        }
        qInfo("shock stage at another order: %.2f ms", best_ms);
        QVERIFY(best_ms < kLimit_ms);
    }

    void window_usesTheStartsFoundBefore()
    {
        ResultCache cache;
        const auto results = runPipeline(m_set, {}, cache, StageId::Window).results;
        for (const WindowedResponse &response : results.window->responses) {
            const Shot &shot
                = results.captures->set.shots[static_cast<std::size_t>(response.shot - 1)];
            const Channel *dut = shot.channelWithRole(ChannelRole::Dut);
            QCOMPARE(response.startSample, detectStart(*dut)->sample);
        }
    }

    void typedStart_standsInForTheDetectedOne()
    {
        ResultCache cache;
        Recipe recipe;
        const auto detected = runPipeline(m_set, recipe, cache, StageId::Window).results;
        for (const WindowedResponse &response : detected.window->responses)
            recipe.window.start_s.push_back(response.start_s);
        const auto typed = runPipeline(m_set, recipe, cache, StageId::Window).results;
        for (std::size_t i = 0; i < 3; ++i)
            QCOMPARE(*typed.expected->conditions.shots[i].plateau_s,
                *detected.expected->conditions.shots[i].plateau_s);
    }

    void monteCarlo_agreesWithPropagation_andDependsOnTheSeed()
    {
        ResultCache cache;
        Recipe recipe;
        recipe.uncertainty.monteCarloTrials = 2000;
        const auto results = runPipeline(m_set, recipe, cache, StageId::MonteCarlo).results;
        recipe.uncertainty.seed += 1;
        const auto other = runPipeline(m_set, recipe, cache, StageId::MonteCarlo).results;
        QCOMPARE(other.shock.get(), results.shock.get()); // nothing but the draws is new
        constexpr auto kStep = static_cast<Index>(StepResult::Step);
        for (const ShockConditions &shot : results.shock->shots) {
            const double u = shot.uncertainty->u(StepResult::Step).value();
            const auto &drawn = results.monteCarlo->ofShot(shot.shot)->outcome;
            QVERIFY(drawn.has_value());
            // sd of an sd from n draws: 1/sqrt(2 n); four of them.
            QVERIFY(std::abs(drawn->result.u[kStep] / u - 1.0) < 4.0 / std::sqrt(2.0 * 2000.0));
            QVERIFY(drawn->result.u[kStep]
                != other.monteCarlo->ofShot(shot.shot)->outcome->result.u[kStep]);
        }
        QVERIFY(results.monteCarlo->ofShot(9) == nullptr);
    }

    void monteCarlo_outsideTheRelations_isSaidAndTheRestStands()
    {
        ResultCache cache;
        Recipe recipe;
        recipe.uncertainty.budget = {{"t1_k", 60.0, "normal", {}}};
        recipe.uncertainty.monteCarloTrials = 1000;
        const auto outcome = runPipeline(m_set, recipe, cache, StageId::MonteCarlo);
        QVERIFY(!outcome.error);
        QVERIFY(!outcome.results.monteCarlo->ofShot(1)->outcome);
        QVERIFY(!outcome.results.monteCarlo->ofShot(1)->missing.empty());
        QCOMPARE(outcome.results.monteCarlo->findings.front().id, std::string("SHK-012"));
        QVERIFY(outcome.results.shock->shots[0].uncertainty->u(StepResult::Step));
    }

    void budgetOfAnUnknownQuantity_isSaidAndChangesNothing()
    {
        ResultCache cache;
        Recipe recipe;
        const auto plain = runPipeline(m_set, recipe, cache, StageId::Shock).results;
        recipe.uncertainty.budget = {{"T1_k", 5.0, "normal", {}}, {"delay", 1e-6, "normal", {}},
            {"attenuation_per_m", 1e-3, "normal", {}}};
        const auto misspelt = runPipeline(m_set, recipe, cache, StageId::Shock).results;
        QStringList sentences;
        for (const Finding &finding : misspelt.shock->findings) {
            if (finding.id == "SHK-013")
                sentences << QString::fromStdString(english(finding.message));
        }
        QCOMPARE(sentences.size(), qsizetype(3));
        QVERIFY2(sentences[0].contains("'T1_k'") && sentences[0].contains("'t1_k'"),
            qPrintable(sentences[0]));
        QVERIFY2(sentences[1].contains("'delay_s'"), qPrintable(sentences[1]));
        QVERIFY2(sentences[2].contains("shock.attenuation_per_m"), qPrintable(sentences[2]));
        for (std::size_t shot = 0; shot < 3; ++shot)
            QCOMPARE(misspelt.shock->shots[shot].uncertainty->u(StepResult::Step),
                plain.shock->shots[shot].uncertainty->u(StepResult::Step));
        // Each name that counts is used by some way of knowing the step.
        recipe.uncertainty.budget.clear();
        for (const std::string &name : statedQuantities())
            recipe.uncertainty.budget.push_back({name, 1e-9, "normal", {}});
        const auto known = runPipeline(m_set, recipe, cache, StageId::Shock).results;
        for (const Finding &finding : known.shock->findings)
            QVERIFY(finding.id != "SHK-013");
    }

    void correlationWithoutUse_isTold()
    {
        ResultCache cache;
        Recipe recipe;
        recipe.uncertainty.budget = {{"t1_k", 0.3}, {"p1_pa", 50.0}};
        recipe.uncertainty.correlations
            = {{"t1_k", "p1_pa", 0.5}, {"t1_k", "gamma", 0.5}, {"p1_pa", "p1_pa", 0.5}};
        const auto results = runPipeline(m_set, recipe, cache, StageId::Shock).results;
        QStringList sentences;
        for (const Finding &finding : results.shock->findings)
            if (finding.id == "SHK-013")
                sentences << QString::fromStdString(english(finding.message));
        QCOMPARE(sentences.size(), qsizetype(2));
        QVERIFY(sentences[0].contains("'gamma'") && sentences[1].contains("'p1_pa' with 'p1_pa'"));
        for (const BudgetLine &line : results.shock->shots[0].uncertainty->budget.lines)
            for (const Correlation &one : line.input.correlated)
                QVERIFY(one.quantity != line.input.quantity);
    }

    void uShapedQuantity_isDrawnAndNamedSo()
    {
        ResultCache cache;
        Recipe recipe;
        recipe.uncertainty.budget = {{"step_relative", 0.2, "u-shaped", {}}};
        recipe.uncertainty.monteCarloTrials = 4000;
        const auto results = runPipeline(m_set, recipe, cache, StageId::MonteCarlo).results;
        const auto &lines = results.shock->shots[0].uncertainty->budget.lines;
        QVERIFY(std::any_of(lines.begin(), lines.end(), [](const BudgetLine &line) {
            return line.input.distribution == Distribution::UShaped;
        }));
        // All else is small: an arcsine of 0.2 ends at sqrt(2) * 0.2, a normal one at 1.96 * 0.2.
        const auto &drawn = results.monteCarlo->ofShot(1)->outcome->result;
        constexpr auto kStep = static_cast<Index>(StepResult::Step);
        const double half = 0.5 * (drawn.high[kStep] - drawn.low[kStep]) / drawn.mean[kStep];
        QVERIFY2(half > 0.26 && half < 0.31, qPrintable(QString::number(half)));
    }

    void monteCarlo_tooFewTrials_isAMistakeInTheRecipe()
    {
        ResultCache cache;
        Recipe recipe;
        recipe.uncertainty.monteCarloTrials = 5;
        const auto outcome = runPipeline(m_set, recipe, cache, StageId::MonteCarlo);
        QVERIFY(outcome.error && outcome.error->kind == ErrorKind::Usage);
        QCOMPARE(outcome.failedStage, StageId::MonteCarlo);
        QVERIFY(outcome.results.response);
    }

    void switchedOff_nothingIsExpected()
    {
        ResultCache cache;
        Recipe recipe;
        recipe.shock.enabled = false;
        const auto results = runPipeline(m_set, recipe, cache, StageId::MonteCarlo).results;
        QVERIFY(results.expected->conditions.shots.empty());
        QVERIFY(results.shock->shots.empty() && results.monteCarlo->shots.empty());
    }

    void typedArrivals_perShot_moveThatShotOnly()
    {
        ResultCache cache;
        Recipe recipe;
        const auto found = runPipeline(m_set, recipe, cache, StageId::MonteCarlo).results;
        const auto &first = found.shock->shots[0];
        ArrivalSensor sensor{first.seen[0].channel, first.distance_m, 2e-4};
        sensor.shotArrival_s = {first.seen[0].found->time_s + 1e-6, std::nullopt, std::nullopt};
        recipe.shock.arrivalSensors = {sensor};
        const auto moved = runPipeline(m_set, recipe, cache, StageId::MonteCarlo).results;
        const auto velocity = [](const CalibrationResults &r, std::size_t i) {
            return r.shock->shots[i].states->velocity_m_s;
        };
        const double transit_s = first.distance_m / velocity(found, 0);
        QVERIFY(std::abs(velocity(moved, 0) / velocity(found, 0) - 1.0 - 1e-6 / transit_s) < 1e-5);
        // The first shot's window ends elsewhere now, and the model is of all shots.
        QVERIFY(std::abs(velocity(moved, 1) / velocity(found, 1) - 1.0) < 1e-7);
        // A cursor sees no better than the search, and the sensor is as slow.
        QCOMPARE(moved.shock->shots[0].sightings[0].u_time_s, first.sightings[0].u_time_s);
        QCOMPARE(moved.shock->shots[0].sightings[0].u_delay_s, first.sightings[0].u_delay_s);
    }

    void typedArrivals_ofAnotherNumberOfShots_areRefused()
    {
        ResultCache cache;
        Recipe recipe;
        ArrivalSensor sensor{"driven_side", 0.8, 2e-4};
        sensor.shotArrival_s = {1e-3, std::nullopt};
        recipe.shock.arrivalSensors = {sensor};
        const auto outcome = runPipeline(m_set, recipe, cache, StageId::MonteCarlo);
        QVERIFY(outcome.error && outcome.error->kind == ErrorKind::Usage);
        QVERIFY(
            english(outcome.error->message).find("2 arrivals for 3 shots") != std::string::npos);
    }
};

DYNCAL_TEST(TestShockStage)
#include "tst_shock_stage.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_assessing.h"
#include "tests/support/test_program.h"

#include "core/pipeline/model_stages.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/stage_table.h"
#include "core/results/results_json.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace dyncal;

namespace {

std::shared_ptr<const CaptureSet> simulated()
{
    SimulationSettings settings;
    settings.sensor = *sensorPreset("optic3");
    settings.duration_s = 0.004;
    settings.noise = 0.01;
    return std::make_shared<const CaptureSet>(simulateShots(settings)->set);
}

const std::shared_ptr<const CaptureSet> &captures()
{
    static const auto set = simulated();
    return set;
}

std::size_t at(StageId stage)
{
    return static_cast<std::size_t>(stage);
}

Recipe ofOrder(Index order)
{
    Recipe recipe;
    recipe.realization.order = order;
    return recipe;
}

CalibrationResults upTo(StageId last, const Recipe &recipe, ResultCache &cache)
{
    return runPipeline(captures(), recipe, cache, last).results;
}

bool hasFlag(const Pole &pole, const char *flag)
{
    return std::find(pole.flags.begin(), pole.flags.end(), flag) != pole.flags.end();
}

} // namespace

/// The stage behind the response that tells what the fitted model is worth.
class TestModelAssessment : public QObject
{
    Q_OBJECT

private slots:
    void fittedModel_saysNothingThatTheAssessmentMayChange()
    {
        ResultCache cache;
        const CalibrationResults results = upTo(StageId::Response, {}, cache);
        QVERIFY(results.model && results.response);
        const SensorModel &model = *results.model;
        QVERIFY(model.refined && !results.assessment);
        for (const Pole &pole : model.poles) {
            QVERIFY(std::isnan(pole.u_frequency_Hz) && std::isnan(pole.u_dampingRatio));
            QVERIFY(std::isnan(pole.coverageFactor));
            QVERIFY(!hasFlag(pole, kShotsDisagreeFlag) && !hasFlag(pole, "integrator"));
        }
        QCOMPARE(&polesOf(model, results.assessment.get()), &model.poles);
        QVERIFY(std::isfinite(model.series.front().u_plateauGain)); // does not wait for it
    }

    void assessment_isOfTheModelAndChangesNothingOfIt()
    {
        ResultCache cache;
        const auto fitted = upTo(StageId::Model, {}, cache).model;
        const CalibrationResults results = upTo(StageId::Assessment, {}, cache);
        QCOMPARE(results.model, fitted); // the same object
        QVERIFY(results.assessment);
        const ModelAssessment &found = *results.assessment;
        QCOMPARE(&polesOf(*fitted, &found), &found.poles);
        QCOMPARE(found.poles.size(), fitted->poles.size());
        for (std::size_t i = 0; i < found.poles.size(); ++i) {
            QVERIFY(found.poles[i].z == fitted->poles[i].z);
            QCOMPARE(found.poles[i].frequency_Hz, fitted->poles[i].frequency_Hz);
            QCOMPARE(found.poles[i].amplitude, fitted->poles[i].amplitude);
            QVERIFY(std::isfinite(found.poles[i].u_frequency_Hz));
        }
        QCOMPARE(found.perShot.size(), std::size_t(3));
        QVERIFY(found.homogeneity && found.secondOrder);
    }

    void mainPole_isTheSameOne_asFittedAndAsAssessed()
    {
        ResultCache cache;
        const CalibrationResults results = upTo(StageId::Assessment, {}, cache);
        const Pole *fitted = mainPole(*results.model, nullptr);
        const Pole *assessed = mainPole(*results.model, results.assessment.get());
        QVERIFY(fitted && assessed);
        QCOMPARE(assessed - results.assessment->poles.data(), fitted - results.model->poles.data());
        QVERIFY(std::isnan(fitted->u_frequency_Hz) && assessed->u_frequency_Hz > 0.0);
    }

    void stages_giveWhatOneCallGives_data()
    {
        QTest::addColumn<int>("order");
        for (const int order : {1, 2, 5, 14}) // misses the resonance, right, too high, not refined
            QTest::addRow("order %d", order) << order;
    }
    void stages_giveWhatOneCallGives()
    {
        QFETCH(int, order);
        const Recipe recipe = ofOrder(order);
        ResultCache cache;
        PipelineOutcome staged = runPipeline(captures(), recipe, cache, StageId::Evidence);
        QVERIFY(!staged.error && staged.results.assessment);
        PipelineOutcome whole = staged;
        const CalibrationResults before = upTo(StageId::Decomposition, recipe, cache);
        const auto fitted = modelStage(before, recipe, order, {});
        QVERIFY(fitted);
        whole.results.model = std::make_shared<const SensorModel>(*fitted);
        whole.results.assessment = std::make_shared<const ModelAssessment>(
            assessModel(*before.input, *fitted, recipe.realization).value());
        QCOMPARE(resultsJson(whole, recipe, "t"), resultsJson(staged, recipe, "t"));
    }

    void knownAssessment_isThereAtOnce()
    {
        ResultCache cache;
        const auto complete
            = runPipeline(captures(), {}, cache, StageId::Evidence).results.assessment;
        QVERIFY(complete);
        QCOMPARE(upTo(StageId::Model, {}, cache).assessment, complete);
        QCOMPARE(upTo(StageId::Response, {}, cache).assessment, complete);
        // Never without its model, and never beside another.
        QVERIFY(!upTo(StageId::Decomposition, {}, cache).assessment);
        QVERIFY(!upTo(StageId::Response, ofOrder(3), cache).assessment);
    }

    void keys_followTheModelOnly()
    {
        ResultCache cache;
        Recipe recipe;
        const auto complete = runPipeline(captures(), recipe, cache, StageId::Evidence).results;
        recipe.response.grid = "linear";
        const auto other = runPipeline(captures(), recipe, cache, StageId::Evidence).results;
        QVERIFY(other.response != complete.response);
        QCOMPARE(other.keys[at(StageId::Assessment)], complete.keys[at(StageId::Assessment)]);
        QCOMPARE(other.model, complete.model);
        QCOMPARE(other.assessment, complete.assessment);
        const auto refitted = runPipeline(captures(), ofOrder(3), cache, StageId::Evidence).results;
        QVERIFY(refitted.keys[at(StageId::Assessment)] != complete.keys[at(StageId::Assessment)]);
    }

    void cancelled_givesNoHalfAssessment()
    {
        ResultCache cache;
        const CalibrationResults before = upTo(StageId::Model, {}, cache);
        std::stop_source stop;
        stop.request_stop();
        const auto assessed = assessModel(*before.input, *before.model, {}, {stop.get_token(), {}});
        QVERIFY(!assessed);
        QCOMPARE(assessed.error().kind, ErrorKind::Cancelled);

        // Stopped once response and checks are there: the next run finds nothing of it.
        std::stop_source late;
        const JobControl control{late.get_token(), [&late](double done) {
                                     if (done >= progressAfter(StageId::Checks, kLastStage))
                                         late.request_stop();
                                 }};
        const PipelineOutcome outcome = runPipeline(captures(), {}, cache, kLastStage, control);
        QVERIFY(outcome.error);
        QCOMPARE(outcome.error->kind, ErrorKind::Cancelled);
        QCOMPARE(outcome.failedStage, StageId::Assessment);
        QVERIFY(outcome.results.response && !outcome.results.assessment);
        QVERIFY(upTo(StageId::Assessment, {}, cache).assessment);
    }

    void findings_ofTheAssessment_standRightBehindTheModels()
    {
        ResultCache cache;
        CalibrationResults results
            = runPipeline(captures(), ofOrder(4), cache, StageId::Evidence).results;
        const Finding model{
            .id = "MOD-005", .severity = Severity::Info, .message = {"of the model", {}}};
        const Finding found{
            .id = "MOD-010", .severity = Severity::Caution, .message = {"of the assessment", {}}};
        SensorModel fitted = *results.model;
        fitted.findings.push_back(model);
        ModelAssessment assessment = *results.assessment;
        assessment.findings.insert(assessment.findings.begin(), found);
        results.model = std::make_shared<const SensorModel>(fitted);
        results.assessment = std::make_shared<const ModelAssessment>(assessment);
        const auto isFound = [](const Finding &finding) {
            return english(finding.message) == "of the assessment";
        };
        const Findings all = allFindings(results);
        QCOMPARE(std::ranges::count_if(all, isFound), std::ptrdiff_t(1));
        const auto at = std::ranges::find_if(all, isFound);
        QVERIFY(at != all.begin());
        QCOMPARE(english(std::prev(at)->message), std::string("of the model"));
        for (const Findings *each : {&fitted.findings, &assessment.findings})
            for (const Finding &finding : *each)
                QVERIFY(std::ranges::count(all, finding.id, &Finding::id)
                    >= std::ranges::count(*each, finding.id, &Finding::id));
        results.assessment = nullptr;
        const Findings before = allFindings(results);
        QVERIFY(std::ranges::none_of(before, isFound));
    }
};

DYNCAL_TEST(TestModelAssessment)
#include "tst_model_assessment.moc"

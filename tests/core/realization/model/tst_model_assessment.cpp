// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/model_assessment.h"
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

/// The stage behind the response that completes the fitted model.
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
        QVERIFY(model.refined && !model.isAssessed);
        for (const Pole &pole : model.poles) {
            QVERIFY(std::isnan(pole.u_frequency_Hz) && std::isnan(pole.u_dampingRatio));
            QVERIFY(std::isnan(pole.coverageFactor));
            QVERIFY(!hasFlag(pole, kShotsDisagreeFlag) && !hasFlag(pole, "integrator"));
        }
        QVERIFY(model.perShot.empty() && model.perLevel.empty());
        QVERIFY(!model.homogeneity && !model.secondOrder && !model.nuisanceEffect);
        QVERIFY(std::isfinite(model.series.front().u_plateauGain)); // does not wait for it
    }

    void assessment_addsAndChangesNothingOfTheFit()
    {
        ResultCache cache;
        const auto fitted = upTo(StageId::Model, {}, cache).model;
        const CalibrationResults results = upTo(StageId::Assessment, {}, cache);
        const SensorModel &model = *results.model;
        QVERIFY(model.isAssessed);
        QCOMPARE(model.order, fitted->order);
        QCOMPARE(model.fit_percent, fitted->fit_percent);
        QCOMPARE(model.poles.size(), fitted->poles.size());
        for (std::size_t i = 0; i < model.poles.size(); ++i) {
            QVERIFY(model.poles[i].z == fitted->poles[i].z);
            QVERIFY(std::isfinite(model.poles[i].u_frequency_Hz));
        }
        QVERIFY(model.zeros == fitted->zeros);
        QVERIFY(model.series.front().simulated == fitted->series.front().simulated);
        QCOMPARE(model.perShot.size(), std::size_t(3));
        QVERIFY(model.homogeneity && model.secondOrder);
        // What it finds comes after what the fit had found.
        QVERIFY(model.findings.size() >= fitted->findings.size());
        for (std::size_t i = 0; i < fitted->findings.size(); ++i)
            QCOMPARE(model.findings[i].id, fitted->findings[i].id);
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
        PipelineOutcome staged = runPipeline(captures(), recipe, cache);
        QVERIFY(!staged.error && staged.results.model->isAssessed);
        PipelineOutcome whole = staged;
        const CalibrationResults before = upTo(StageId::Decomposition, recipe, cache);
        const auto fitted = modelStage(before, recipe, order, {});
        QVERIFY(fitted && !fitted->isAssessed);
        whole.results.model = std::make_shared<const SensorModel>(
            assessModel(*before.input, *fitted, recipe.realization).value());
        QCOMPARE(resultsJson(whole, recipe, "t"), resultsJson(staged, recipe, "t"));
    }

    void knownAssessment_isThereAtOnce()
    {
        ResultCache cache;
        const auto complete = runPipeline(captures(), {}, cache).results.model;
        QCOMPARE(upTo(StageId::Model, {}, cache).model, complete);
        QCOMPARE(upTo(StageId::Response, {}, cache).model, complete);
    }

    void keys_followTheModelOnly()
    {
        ResultCache cache;
        Recipe recipe;
        const auto complete = runPipeline(captures(), recipe, cache).results;
        recipe.response.grid = "linear";
        const auto other = runPipeline(captures(), recipe, cache).results;
        QVERIFY(other.response != complete.response);
        QCOMPARE(other.keys[at(StageId::Assessment)], complete.keys[at(StageId::Assessment)]);
        QCOMPARE(other.model, complete.model);
        const auto refitted = runPipeline(captures(), ofOrder(3), cache).results;
        QVERIFY(refitted.keys[at(StageId::Assessment)] != complete.keys[at(StageId::Assessment)]);
    }

    void cancelled_givesNoHalfAssessedModel()
    {
        ResultCache cache;
        const CalibrationResults before = upTo(StageId::Model, {}, cache);
        std::stop_source stop;
        stop.request_stop();
        const auto assessed = assessModel(*before.input, *before.model, {}, {stop.get_token(), {}});
        QVERIFY(!assessed);
        QCOMPARE(assessed.error().kind, ErrorKind::Cancelled);

        // Stopped once the response is there: the next run finds nothing of it.
        std::stop_source late;
        const JobControl control{
            late.get_token(), [&late](double done) {
                if (done >= progressAfter(StageId::Response, kLastStage))
                    late.request_stop();
            }};
        const PipelineOutcome outcome = runPipeline(captures(), {}, cache, kLastStage, control);
        QVERIFY(outcome.error);
        QCOMPARE(outcome.error->kind, ErrorKind::Cancelled);
        QCOMPARE(outcome.failedStage, StageId::Assessment);
        QVERIFY(outcome.results.response && !outcome.results.model->isAssessed);
        QVERIFY(upTo(StageId::Assessment, {}, cache).model->isAssessed);
    }

    void findings_ofTheAssessment_standWithTheModels()
    {
        ResultCache cache;
        const CalibrationResults results = runPipeline(captures(), ofOrder(4), cache).results;
        const Findings all = allFindings(results);
        for (const Finding &finding : results.model->findings)
            QCOMPARE(std::ranges::count(all, finding.id, &Finding::id),
                std::ranges::count(results.model->findings, finding.id, &Finding::id));
    }
};

DYNCAL_TEST(TestModelAssessment)
#include "tst_model_assessment.moc"

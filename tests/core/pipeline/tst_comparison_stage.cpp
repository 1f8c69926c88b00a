// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Comparison calibration end to end: against the transducer, against both, and what is refused.

#include "core/pipeline/pipeline.h"
#include "core/pipeline/stage_keys.h"
#include "core/results/results_json.h"
#include "tests/support/near.h"
#include "tests/support/reference_capture.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <nlohmann/json.hpp>

#include <cmath>

using namespace dyncal;
using testing::isNear;

class TestComparisonStage : public QObject
{
    Q_OBJECT

private:
    std::shared_ptr<const CaptureSet> m_set;

    PipelineOutcome run(const Recipe &recipe, StageId last = StageId::Comparison) const
    {
        ResultCache cache;
        return runPipeline(m_set, recipe, cache, last);
    }

    static Recipe compared(const char *reference)
    {
        Recipe recipe;
        recipe.comparison = testing::referenceComparison();
        recipe.response.reference = reference;
        return recipe;
    }

private slots:
    void initTestCase() { m_set = testing::referenceCapture(); }

    void unlessAskedFor_nothingIsCompared()
    {
        const PipelineOutcome outcome = run({});
        QVERIFY(!outcome.results.comparison->byTransducer);
        QVERIFY(!outcome.results.reference->records);
        QVERIFY(!outcome.results.response->isByTransducer);
    }

    void besideTheStep_bothAgree()
    {
        const PipelineOutcome outcome = run(compared("computed-step"));
        QVERIFY(!outcome.error);
        const ComparisonResult &found = *outcome.results.comparison;
        QVERIFY(found.byTransducer && found.againstStep);
        QVERIFY(std::abs(found.againstStep->meanE_n()) < 1.0);
        QVERIFY(std::abs(found.againstStep->difference_relative) < 0.02);
        QVERIFY(found.findings.empty());
        QVERIFY(!outcome.results.response->isByTransducer);
        const double truth = sensorPreset("optic3").value().sensitivity_V_Pa;
        QVERIFY(isNear(found.byTransducer->response.magnitude[2], truth, 0.005));
    }

    void wrongCertificate_isTold()
    {
        Recipe recipe = compared("computed-step");
        recipe.comparison.model->sensitivity *= 1.05;
        const PipelineOutcome outcome = run(recipe);
        const Findings &findings = outcome.results.comparison->findings;
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings[0].id, std::string("CMP-001"));
    }

    /// The onset of both records is known: a delay of the wrong sign is not taken without a word.
    void wrongDelay_isTold()
    {
        for (const double wrong_s : {-2e-6, 5e-8}) {
            Recipe recipe = compared("transducer");
            recipe.comparison.delay_s = wrong_s;
            const Findings findings = run(recipe).results.comparison->findings;
            QCOMPARE(findings.size(), std::size_t(1));
            QCOMPARE(findings[0].id, std::string("CMP-005"));
            recipe.comparison.u_delay_s = std::abs(wrong_s);
            QVERIFY(run(recipe).results.comparison->findings.empty());
        }
    }

    /// No shock physics is needed: without it the same values.
    void againstTheTransducer_withoutTheShock()
    {
        Recipe recipe = compared("transducer");
        const PipelineOutcome with = run(recipe);
        recipe.shock.enabled = false;
        const PipelineOutcome without = run(recipe);
        QVERIFY(!with.error && !without.error);
        const ResponseResult &a = *with.results.response, &b = *without.results.response;
        QVERIFY(a.isByTransducer && b.isByTransducer);
        QCOMPARE(a.magnitude, b.magnitude);
        QCOMPARE(a.unit, std::string("V/Pa"));
        QVERIFY(without.results.uncertainty->rows.isComplete());
        QVERIFY(without.results.uncertainty->sensitivity->u);
        QVERIFY(!without.results.comparison->againstStep);
        QVERIFY(with.results.comparison->againstStep);
        const double truth = sensorPreset("optic3").value().sensitivity_V_Pa;
        const ReportedValue &s = *without.results.uncertainty->sensitivity;
        QVERIFY(std::abs(s.value - truth) < s.k * *s.u);
    }

    /// Whichever of the two the response is, the comparison says the same.
    void comparison_doesNotDependOnTheResponsesReference()
    {
        const auto a = run(compared("transducer")).results.comparison;
        const auto b = run(compared("computed-step")).results.comparison;
        QCOMPARE(a->byTransducer->response.magnitude, b->byTransducer->response.magnitude);
        QCOMPARE(a->byStep->response.magnitude, b->byStep->response.magnitude);
        QVERIFY(!a->byStep->response.isByTransducer && a->byTransducer->response.isByTransducer);
        QCOMPARE(a->againstStep->difference_relative, b->againstStep->difference_relative);
        QCOMPARE(a->againstStep->u_relative, b->againstStep->u_relative);
    }

    void whatCannotBeCompared_isRefused()
    {
        Recipe recipe;
        recipe.response.reference = "transducer";
        QCOMPARE(run(recipe).error->kind, ErrorKind::Usage);
        recipe = compared("computed-step");
        recipe.input.treatment = ResponseTreatment::Impulse;
        QCOMPARE(run(recipe).error->kind, ErrorKind::Usage);
        recipe = compared("computed-step");
        recipe.comparison.source = "x.csv";
        QCOMPARE(run(recipe).error->kind, ErrorKind::Usage); // model and source
    }

    void results_holdTheTransducersResponse()
    {
        const Recipe recipe = compared("computed-step");
        const auto json = nlohmann::json::parse(resultsJson(run(recipe), recipe, "now"));
        const auto &section = json.at("comparison");
        QCOMPARE(section.at("source").get<std::string>(), std::string("transducer"));
        QCOMPARE(json.at("response").at("source").get<std::string>(), std::string("step"));
        QCOMPARE(section.at("channel").get<std::string>(), std::string("Reference"));
        const std::size_t rows = section.at("frequency_hz").size();
        for (const char *key :
            {"magnitude", "u_magnitude", "k_magnitude", "phase_rad", "u_phase_rad",
                "covariance_re_im", "e_n", "e_n_step", "bound_end", "withheld_reason"})
            QCOMPARE(section.at(key).size(), rows);
        QVERIFY(section.at("u_contains_step").get<bool>());
        const auto none = nlohmann::json::parse(resultsJson(run({}), {}, "now"));
        QVERIFY(none.at("comparison").is_null() && none.contains("comparison_reason"));
    }

    void stageKeys_changeWithTheFile()
    {
        Recipe recipe = compared("computed-step");
        recipe.comparison.model.reset();
        recipe.comparison.source = "x.csv";
        recipe.comparison.loaded
            = std::make_shared<const ReferenceSource>(ReferenceSource{"1", ""});
        const auto before = stageKeys(*m_set, recipe);
        recipe.comparison.loaded
            = std::make_shared<const ReferenceSource>(ReferenceSource{"2", ""});
        const auto after = stageKeys(*m_set, recipe);
        const auto at = [](StageId id) { return static_cast<std::size_t>(id); };
        QVERIFY(before[at(StageId::Reference)] != after[at(StageId::Reference)]);
        QCOMPARE(before[at(StageId::Shock)], after[at(StageId::Shock)]);
    }
};

DYNCAL_TEST(TestComparisonStage)
#include "tst_comparison_stage.moc"

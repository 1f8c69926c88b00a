// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/session/results_on_show.h"

#include <QtTest>

using namespace dyncal;

namespace {

/// Results up to a stage; the keys are the name of the run.
PipelineOutcome runUpTo(StageId last, const std::string &name, Index order)
{
    PipelineOutcome outcome;
    CalibrationResults &results = outcome.results;
    results.keys.fill(name); // the pipeline gives all keys
    results.captures = std::make_shared<const PreparedCaptures>();
    if (last >= StageId::Model) {
        auto model = std::make_shared<SensorModel>();
        model->order = order;
        results.model = model;
    }
    if (last >= StageId::Response)
        results.response = std::make_shared<const ResponseResult>();
    if (last >= StageId::Assessment) {
        auto assessment = std::make_shared<ModelAssessment>();
        assessment->findings.push_back(
            {.id = "MOD-010", .severity = Severity::Caution, .message = {"Of %1.", {name}}});
        results.assessment = assessment;
    }
    if (last >= StageId::Uncertainty)
        results.uncertainty = std::make_shared<const UncertaintyReport>();
    return outcome;
}

std::shared_ptr<const ResponseResult> curve()
{
    return std::make_shared<const ResponseResult>();
}

} // namespace

class TestResultsOnShow : public QObject
{
    Q_OBJECT

private slots:
    void part_keepsWhatHasNotComeYet_andSaysSo();
    void whole_isUpToDate_unlessANewerWaits();
    void firstTriplets_areNeverUpToDate();
    void failure_ofAnEarlierRun_isGoneWithItsStage();
    void modelCurve_standsForTheResponse_untilItComes();
    void assessment_isNeverBesideAnotherModel();
    void assessment_remembered_comesWithItsModel();
    void budget_isNeverBesideAnotherResponse();
    void failure_leavesTheLastGoodOnShow_neverAmongTheResults();
};

void TestResultsOnShow::part_keepsWhatHasNotComeYet_andSaysSo()
{
    ResultsOnShow shown;
    shown.take(runUpTo(kLastStage, "first", 2), false);
    QVERIFY(shown.areUpToDate());
    shown.markStaleFrom(StageId::Model);
    QVERIFY(!shown.areUpToDate());
    shown.takePart(runUpTo(StageId::Shock, "second", 3).results, StageId::Shock, false, false);
    QCOMPARE(shown.run().results.model->order, Index(3));
    QVERIFY(shown.run().results.response); // of the first
    QVERIFY(shown.isOfThisRun(StageId::Model));
    QVERIFY(!shown.isOfThisRun(StageId::Response));
    QCOMPARE(shown.keyOf(StageId::Response), std::string("first"));
    QCOMPARE(shown.keys()[static_cast<std::size_t>(StageId::Response)], std::string("first"));
    QCOMPARE(shown.keys()[static_cast<std::size_t>(StageId::Shock)], std::string("second"));
    QCOMPARE(shown.run().firstStale, static_cast<int>(StageId::Shock) + 1);
}

void TestResultsOnShow::failure_leavesTheLastGoodOnShow_neverAmongTheResults()
{
    ResultsOnShow shown;
    shown.take(runUpTo(kLastStage, "first", 2), false);
    QVERIFY(!shown.isLastGood(StageId::Model));
    PipelineOutcome failed = runUpTo(StageId::Window, "second", 0);
    failed.error = Error{ErrorKind::DataBlocked, {"No step.", {}}, "CAP-009", 1};
    failed.failedStage = StageId::Window;
    shown.take(failed, false);
    QVERIFY(!shown.run().results.model); // what is exported
    QCOMPARE(shown.withLastGood().model->order, Index(2));
    QVERIFY(shown.withLastGood().assessment);
    QVERIFY(shown.isLastGood(StageId::Model) && shown.isLastGood(StageId::Response));
    QVERIFY(!shown.isLastGood(StageId::Captures)); // that one is of this run
    QVERIFY(!shown.isLastGood(StageId::Spectrum)); // there never was one
    QVERIFY(!shown.isOfThisRun(StageId::Model));
    QVERIFY(shown.response());
    QCOMPARE(shown.status(StageId::Model), StageStatus::Blocked);
    for (const Finding &finding : shown.findings())
        QVERIFY(finding.id != "MOD-010"); // of a model that is out of date

    shown.take(failed, false); // a second failure loses nothing
    QCOMPARE(shown.withLastGood().model->order, Index(2));
    shown.take(runUpTo(kLastStage, "third", 4), false);
    QVERIFY(!shown.isLastGood(StageId::Model));
    QCOMPARE(shown.withLastGood().model->order, Index(4));

    shown.take(failed, false);
    shown.forgetLastGood(); // other recordings
    QVERIFY(!shown.withLastGood().model);
    QVERIFY(!shown.isLastGood(StageId::Model));
}

void TestResultsOnShow::whole_isUpToDate_unlessANewerWaits()
{
    ResultsOnShow shown;
    shown.markStaleFrom(StageId::Captures);
    shown.setComputing(true);
    shown.take(runUpTo(kLastStage, "first", 2), true);
    QVERIFY(shown.run().computing);
    QVERIFY(!shown.areUpToDate());
    shown.take(runUpTo(kLastStage, "second", 2), false);
    QVERIFY(shown.areUpToDate());
}

void TestResultsOnShow::firstTriplets_areNeverUpToDate()
{
    ResultsOnShow shown;
    shown.markStaleFrom(StageId::Captures);
    shown.takePart(runUpTo(kLastStage, "first", 2).results, StageId::Evidence, true, false);
    QVERIFY(shown.areFirstTriplets());
    QCOMPARE(shown.run().firstStale, static_cast<int>(StageId::Decomposition));
    shown.take(runUpTo(kLastStage, "whole", 2), false);
    QVERIFY(!shown.areFirstTriplets());
    shown.clear();
    QVERIFY(!shown.run().results.model);
}

void TestResultsOnShow::failure_ofAnEarlierRun_isGoneWithItsStage()
{
    ResultsOnShow shown;
    PipelineOutcome failed = runUpTo(StageId::Captures, "first", 0);
    failed.error = Error{ErrorKind::DataBlocked, {"No step.", {}}, {}, 1};
    failed.failedStage = StageId::Window;
    shown.take(failed, false);
    QCOMPARE(shown.findings().size(), std::size_t(1));
    QCOMPARE(shown.findings().front().severity, Severity::Block);
    shown.takePart(
        runUpTo(StageId::Captures, "second", 0).results, StageId::Expected, false, false);
    QVERIFY(shown.run().error);
    shown.takePart(runUpTo(StageId::Captures, "second", 0).results, StageId::Window, false, false);
    QVERIFY(!shown.run().error);
}

void TestResultsOnShow::modelCurve_standsForTheResponse_untilItComes()
{
    ResultsOnShow shown;
    QVERIFY(!shown.response());
    shown.take(runUpTo(kLastStage, "first", 2), false);
    const auto first = shown.run().results.response;
    QCOMPARE(shown.response(), first);
    // Within a drag the old response is of another model.
    const auto drawn = curve();
    shown.setModelCurve(drawn, "second");
    shown.takePart(runUpTo(StageId::Shock, "second", 3).results, StageId::Shock, false, false);
    QCOMPARE(shown.response(), drawn);
    const auto second = runUpTo(StageId::Response, "second", 3).results;
    shown.takePart(second, StageId::Response, false, false);
    QCOMPARE(shown.response(), second.response);
    // The curve of one run is not shown in another.
    shown.setModelCurve(curve(), "third");
    shown.takePart(runUpTo(StageId::Shock, "fourth", 4).results, StageId::Shock, false, false);
    QVERIFY(!shown.response());
}

void TestResultsOnShow::assessment_isNeverBesideAnotherModel()
{
    ResultsOnShow shown;
    shown.take(runUpTo(kLastStage, "first", 2), false);
    QVERIFY(shown.isOfThisRun(StageId::Assessment));
    QCOMPARE(shown.findings().size(), std::size_t(1));
    // Nothing of the model has come yet: both stay, and are of the earlier run.
    shown.markStaleFrom(StageId::Window);
    shown.takePart(
        runUpTo(StageId::Decomposition, "second", 3).results, StageId::Decomposition, false, false);
    QVERIFY(shown.run().results.model && shown.run().results.assessment);
    QVERIFY(!shown.isOfThisRun(StageId::Assessment));
    QVERIFY(shown.findings().empty());
    // With the new model the old one's assessment is gone, and so is what it found.
    shown.takePart(
        runUpTo(StageId::Response, "second", 3).results, StageId::Response, false, false);
    QCOMPARE(shown.run().results.model->order, Index(3));
    QVERIFY(!shown.run().results.assessment);
    QVERIFY(!shown.isOfThisRun(StageId::Assessment));
    QVERIFY(shown.findings().empty());
    shown.takePart(
        runUpTo(StageId::Assessment, "second", 3).results, StageId::Assessment, false, false);
    QVERIFY(shown.run().results.assessment && shown.isOfThisRun(StageId::Assessment));
    QCOMPARE(english(shown.findings().front().message), std::string("Of second."));
}

void TestResultsOnShow::assessment_remembered_comesWithItsModel()
{
    ResultsOnShow shown;
    shown.take(runUpTo(kLastStage, "first", 2), false);
    CalibrationResults part = runUpTo(StageId::Model, "second", 3).results;
    part.assessment = runUpTo(StageId::Assessment, "second", 3).results.assessment;
    shown.takePart(part, StageId::Model, false, false);
    QCOMPARE(shown.run().results.assessment, part.assessment);
    QVERIFY(shown.isOfThisRun(StageId::Assessment));
    QVERIFY(!shown.isOfThisRun(StageId::Response));
}

void TestResultsOnShow::budget_isNeverBesideAnotherResponse()
{
    ResultsOnShow shown;
    shown.take(runUpTo(kLastStage, "first", 2), false);
    QVERIFY(shown.run().results.uncertainty);
    shown.takePart(
        runUpTo(StageId::Decomposition, "second", 3).results, StageId::Decomposition, false, false);
    QVERIFY(shown.run().results.uncertainty); // with the response it belongs to
    shown.takePart(
        runUpTo(StageId::Response, "second", 3).results, StageId::Response, false, false);
    QVERIFY(!shown.run().results.uncertainty && !shown.withLastGood().uncertainty);
    shown.takePart(
        runUpTo(StageId::Uncertainty, "second", 3).results, StageId::Uncertainty, false, false);
    QVERIFY(shown.run().results.uncertainty && shown.isOfThisRun(StageId::Uncertainty));
}

DYNCAL_TEST(TestResultsOnShow)
#include "tst_results_on_show.moc"

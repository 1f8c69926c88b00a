// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/sensor_outcome.h"
#include "core/results/results_json.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/writable_result.h"

#include <QtTest>

using namespace dyncal;
using dyncal::testing::writable;

namespace {

PipelineOutcome exampleOutcome()
{
    PipelineOutcome outcome;
    outcome.results = example::calibration();
    return outcome;
}

SensorOutcome wholeRecord()
{
    SensorOutcome record;
    record.key = std::string(64, 'c');
    record.state = SensorState::Cautions;
    record.reason = "A \"reason\"\nof two lines.";
    record.results = {{"sensitivity", 5.1e-6, "V/Pa", 1.0 / 3.0, 2.0}, {"f0_hz", 3e5, "Hz"},
        {"damping_ratio", 0.02, ""}};
    record.findings = {{"CAP-017", Severity::Info, 0}, {"WIN-001", Severity::Caution, 2},
        {"CAP-002", Severity::Block, 1}};
    record.stamps = {{209128, 1795702379140883154}, {0, 0}};
    record.said = {"%1: %M1", {"WIN-001"}, {{"Shot %1 is \"strange\".", {"2"}}}};
    return record;
}

const StatedResult *found(const SensorOutcome &record, const char *quantity)
{
    const auto at = std::ranges::find(record.results, quantity, &StatedResult::quantity);
    return at == record.results.end() ? nullptr : &*at;
}

void addFinding(PipelineOutcome &outcome, Severity severity)
{
    writable(outcome.results.window)
        .findings.push_back({.id = "WIN-001",
            .severity = severity,
            .shot = 2,
            .message = {"Shot %1 is strange.", {"2"}}});
}

std::string replaced(std::string text, const std::string &from, const std::string &to)
{
    const std::size_t at = text.find(from);
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

} // namespace

/// What a batch keeps of a sensor.
class TestBatchRecord : public QObject
{
    Q_OBJECT

private slots:
    void text_readsBackAsTheSameRecord();
    void text_ofEveryState();
    void text_thatIsNoRecord_data();
    void text_thatIsNoRecord();
    void record_statesWhatTheReportStates();
    void record_withoutCompleteBudget_hasNoU();
    void record_ofAValueThatIsNotDetermined_leavesItOut();
    void record_hasTheFindingsOfResultsJson();
    void record_stateFollowsTheGravestFinding();
    void record_ofWhatBlocks_statesNoResult();
    void record_ofAStoppedRun_hasTheError();
};

void TestBatchRecord::text_readsBackAsTheSameRecord()
{
    const SensorOutcome record = wholeRecord();
    const auto read = parseRecord(recordText(record));
    QVERIFY(read);
    QVERIFY(*read == record);
    QVERIFY(parseRecord(recordText(SensorOutcome())) == SensorOutcome());
}

void TestBatchRecord::text_ofEveryState()
{
    for (int i = 0; i < kSensorStates; ++i) {
        SensorOutcome record;
        record.state = static_cast<SensorState>(i);
        const auto read = parseRecord(recordText(record));
        QVERIFY(read);
        QCOMPARE(read->state, record.state);
    }
    QCOMPARE(QByteArray(sensorStateName(SensorState::Cautions)), QByteArray("cautions"));
    QCOMPARE(QByteArray(sensorStateName(SensorState::Missing)), QByteArray("missing"));
}

void TestBatchRecord::text_thatIsNoRecord_data()
{
    QTest::addColumn<QByteArray>("text");
    const std::string text = recordText(wholeRecord());
    const auto row = [&](const char *name, const std::string &from, const std::string &to) {
        QVERIFY(text.find(from) != std::string::npos);
        QTest::newRow(name) << QByteArray::fromStdString(replaced(text, from, to));
    };
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("half") << QByteArray::fromStdString(text.substr(0, text.size() / 2));
    QTest::newRow("list") << QByteArray("[]");
    row("schema", "dyncal-batch-record/1", "dyncal-batch-record/9");
    row("state", "\"cautions\"", "\"perhaps\"");
    row("severity", "\"caution\"", "\"doubt\"");
    row("no key", "\"key\"", "\"lock\"");
    row("value is a text", "\"value\": 0.02", "\"value\": \"0.02\"");
    row("shot is a text", "\"shot\": 2", "\"shot\": \"2\"");
    row("message is a text", "\"message\": {", "\"message\": \"x\", \"y\": {");
    row("message without a text", "\"text\"", "\"words\"");
    row("no stamps", "\"inputs\"", "\"input\"");
    row("results are an object", "\"results\": [", "\"results\": 3, \"x\": [");
}

void TestBatchRecord::text_thatIsNoRecord()
{
    QFETCH(QByteArray, text);
    QVERIFY(!parseRecord(text.toStdString()));
}

void TestBatchRecord::record_statesWhatTheReportStates()
{
    const PipelineOutcome outcome = exampleOutcome();
    const SensorOutcome record = recordOf(outcome, "key");
    QCOMPARE(record.key, std::string("key"));
    const UncertaintyReport &report = *outcome.results.uncertainty;
    QVERIFY(!report.ofModel.empty());
    for (const ReportedValue &stated : report.ofModel) {
        const StatedResult *result = found(record, stated.of.c_str());
        QVERIFY2(result, stated.of.c_str());
        QCOMPARE(result->value, stated.value);
        QCOMPARE(result->unit, stated.unit);
        QCOMPARE(result->expanded, stated.expanded());
        QCOMPARE(result->k.has_value(), stated.u.has_value());
    }
    const StatedResult *sensitivity = found(record, "sensitivity");
    QVERIFY(sensitivity);
    QCOMPARE(sensitivity->value, *outcome.results.response->sensitivity);
    QCOMPARE(sensitivity->unit, outcome.results.response->sensitivityUnit);
}

/// U is complete or absent; a value without it stays.
void TestBatchRecord::record_withoutCompleteBudget_hasNoU()
{
    PipelineOutcome outcome = exampleOutcome();
    UncertaintyReport &report = writable(outcome.results.uncertainty);
    report.sensitivity = std::nullopt;
    for (ReportedValue &value : report.ofModel)
        value.u = std::nullopt;
    const SensorOutcome record = recordOf(outcome, "key");
    QVERIFY(found(record, "sensitivity"));
    for (const StatedResult &result : record.results)
        QVERIFY(!result.expanded && !result.k);
    outcome.results.uncertainty = nullptr;
    QCOMPARE(recordOf(outcome, "key").results.size(), std::size_t(1));
}

void TestBatchRecord::record_ofAValueThatIsNotDetermined_leavesItOut()
{
    PipelineOutcome outcome = exampleOutcome();
    UncertaintyReport &report = writable(outcome.results.uncertainty);
    report.ofModel.front().value = std::numeric_limits<double>::quiet_NaN();
    writable(outcome.results.response).sensitivity = std::nullopt;
    const SensorOutcome record = recordOf(outcome, "key");
    QVERIFY(!found(record, report.ofModel.front().of.c_str()));
    QVERIFY(!found(record, "sensitivity"));
    QVERIFY(parseRecord(recordText(record)) == record);
}

void TestBatchRecord::record_hasTheFindingsOfResultsJson()
{
    PipelineOutcome outcome = exampleOutcome();
    addFinding(outcome, Severity::Caution);
    const Findings findings = allFindings(outcome);
    const SensorOutcome record = recordOf(outcome, "key");
    QCOMPARE(record.findings.size(), findings.size());
    for (std::size_t i = 0; i < findings.size(); ++i) {
        QCOMPARE(record.findings[i].id, findings[i].id);
        QCOMPARE(record.findings[i].severity, findings[i].severity);
        QCOMPARE(record.findings[i].shot, findings[i].shot);
    }
}

void TestBatchRecord::record_stateFollowsTheGravestFinding()
{
    PipelineOutcome outcome = exampleOutcome();
    const bool isQuiet = worstSeverity(allFindings(outcome)) == Severity::Info;
    QCOMPARE(recordOf(outcome, "key").state, isQuiet ? SensorState::Done : SensorState::Cautions);
    addFinding(outcome, Severity::Caution);
    QCOMPARE(recordOf(outcome, "key").state, SensorState::Cautions);
    QVERIFY(recordOf(outcome, "key").reason.empty());
    addFinding(outcome, Severity::Block);
    QCOMPARE(recordOf(outcome, "key").state, SensorState::Blocked);
}

/// What may not be published leaves the program in no other way either.
void TestBatchRecord::record_ofWhatBlocks_statesNoResult()
{
    PipelineOutcome outcome = exampleOutcome();
    addFinding(outcome, Severity::Block);
    const SensorOutcome record = recordOf(outcome, "key");
    QVERIFY(record.results.empty());
    QCOMPARE(record.reason, std::string("Shot 2 is strange."));
    QVERIFY((record.said == KeptMessage{"Shot %1 is strange.", {"2"}, {}}));
    QVERIFY(!record.findings.empty());
}

void TestBatchRecord::record_ofAStoppedRun_hasTheError()
{
    PipelineOutcome outcome;
    outcome.error = Error{ErrorKind::DataBlocked, {"There is no step.", {}}, "WIN-002", 0};
    const SensorOutcome record = recordOf(outcome, "key");
    QCOMPARE(record.state, SensorState::Blocked);
    QCOMPARE(record.reason, std::string("There is no step."));
    QCOMPARE(record.findings.size(), std::size_t(1));
    QCOMPARE(record.findings.front().id, std::string("WIN-002"));
    QCOMPARE(record.findings.front().severity, Severity::Block);
}

DYNCAL_TEST(TestBatchRecord)
#include "tst_batch_record.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_plan.h"
#include "tests/core/batch/batch_tree.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <set>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

std::string messageOf(const Result<BatchPlan> &plan)
{
    return plan ? std::string("(none)") : english(plan.error().message);
}

/// The line of a sensor with one piece of its text replaced.
std::string changedLine(const PlannedSensor &sensor, const std::string &from, const std::string &to)
{
    std::string line = planLine(sensor);
    const std::size_t at = line.find(from);
    if (at != std::string::npos)
        line.replace(at, from.size(), to);
    return line;
}

PlannedSensor unplanned(const std::string &id)
{
    PlannedSensor sensor;
    sensor.id = id;
    sensor.source = "in/" + id;
    sensor.output = "plan.out/" + id;
    sensor.obstacle = "There is nothing to read.";
    sensor.said = {"There is nothing to read."};
    return sensor;
}

} // namespace

/// The plan as text, and the key by which a sensor is known to be complete.
class TestBatchPlan : public QObject
{
    Q_OBJECT

private slots:
    void line_readsBackAsTheSameSensor();
    void line_isOneLineWhateverTheNamesHold();
    void plan_keepsTheOrderAndLeavesEmptyLinesOut();
    void plan_ofNothing_isEmpty();
    void plan_namesTheLineThatIsNone_data();
    void plan_namesTheLineThatIsNone();
    void plan_outputOutsideOfItsFolder_isRefused_data();
    void plan_outputOutsideOfItsFolder_isRefused();
    void plan_sameIdTwice_isRefused();
    void plan_sameOutputTwice_isRefused();
    void plan_idThatIsAnOutput_isNotMistaken();
    void plan_thatCannotBeRead_isNamed();
    void key_dependsOnAllThatResultsDependOn();
    void key_dependsOnNothingElse();
    void key_isNotFooledByNamesWithSpacesAndBreaks();
    void folder_ofAPlan();
};

void TestBatchPlan::line_readsBackAsTheSameSensor()
{
    PlannedSensor sensor = plannedSensor("SN-1", {"a", "b"});
    sensor.recipe = "in/SN-1/recipe.json";
    sensor.profile = "profile.json";
    for (const PlannedSensor &one : {sensor, plannedSensor("2026/Ö 7"), unplanned("x")}) {
        const Result<BatchPlan> plan = parsePlan(planLine(one), "plan");
        QVERIFY2(plan, messageOf(plan).c_str());
        QCOMPARE(plan->size(), std::size_t(1));
        QVERIFY(plan->front() == one);
    }
}

void TestBatchPlan::line_isOneLineWhateverTheNamesHold()
{
    const PlannedSensor sensor = plannedSensor("a\nb\"\\\t\x1b[31m\u202e");
    const std::string line = planLine(sensor);
    QCOMPARE(std::ranges::count(line, '\n'), std::ptrdiff_t(1));
    QVERIFY(line.ends_with('\n'));
    QVERIFY(line.find('\x1b') == std::string::npos);
    const Result<BatchPlan> plan = parsePlan(line, "plan");
    QVERIFY2(plan, messageOf(plan).c_str());
    QVERIFY(plan->front() == sensor);
}

void TestBatchPlan::plan_keepsTheOrderAndLeavesEmptyLinesOut()
{
    const std::string text = "\n" + planLine(plannedSensor("b")) + "  \r\n"
        + planLine(plannedSensor("a")) + planLine(unplanned("c"));
    const Result<BatchPlan> plan = parsePlan(text, "plan");
    QVERIFY2(plan, messageOf(plan).c_str());
    QCOMPARE(plan->size(), std::size_t(3));
    QCOMPARE(plan->at(0).id, std::string("b"));
    QCOMPARE(plan->at(1).id, std::string("a"));
    QCOMPARE(plan->at(2).obstacle, unplanned("c").obstacle);
    QVERIFY(plan->at(2).said == unplanned("c").said);
}

void TestBatchPlan::plan_ofNothing_isEmpty()
{
    const Result<BatchPlan> plan = parsePlan("", "plan");
    QVERIFY(plan);
    QVERIFY(plan->empty());
}

void TestBatchPlan::plan_namesTheLineThatIsNone_data()
{
    const PlannedSensor sensor = plannedSensor("a");
    const std::string hash = sensor.inputs[0].sha256;
    QTest::addColumn<QByteArray>("line");
    const auto row = [](const char *name, const std::string &line) {
        QTest::newRow(name) << QByteArray::fromStdString(line);
    };
    row("no JSON", "night");
    row("half a line", planLine(sensor).substr(0, 100));
    row("a list", "[1, 2]");
    row("another schema", changedLine(sensor, "dyncal-batch-plan/1", "dyncal-batch-plan/2"));
    row("no id", changedLine(sensor, "\"id\"", "\"ID\""));
    row("id is a number", changedLine(sensor, "\"id\":\"a\"", "\"id\":7"));
    row("no source", changedLine(sensor, "\"source\"", "\"sauce\""));
    row("no inputs", changedLine(sensor, "\"inputs\"", "\"outputs\""));
    row("inputs are a text", changedLine(sensor, "\"inputs\":[", "\"inputs\":7,\"other\":["));
    row("hash too short", changedLine(sensor, hash, hash.substr(1)));
    row("hash of capitals", changedLine(sensor, hash, std::string(64, 'A')));
    row("input with a path", changedLine(sensor, "shot_1.csv", "../shot_1.csv"));
    row("input without a size", changedLine(sensor, "\"bytes\"", "\"bits\""));
    row("no hash of the recipe", changedLine(sensor, "recipe_sha256", "recipe_hash"));
    row("no methods", changedLine(sensor, "\"methods\"", "\"means\""));
    row("version is a text", changedLine(sensor, "\"model\":6", "\"model\":\"six\""));
    row("key twice", changedLine(sensor, "\"id\":\"a\"", "\"id\":\"a\",\"id\":\"b\""));
}

void TestBatchPlan::plan_namesTheLineThatIsNone()
{
    QFETCH(QByteArray, line);
    const std::string text = planLine(plannedSensor("b")) + line.toStdString() + '\n';
    const Result<BatchPlan> plan = parsePlan(text, "night.jsonl");
    QVERIFY(!plan);
    QCOMPARE(plan.error().kind, ErrorKind::Usage);
    QVERIFY2(
        messageOf(plan).find("ine 2 of night.jsonl") != std::string::npos, messageOf(plan).c_str());
}

void TestBatchPlan::plan_outputOutsideOfItsFolder_isRefused_data()
{
    QTest::addColumn<QByteArray>("output");
    for (const char *output : {"", ".", "..", "../x", "a/../../x", "/tmp/x", "a/.."})
        QTest::newRow(*output ? output : "(empty)") << QByteArray(output);
}

void TestBatchPlan::plan_outputOutsideOfItsFolder_isRefused()
{
    QFETCH(QByteArray, output);
    PlannedSensor sensor = plannedSensor("a");
    sensor.output = output.toStdString();
    QVERIFY(!parsePlan(planLine(sensor), "plan"));
    sensor.obstacle = "No reason to write elsewhere.";
    QVERIFY(!parsePlan(planLine(sensor), "plan"));
}

void TestBatchPlan::plan_sameIdTwice_isRefused()
{
    PlannedSensor again = plannedSensor("a");
    again.output = "plan.out/elsewhere";
    const auto plan = parsePlan(planLine(plannedSensor("a")) + planLine(again), "plan");
    QVERIFY(!plan);
    QVERIFY2(messageOf(plan).find("Line 2 of plan") != std::string::npos, messageOf(plan).c_str());
    QVERIFY(messageOf(plan).find("\"a\"") != std::string::npos);
}

void TestBatchPlan::plan_sameOutputTwice_isRefused()
{
    PlannedSensor other = plannedSensor("b");
    other.output = "plan.out/a";
    const auto plan = parsePlan(planLine(plannedSensor("a")) + planLine(other), "plan");
    QVERIFY(!plan);
    QVERIFY(messageOf(plan).find("plan.out/a") != std::string::npos);
}

void TestBatchPlan::plan_idThatIsAnOutput_isNotMistaken()
{
    const std::string text = planLine(plannedSensor("a")) + planLine(plannedSensor("plan.out/a"));
    QVERIFY(parsePlan(text, "plan"));
}

void TestBatchPlan::plan_thatCannotBeRead_isNamed()
{
    const ScratchFolder folder;
    for (const std::string &path : {folder.file("none.jsonl"), folder.file("")}) {
        const Result<BatchPlan> plan = readPlan(path);
        QVERIFY(!plan);
        QCOMPARE(plan.error().kind, ErrorKind::FileUnreadable);
        QVERIFY(messageOf(plan).find(path) != std::string::npos);
    }
    const std::string text = planLine(plannedSensor("a"));
    const Result<BatchPlan> plan = readPlan(folder.write("p.jsonl", text.data(), text.size()));
    QVERIFY(plan);
    QCOMPARE(plan->size(), std::size_t(1));
}

void TestBatchPlan::key_dependsOnAllThatResultsDependOn()
{
    const PlannedSensor sensor = plannedSensor("a", {"1", "2"});
    std::set<std::string> keys{sensorKey(sensor)};
    const auto differs = [&](auto change) {
        PlannedSensor other = sensor;
        change(other);
        return keys.insert(sensorKey(other)).second;
    };
    QVERIFY(isSha256Hex(*keys.begin()));
    QVERIFY(differs([](auto &s) { s.inputs[1].sha256 = sha256Hex(std::string_view("3")); }));
    QVERIFY(differs([](auto &s) { std::swap(s.inputs[0], s.inputs[1]); }));
    QVERIFY(differs([](auto &s) { s.inputs.pop_back(); }));
    QVERIFY(differs([](auto &s) { s.inputs[0].file = "shot_0.csv"; }));
    QVERIFY(differs([](auto &s) { s.recipeSha256 = sha256Hex(std::string_view("other")); }));
    QVERIFY(differs([](auto &s) { s.methods["model"] = 7; }));
    QVERIFY(differs([](auto &s) { s.methods["new stage"] = 1; }));
}

void TestBatchPlan::key_dependsOnNothingElse()
{
    const PlannedSensor sensor = plannedSensor("a");
    PlannedSensor moved = sensor;
    moved.id = "b";
    moved.source = "/mnt/other/in/a";
    moved.recipe = "elsewhere/recipe.json"; // its content counts
    moved.profile = "elsewhere/profile.json";
    moved.output = "other.out/b";
    QCOMPARE(sensorKey(moved), sensorKey(sensor));
}

void TestBatchPlan::key_isNotFooledByNamesWithSpacesAndBreaks()
{
    const std::string hash = sha256Hex(std::string_view("a"));
    PlannedSensor one = plannedSensor("a");
    one.inputs = {{"x\n" + hash + " 1 y", hash, 1}};
    PlannedSensor two = one;
    two.inputs = {{"x", hash, 1}, {"y", hash, 1}};
    QVERIFY(sensorKey(one) != sensorKey(two));
}

void TestBatchPlan::folder_ofAPlan()
{
    QCOMPARE(folderOfPlan("night.jsonl"), std::string("."));
    QCOMPARE(folderOfPlan("a/b/night.jsonl"), std::string("a/b"));
    QCOMPARE(folderOfPlan("/night.jsonl"), std::string("/"));
}

DYNCAL_TEST(TestBatchPlan)
#include "tst_batch_plan.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/batch_planning.h"
#include "core/project/recipe.h"
#include "tests/core/batch/batch_tree.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <map>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

/// Three sensors, a common recipe and a profile.
struct Laboratory
{
    ScratchFolder folder;
    BatchRequest request{folder.file("in"), folder.file("recipe.json"), folder.file("profile.json"),
        false, folder.file("night.jsonl")};

    Laboratory()
    {
        for (int i = 1; i <= 3; ++i)
            writeRecording(folder.file("in/SN-" + std::to_string(i) + "/x.csv"), i);
        writeText(request.recipe, R"({"realization": {"order": 4}})");
        writeText(request.profile,
            R"({"schema": "dyncal-profile/1", "name": "L", "version": "1", "shock": {"driver_length_m": 0.97}})");
    }

    BatchPlan plan() const
    {
        const Result<BatchPlan> plan = planBatch(request);
        if (!plan)
            qWarning("%s", english(plan.error().message).c_str());
        return plan.value_or(BatchPlan());
    }
    /// Ids of the sensors whose key is another one than in `before`.
    QStringList changedSince(const BatchPlan &before) const
    {
        std::map<std::string, std::string> keys;
        for (const PlannedSensor &sensor : before)
            keys[sensor.id] = sensorKey(sensor);
        QStringList changed;
        for (const PlannedSensor &sensor : plan())
            if (keys[sensor.id] != sensorKey(sensor))
                changed << QString::fromStdString(sensor.id);
        return changed;
    }
};

const QStringList kAll{"SN-1", "SN-2", "SN-3"};

constexpr const char *kNamesLab = R"({"certificate": {"template": "../../lab.json"}})";

/// A template's file, of a document in that language.
std::string templateOf(const std::string &language)
{
    return R"({"schema": "dyncal-template/1", "languages": [")" + language + R"("]})";
}

} // namespace

/// From a folder to a plan, and what a change of anything asks for again.
class TestBatchPlanning : public QObject
{
    Q_OBJECT

private slots:
    void plan_statesFilesHashesAndPlaces();
    void plan_sameFiles_isTheSameTwice();
    void plan_movedTogether_isTheSame();
    void plan_readsBackAsItIs();
    void change_ofARecording_asksForThatSensor();
    void change_ofTheRecipe_asksForAll();
    void change_ofFormOnly_asksForNone();
    void change_ofTheProfile_asksForAll();
    void change_ofOwnRecipe_asksForThatSensor();
    void change_ofATemplate_asksForWhoPrintsIt();
    void template_missing_isAnObstacle();
    void ownRecipe_winsOverTheCommonOne();
    void ownRecipe_broken_isAnObstacle();
    void unreadable_isAnObstacle();
    void defaults_withoutRecipeAndProfile();
    void outputs_areDifferent();
    void place_belowTheRecordings_isRefused_data();
    void place_belowTheRecordings_isRefused();
    void recipe_broken_isRefused();
    void nothingToPlan_isRefused();
    void stopped_isCancelled();
    void progress_risesToOne();
};

void TestBatchPlanning::plan_statesFilesHashesAndPlaces()
{
    const Laboratory laboratory;
    const BatchPlan plan = laboratory.plan();
    QCOMPARE(plan.size(), std::size_t(3));
    for (int i = 1; i <= 3; ++i) {
        const PlannedSensor &sensor = plan[static_cast<std::size_t>(i - 1)];
        const std::string id = "SN-" + std::to_string(i);
        QCOMPARE(sensor.id, id);
        QCOMPARE(sensor.source, "in/" + id);
        QCOMPARE(sensor.output, "night.out/" + id);
        QCOMPARE(sensor.recipe, std::string("recipe.json"));
        QCOMPARE(sensor.profile, std::string("profile.json"));
        QCOMPARE(sensor.methods, methodVersions());
        QCOMPARE(sensor.inputs.size(), std::size_t(1));
        QCOMPARE(sensor.inputs[0].file, std::string("x.csv"));
        QCOMPARE(sensor.inputs[0].sha256, sha256Hex(std::string_view(recordingText(i))));
        QCOMPARE(sensor.inputs[0].bytes, std::uintmax_t(recordingText(i).size()));
        const auto recipe = readRecipeFiles(laboratory.request.recipe, laboratory.request.profile);
        QCOMPARE(sensor.recipeSha256, sha256Hex(std::string_view(recipeJson(*recipe))));
    }
}

void TestBatchPlanning::plan_sameFiles_isTheSameTwice()
{
    const Laboratory laboratory;
    QCOMPARE(planText(laboratory.plan()), planText(laboratory.plan()));
    const Laboratory elsewhere;
    QCOMPARE(planText(elsewhere.plan()), planText(laboratory.plan()));
}

void TestBatchPlanning::plan_movedTogether_isTheSame()
{
    Laboratory laboratory;
    const std::string before = planText(laboratory.plan());
    const std::string deeper = laboratory.folder.file("mnt/share");
    fs::create_directories(deeper);
    for (const char *name : {"in", "recipe.json", "profile.json"})
        fs::rename(laboratory.folder.file(name), deeper + "/" + name);
    laboratory.request = {deeper + "/in", deeper + "/recipe.json", deeper + "/profile.json", false,
        deeper + "/../share/night.jsonl"};
    QCOMPARE(planText(laboratory.plan()), before);
}

void TestBatchPlanning::plan_readsBackAsItIs()
{
    const Laboratory laboratory;
    writeText(laboratory.folder.file("in/zz/x.bin"), "nothing");
    const BatchPlan plan = laboratory.plan();
    QVERIFY(!plan.back().obstacle.empty());
    const Result<BatchPlan> read = parsePlan(planText(plan), "night");
    QVERIFY(read);
    QVERIFY(*read == plan);
}

void TestBatchPlanning::change_ofARecording_asksForThatSensor()
{
    const Laboratory laboratory;
    const BatchPlan before = laboratory.plan();
    QVERIFY(laboratory.changedSince(before).isEmpty());
    writeRecording(laboratory.folder.file("in/SN-2/x.csv"), 9);
    QCOMPARE(laboratory.changedSince(before), QStringList({"SN-2"}));
    writeRecording(laboratory.folder.file("in/SN-2/x.csv"), 2);
    QVERIFY(laboratory.changedSince(before).isEmpty());
    writeRecording(laboratory.folder.file("in/SN-3/y.csv"), 1);
    QCOMPARE(laboratory.changedSince(before), QStringList({"SN-3"}));
}

void TestBatchPlanning::change_ofTheRecipe_asksForAll()
{
    const Laboratory laboratory;
    const BatchPlan before = laboratory.plan();
    writeText(laboratory.request.recipe, R"({"realization": {"order": 6}})");
    QCOMPARE(laboratory.changedSince(before), kAll);
}

void TestBatchPlanning::change_ofFormOnly_asksForNone()
{
    const Laboratory laboratory;
    const BatchPlan before = laboratory.plan();
    writeText(laboratory.request.recipe,
        "{\n  \"realization\": {\n    \"order\": 4, \"max_order\": 120}}\n"); // 120: the default
    QVERIFY(laboratory.changedSince(before).isEmpty());
}

void TestBatchPlanning::change_ofTheProfile_asksForAll()
{
    const Laboratory laboratory;
    const BatchPlan before = laboratory.plan();
    writeText(laboratory.request.profile,
        R"({"schema": "dyncal-profile/1", "name": "L", "version": "2", "shock": {"driver_length_m": 0.98}})");
    QCOMPARE(laboratory.changedSince(before), kAll);
}

void TestBatchPlanning::change_ofOwnRecipe_asksForThatSensor()
{
    const Laboratory laboratory;
    writeText(laboratory.folder.file("in/SN-2/recipe.json"), R"({"remap": false})");
    const BatchPlan before = laboratory.plan();
    writeText(laboratory.folder.file("in/SN-2/recipe.json"), R"({"remap": true})");
    QCOMPARE(laboratory.changedSince(before), QStringList({"SN-2"}));
    writeText(laboratory.request.recipe, R"({"realization": {"order": 6}})");
    QCOMPARE(laboratory.changedSince(before), kAll); // SN-2 by its own
}

void TestBatchPlanning::change_ofATemplate_asksForWhoPrintsIt()
{
    const Laboratory laboratory;
    const std::string lab = laboratory.folder.file("lab.json");
    writeText(laboratory.folder.file("in/SN-2/recipe.json"), kNamesLab);
    writeText(lab, templateOf("en"));
    const BatchPlan before = laboratory.plan();
    QVERIFY(before[1].obstacle.empty());
    writeText(lab, templateOf("sv"));
    QCOMPARE(laboratory.changedSince(before), QStringList({"SN-2"}));
    writeText(lab, templateOf("en"));
    QVERIFY(laboratory.changedSince(before).isEmpty());
}

void TestBatchPlanning::template_missing_isAnObstacle()
{
    const Laboratory laboratory;
    writeText(laboratory.folder.file("in/SN-2/recipe.json"), kNamesLab);
    const BatchPlan plan = laboratory.plan();
    QVERIFY(plan[1].obstacle.find("lab.json") != std::string::npos);
    QVERIFY(plan[0].obstacle.empty() && plan[2].obstacle.empty());
}

void TestBatchPlanning::ownRecipe_winsOverTheCommonOne()
{
    const Laboratory laboratory;
    const std::string own = laboratory.folder.file("in/SN-2/recipe.json");
    writeText(own, R"({"remap": false})");
    const BatchPlan plan = laboratory.plan();
    QCOMPARE(plan[1].recipe, std::string("in/SN-2/recipe.json"));
    QCOMPARE(plan[1].profile, std::string("profile.json"));
    QCOMPARE(
        plan[1].recipeSha256, *hashOfRecipe(*readRecipeFiles(own, laboratory.request.profile)));
    QCOMPARE(plan[0].recipe, std::string("recipe.json"));
}

void TestBatchPlanning::ownRecipe_broken_isAnObstacle()
{
    const Laboratory laboratory;
    writeText(laboratory.folder.file("in/SN-2/recipe.json"), R"({"remapp": true})");
    const BatchPlan plan = laboratory.plan();
    QCOMPARE(plan.size(), std::size_t(3));
    QVERIFY(plan[1].obstacle.find("remapp") != std::string::npos);
    QCOMPARE(english(plan[1].said.message()), plan[1].obstacle);
    QVERIFY(plan[1].inputs.empty());
    QVERIFY(plan[0].obstacle.empty() && plan[2].obstacle.empty());
}

void TestBatchPlanning::unreadable_isAnObstacle()
{
    const Laboratory laboratory;
    // Nobody can read the first bytes of it, whatever the rights.
    fs::create_symlink("/proc/self/mem", laboratory.folder.file("in/SN-2/y.csv"));
    QVERIFY(laboratory.plan()[1].obstacle.find("y.csv") != std::string::npos);
}

void TestBatchPlanning::defaults_withoutRecipeAndProfile()
{
    Laboratory laboratory;
    laboratory.request.recipe.clear();
    laboratory.request.profile.clear();
    const BatchPlan plan = laboratory.plan();
    QCOMPARE(plan.size(), std::size_t(3));
    QCOMPARE(plan[0].recipe, std::string());
    QCOMPARE(plan[0].profile, std::string());
    QCOMPARE(plan[0].recipeSha256, *hashOfRecipe(Recipe()));
}

void TestBatchPlanning::outputs_areDifferent()
{
    const Laboratory laboratory;
    for (const char *id : {"a/b", "a+b", "a%2Bb", "a b", "a"})
        writeRecording(laboratory.folder.file("in") + "/" + id + "/x.csv", 1);
    QVERIFY(parsePlan(planText(laboratory.plan()), "night"));
}

void TestBatchPlanning::place_belowTheRecordings_isRefused_data()
{
    QTest::addColumn<QByteArray>("plan");
    for (const char *plan :
        {"in/night.jsonl", "in/SN-1/night.jsonl", "in/../in/night.jsonl", "link/night.jsonl"})
        QTest::newRow(plan) << QByteArray(plan);
}

void TestBatchPlanning::place_belowTheRecordings_isRefused()
{
    QFETCH(QByteArray, plan);
    Laboratory laboratory;
    fs::create_directory_symlink(laboratory.folder.file("in"), laboratory.folder.file("link"));
    laboratory.request.plan = laboratory.folder.file(plan.toStdString());
    const Result<BatchPlan> refused = planBatch(laboratory.request);
    QVERIFY(!refused);
    QCOMPARE(refused.error().kind, ErrorKind::Usage);
}

void TestBatchPlanning::recipe_broken_isRefused()
{
    const Laboratory laboratory;
    writeText(laboratory.request.recipe, R"({"realization": {"ordre": 4}})");
    const Result<BatchPlan> refused = planBatch(laboratory.request);
    QVERIFY(!refused);
    QVERIFY(english(refused.error().message).find("ordre") != std::string::npos);
}

void TestBatchPlanning::nothingToPlan_isRefused()
{
    Laboratory laboratory;
    fs::remove_all(laboratory.folder.file("in"));
    QVERIFY(!planBatch(laboratory.request));
    fs::create_directories(laboratory.folder.file("in/empty"));
    const Result<BatchPlan> refused = planBatch(laboratory.request);
    QVERIFY(!refused);
    QCOMPARE(refused.error().kind, ErrorKind::Usage);
}

void TestBatchPlanning::stopped_isCancelled()
{
    const Laboratory laboratory;
    std::stop_source stop;
    stop.request_stop();
    const Result<BatchPlan> stopped = planBatch(laboratory.request, {stop.get_token(), {}});
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().kind, ErrorKind::Cancelled);
}

void TestBatchPlanning::progress_risesToOne()
{
    const Laboratory laboratory;
    std::vector<double> seen;
    QVERIFY(planBatch(laboratory.request, {{}, [&](double done) { seen.push_back(done); }}));
    QVERIFY(std::ranges::is_sorted(seen));
    QCOMPARE(seen.back(), 1.0);
}

DYNCAL_TEST(TestBatchPlanning)
#include "tst_batch_planning.moc"

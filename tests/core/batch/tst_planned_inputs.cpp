// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/planned_inputs.h"
#include "core/capture/opening/capture_open.h"
#include "core/project/template_choice.h"
#include "tests/core/batch/batch_tree.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

/// A sensor with two recordings and a text that is none, all of them planned.
struct RecordedSensor
{
    ScratchFolder folder;
    fs::path source = folder.file("in/a");
    PlannedSensor sensor = plannedSensor("a");

    RecordedSensor()
    {
        writeRecording(source / "shot_1.csv", 1);
        writeRecording(source / "shot_2.csv", 2);
        writeText(source / "todo.txt", "call the laboratory\n");
        sensor.inputs = {planned("shot_1.csv"), planned("shot_2.csv"), planned("todo.txt")};
    }

    PlannedFile planned(const std::string &name) const
    {
        const std::string path = (source / name).string();
        return {name, sha256OfFile(path), fs::file_size(path)};
    }
    std::string plan() const { return folder.file(""); }
    Result<std::vector<std::string>> paths() const { return plannedPaths(plan(), sensor); }
    Result<CaptureSet> read() const
    {
        return readCaptures({pathOfPlan(plan(), sensor.source)}, ImportSettings());
    }
    Result<std::vector<InputStamp>> stamps() const
    {
        const Result<CaptureSet> set = read();
        return set ? checkReadInputs(*set, *paths(), sensor)
                   : Result<std::vector<InputStamp>>(tl::unexpected<Error>(set.error()));
    }
};

template <typename T>
bool blames(const Result<T> &result, const std::string &name)
{
    return !result && result.error().kind == ErrorKind::FileUnreadable
        && english(result.error().message).find(name) != std::string::npos;
}

} // namespace

/// Whether recordings are those that were planned.
class TestPlannedInputs : public QObject
{
    Q_OBJECT

private slots:
    void paths_ofWhatIsThere();
    void paths_ofASingleFile();
    void paths_otherFiles_areRefused();
    void read_givesTheStamps();
    void read_changedRecording_isNamed();
    void read_changedFileThatIsLeftOut_isNamed();
    void known_unchanged_isNotReadAgain();
    void known_newTimes_isReadAgain();
    void known_changed_isNamed();
    void known_nothing_readsAll();
    void recipe_isThatOfThePlan();
    void recipe_changed_isNamed();
    void recipe_ofAChangedTemplate_isNotThatOfThePlan();
};

void TestPlannedInputs::paths_ofWhatIsThere()
{
    const RecordedSensor one;
    const auto paths = one.paths();
    QVERIFY(paths);
    QCOMPARE(paths->size(), std::size_t(3));
    QVERIFY(paths->at(0).ends_with("in/a/shot_1.csv"));
    QVERIFY(paths->at(2).ends_with("in/a/todo.txt"));
}

void TestPlannedInputs::paths_ofASingleFile()
{
    RecordedSensor one;
    one.sensor.source = "in/a/shot_2.csv";
    one.sensor.inputs = {one.planned("shot_2.csv")};
    const auto paths = one.paths();
    QVERIFY(paths);
    QCOMPARE(paths->size(), std::size_t(1));
    fs::remove(one.source / "shot_2.csv");
    QVERIFY(blames(one.paths(), "shot_2.csv"));
}

void TestPlannedInputs::paths_otherFiles_areRefused()
{
    const RecordedSensor one;
    writeRecording(one.source / "shot_3.csv", 3);
    QVERIFY(blames(one.paths(), "in/a"));
    fs::remove(one.source / "shot_3.csv");
    QVERIFY(one.paths());
    fs::remove(one.source / "shot_2.csv");
    QVERIFY(blames(one.paths(), "in/a"));
    fs::remove_all(one.source);
    QVERIFY(blames(one.paths(), "in/a"));
}

void TestPlannedInputs::read_givesTheStamps()
{
    const RecordedSensor one;
    const auto stamps = one.stamps();
    QVERIFY(stamps);
    QCOMPARE(stamps->size(), std::size_t(3));
    for (std::size_t i = 0; i < stamps->size(); ++i) {
        QCOMPARE(stamps->at(i).bytes, one.sensor.inputs[i].bytes);
        QVERIFY(stamps->at(i).changed_ns > 0);
    }
}

void TestPlannedInputs::read_changedRecording_isNamed()
{
    const RecordedSensor one;
    writeRecording(one.source / "shot_2.csv", 7);
    QVERIFY(blames(one.stamps(), "shot_2.csv"));
}

/// It takes no part in the results, but in their findings.
void TestPlannedInputs::read_changedFileThatIsLeftOut_isNamed()
{
    const RecordedSensor one;
    writeText(one.source / "todo.txt", "done\n");
    QVERIFY(blames(one.stamps(), "todo.txt"));
}

/// Told by a hash that is wrong on purpose: with size and time as they were it is not looked at.
void TestPlannedInputs::known_unchanged_isNotReadAgain()
{
    RecordedSensor one;
    const auto stamps = one.stamps();
    QVERIFY(stamps);
    one.sensor.inputs[0].sha256 = std::string(64, '0');
    QVERIFY(checkKnownInputs(*stamps, *one.paths(), one.sensor));
}

void TestPlannedInputs::known_newTimes_isReadAgain()
{
    const RecordedSensor one;
    std::vector<InputStamp> stamps = *one.stamps();
    stamps[1].changed_ns += 1;
    QVERIFY(checkKnownInputs(stamps, *one.paths(), one.sensor));
    RecordedSensor other;
    other.sensor.inputs[1].sha256 = std::string(64, '0');
    QVERIFY(blames(checkKnownInputs(stamps, *other.paths(), other.sensor), "shot_1.csv")
        || blames(checkKnownInputs(stamps, *other.paths(), other.sensor), "shot_2.csv"));
}

void TestPlannedInputs::known_changed_isNamed()
{
    const RecordedSensor one;
    const auto stamps = one.stamps();
    writeRecording(one.source / "shot_1.csv", 7);
    QVERIFY(blames(checkKnownInputs(*stamps, *one.paths(), one.sensor), "shot_1.csv"));
}

void TestPlannedInputs::known_nothing_readsAll()
{
    RecordedSensor one;
    QVERIFY(checkKnownInputs({}, *one.paths(), one.sensor));
    one.sensor.inputs[2].sha256 = std::string(64, '0');
    QVERIFY(blames(checkKnownInputs({}, *one.paths(), one.sensor), "todo.txt"));
}

void TestPlannedInputs::recipe_isThatOfThePlan()
{
    const ScratchFolder folder;
    PlannedSensor sensor = plannedSensor("a");
    sensor.recipeSha256 = *hashOfRecipe(Recipe());
    QVERIFY(plannedRecipe(sensor));
    writeText(folder.file("recipe.json"), R"({"realization": {"order": 4}})");
    sensor.recipe = folder.file("recipe.json");
    sensor.recipeSha256 = *hashOfRecipe(*readRecipeFile(sensor.recipe));
    const Result<Recipe> recipe = plannedRecipe(sensor);
    QVERIFY(recipe);
    QCOMPARE(recipe->realization.order.value.value_or(0), Index(4));
    // What is written another way says the same.
    writeText(sensor.recipe, "{\n\"realization\":{\"order\":4}}");
    QVERIFY(plannedRecipe(sensor));
}

void TestPlannedInputs::recipe_changed_isNamed()
{
    const ScratchFolder folder;
    PlannedSensor sensor = plannedSensor("a");
    writeText(folder.file("recipe.json"), "{}");
    sensor.recipe = folder.file("recipe.json");
    sensor.recipeSha256 = *hashOfRecipe(*readRecipeFile(sensor.recipe));
    writeText(sensor.recipe, R"({"realization": {"order": 4}})");
    QVERIFY(blames(plannedRecipe(sensor), "recipe.json"));
    fs::remove(sensor.recipe);
    QVERIFY(blames(plannedRecipe(sensor), "recipe.json"));
}

void TestPlannedInputs::recipe_ofAChangedTemplate_isNotThatOfThePlan()
{
    const ScratchFolder folder;
    PlannedSensor sensor = plannedSensor("a");
    sensor.recipe = folder.file("recipe.json");
    writeText(sensor.recipe, R"({"certificate": {"template": "lab.json"}})");
    writeText(folder.file("lab.json"), R"({"schema": "dyncal-template/1"})");
    Recipe located = *readRecipeFile(sensor.recipe);
    locateTemplate(sensor.recipe, located);
    sensor.recipeSha256 = *hashOfRecipe(located);
    QVERIFY(plannedRecipe(sensor));
    writeText(folder.file("lab.json"), R"({"schema": "dyncal-template/1", "languages": ["sv"]})");
    QVERIFY(blames(plannedRecipe(sensor), "recipe.json"));
    fs::remove(folder.file("lab.json"));
    QVERIFY(blames(plannedRecipe(sensor), "lab.json"));
}

DYNCAL_TEST(TestPlannedInputs)
#include "tst_planned_inputs.moc"

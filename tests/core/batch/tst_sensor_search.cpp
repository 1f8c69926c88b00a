// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/batch/sensor_search.h"
#include "tests/core/batch/batch_tree.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;
using namespace dyncal::testing;

namespace fs = std::filesystem;

namespace {

std::vector<FoundSensor> foundIn(
    const ScratchFolder &folder, bool eachFile = false, std::vector<std::string> settings = {})
{
    const auto found = findSensors({folder.file("in"), eachFile, std::move(settings)});
    return found.value_or(std::vector<FoundSensor>());
}

QStringList idsOf(const std::vector<FoundSensor> &found)
{
    QStringList ids;
    for (const FoundSensor &sensor : found)
        ids << QString::fromStdString(sensor.id);
    return ids;
}

const FoundSensor &sensorOf(const std::vector<FoundSensor> &found, const char *id)
{
    static const FoundSensor none{"(none)", {}, {}, {}};
    const auto at = std::ranges::find(found, id, &FoundSensor::id);
    return at == found.end() ? none : *at;
}

std::string obstacleOf(const std::vector<FoundSensor> &found, const char *id)
{
    const FoundSensor &sensor = sensorOf(found, id);
    return sensor.obstacle ? english(*sensor.obstacle) : std::string();
}

} // namespace

/// What is taken for a sensor.
class TestSensorSearch : public QObject
{
    Q_OBJECT

private slots:
    void folders_areSensorsInNaturalOrder();
    void folders_atAnyDepth();
    void folders_withoutFiles_areNone();
    void folders_hidden_areLeftOut();
    void folders_withoutRecording_haveAnObstacle();
    void files_areInNaturalOrderWithoutHiddenOnes();
    void files_inTheRoot_belongToNoSensor();
    void files_ofNobodyInTheRoot_areIgnored();
    void files_eachASensor();
    void recipes_ofTheirOwn();
    void settings_areNoRecordings();
    void links_toFolders_areNotFollowed();
    void names_thatAreNoUtf8_haveAnObstacle();
    void root_thatIsNone_isRefused();
};

void TestSensorSearch::folders_areSensorsInNaturalOrder()
{
    const ScratchFolder folder;
    for (const char *id : {"SN-10", "SN-9", "SN-100", "a"})
        writeRecording(folder.file("in") + "/" + id + "/x.csv", 1);
    QCOMPARE(idsOf(foundIn(folder)), QStringList({"SN-9", "SN-10", "SN-100", "a"}));
    QVERIFY(std::ranges::all_of(
        foundIn(folder), [](const FoundSensor &sensor) { return !sensor.obstacle; }));
}

void TestSensorSearch::folders_atAnyDepth()
{
    const ScratchFolder folder;
    writeRecording(folder.file("in/2026/may/SN-1/x.csv"), 1);
    writeRecording(folder.file("in/2026/SN-2/x.csv"), 1);
    writeRecording(folder.file("in/2026/SN-2/again/x.csv"), 1);
    QCOMPARE(
        idsOf(foundIn(folder)), QStringList({"2026/SN-2", "2026/SN-2/again", "2026/may/SN-1"}));
    QCOMPARE(sensorOf(foundIn(folder), "2026/SN-2").files.size(), std::size_t(1));
}

void TestSensorSearch::folders_withoutFiles_areNone()
{
    const ScratchFolder folder;
    fs::create_directories(folder.file("in/empty/deeper"));
    QVERIFY(foundIn(folder).empty());
}

void TestSensorSearch::folders_hidden_areLeftOut()
{
    const ScratchFolder folder;
    writeRecording(folder.file("in/.git/x.csv"), 1);
    writeRecording(folder.file("in/.cache/deeper/x.csv"), 1);
    writeRecording(folder.file("in/a/x.csv"), 1);
    QCOMPARE(idsOf(foundIn(folder)), QStringList({"a"}));
}

void TestSensorSearch::folders_withoutRecording_haveAnObstacle()
{
    const ScratchFolder folder;
    writeText(folder.file("in/photos/x.jpg"), "\xff\xd8\xff\xe0 JFIF");
    writeText(folder.file("in/broken/x.h5"), std::string(1000, '\0'));
    writeRecording(folder.file("in/a/x.csv"), 1);
    const auto found = foundIn(folder);
    QCOMPARE(idsOf(found), QStringList({"a", "broken", "photos"}));
    QVERIFY(!sensorOf(found, "a").obstacle);
    QVERIFY(obstacleOf(found, "photos").find("no recording") != std::string::npos);
    QVERIFY(sensorOf(found, "broken").obstacle);
}

void TestSensorSearch::files_areInNaturalOrderWithoutHiddenOnes()
{
    const ScratchFolder folder;
    for (const char *name : {"shot10.csv", "shot9.csv", ".shot1.csv", "x.tdms_index"})
        writeRecording(folder.file("in/a") + "/" + name, 1);
    const auto files = sensorOf(foundIn(folder), "a").files;
    QCOMPARE(files.size(), std::size_t(2));
    QVERIFY(files[0].ends_with("shot9.csv"));
    QVERIFY(files[1].ends_with("shot10.csv"));
}

void TestSensorSearch::files_inTheRoot_belongToNoSensor()
{
    const ScratchFolder folder;
    writeRecording(folder.file("in/x.csv"), 1);
    writeRecording(folder.file("in/a/x.csv"), 1);
    const auto found = foundIn(folder);
    QCOMPARE(idsOf(found), QStringList({".", "a"}));
    QVERIFY(obstacleOf(found, ".").find("--each-file") != std::string::npos);
}

void TestSensorSearch::files_ofNobodyInTheRoot_areIgnored()
{
    const ScratchFolder folder;
    writeText(folder.file("in/readme.pdf"), "%PDF-1.4");
    writeRecording(folder.file("in/a/x.csv"), 1);
    QCOMPARE(idsOf(foundIn(folder)), QStringList({"a"}));
}

void TestSensorSearch::files_eachASensor()
{
    const ScratchFolder folder;
    writeRecording(folder.file("in/SN-10.csv"), 1);
    writeRecording(folder.file("in/SN-9.csv"), 1);
    writeRecording(folder.file("in/more/SN-1.csv"), 1);
    writeText(folder.file("in/more/photo.jpg"), "\xff\xd8\xff\xe0 JFIF");
    const auto found = foundIn(folder, true);
    QCOMPARE(idsOf(found), QStringList({"SN-9.csv", "SN-10.csv", "more/SN-1.csv"}));
    for (const FoundSensor &sensor : found) {
        QCOMPARE(sensor.files, std::vector<std::string>{sensor.source});
        QVERIFY(!sensor.obstacle);
    }
}

void TestSensorSearch::recipes_ofTheirOwn()
{
    const ScratchFolder folder;
    for (const char *id : {"a", "b"})
        writeRecording(folder.file("in") + "/" + id + "/x.csv", 1);
    writeText(folder.file("in/a/recipe.json"), "{}");
    writeText(folder.file("in/b/x.recipe.json"), "{}");
    const auto folders = foundIn(folder);
    QVERIFY(sensorOf(folders, "a").recipe.ends_with("in/a/recipe.json"));
    QCOMPARE(sensorOf(folders, "b").recipe, std::string());
    const auto files = foundIn(folder, true);
    QCOMPARE(idsOf(files), QStringList({"a/x.csv", "b/x.csv"}));
    QCOMPARE(sensorOf(files, "a/x.csv").recipe, std::string());
    QVERIFY(sensorOf(files, "b/x.csv").recipe.ends_with("in/b/x.recipe.json"));
}

/// They may lie among the recordings; a folder with nothing else is no sensor.
void TestSensorSearch::settings_areNoRecordings()
{
    const ScratchFolder folder;
    writeRecording(folder.file("in/a/x.csv"), 1);
    writeText(folder.file("in/settings/laboratory.json"), "{}");
    writeText(folder.file("in/old/recipe.json"), "{}");
    const auto found = foundIn(folder, false, {folder.file("in/a/../settings/laboratory.json")});
    QCOMPARE(idsOf(found), QStringList({"a"}));
}

void TestSensorSearch::links_toFolders_areNotFollowed()
{
    const ScratchFolder folder;
    writeRecording(folder.file("in/a/x.csv"), 1);
    fs::create_directory_symlink(folder.file("in"), folder.file("in/round"));
    const auto found = foundIn(folder);
    QCOMPARE(idsOf(found), QStringList({"a", "round"}));
    QVERIFY(obstacleOf(found, "round").find("link") != std::string::npos);
}

void TestSensorSearch::names_thatAreNoUtf8_haveAnObstacle()
{
    const ScratchFolder folder;
    writeRecording(folder.file("in/a\xff/x.csv"), 1);
    writeRecording(folder.file("in/b/x\xff.csv"), 1);
    const auto found = foundIn(folder);
    QCOMPARE(found.size(), std::size_t(2));
    for (const FoundSensor &sensor : found) {
        QVERIFY(sensor.obstacle && english(*sensor.obstacle).find("UTF-8") != std::string::npos);
        QVERIFY(QString::fromStdString(sensor.id).toStdString() == sensor.id);
    }
}

void TestSensorSearch::root_thatIsNone_isRefused()
{
    const ScratchFolder folder;
    for (const std::string &root : {folder.file("none"), folder.write("file", "x", 1)}) {
        const auto found = findSensors({root, false, {}});
        QVERIFY(!found);
        QCOMPARE(found.error().kind, ErrorKind::FileUnreadable);
        QVERIFY(english(found.error().message).find(root) != std::string::npos);
    }
}

DYNCAL_TEST(TestSensorSearch)
#include "tst_sensor_search.moc"

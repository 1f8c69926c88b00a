// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/core/history/made_history.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

std::string whyNot(const std::vector<EarlierCalibration> &all, const std::string &serial = {})
{
    const auto found = calibrationsOfSensor(all, serial);
    return found ? std::string() : english(found.error().message);
}

SensorCalibrations taken(const std::vector<MadeCalibration> &made, const std::string &serial = {})
{
    return calibrationsOfSensor(madeCalibrations(made), serial).value();
}

EarlierCalibration blocked(EarlierCalibration one)
{
    one.blocked = "SHK-001: No step.";
    return one;
}

} // namespace

/// Which results are a sensor's history, and in which order.
class TestSensorCalibrations : public QObject
{
    Q_OBJECT

private slots:
    void points_areInTheOrderOfTheirDays();
    void anyOrder_givesTheSame();
    void oneDay_isInTheOrderOfTheResults();
    void onlySensor_needsNoChoice();
    void severalSensors_areNamed();
    void manySensors_areNotAllNamed();
    void unknownSensor_isRefused();
    void withoutSerial_isLeftOutAndSaid();
    void notInForce_isLeftOutAndSaid();
    void sensors_areCounted();
    void noneWithSerial_isRefused();
    void sameRecordings_countOnce();
    void newestOfThree_standsForTheOthers();
    void blockedOne_givesWay();
    void equalOnes_leaveOne();
    void unknownRecordings_areNotTheSame();
    void sameRecordings_ofAnotherSensor_areItsOwn();
    void name_isThatOfTheCertificate();
};

void TestSensorCalibrations::points_areInTheOrderOfTheirDays()
{
    const SensorCalibrations found
        = taken({{.day = "2026-01-01"}, {.day = "2024-01-01"}, {.day = "2025-01-01"}});
    QCOMPARE(filesOf(found.points), std::string("1 2 0"));
    QVERIFY(found.leftOut.empty());
}

void TestSensorCalibrations::anyOrder_givesTheSame()
{
    std::vector<EarlierCalibration> all = madeCalibrations({{.day = "2021-01-01"},
        {.day = "2022-01-01"}, {.day = "2023-01-01", .recording = "a"}, {.day = "2024-01-01"},
        {.day = "2023-01-01", .recording = "a", .createdUtc = "2026-07-01T00:00:00Z"}});
    std::mt19937 random(1);
    for (int i = 0; i < 20; ++i) {
        std::ranges::shuffle(all, random);
        const auto found = calibrationsOfSensor(all, {});
        QCOMPARE(filesOf(found->points), std::string("0 1 4 3"));
        QCOMPARE(filesOf(found->leftOut), std::string("2"));
    }
}

void TestSensorCalibrations::oneDay_isInTheOrderOfTheResults()
{
    const SensorCalibrations found
        = taken({{.day = "2025-01-01", .recording = "a", .createdUtc = "2026-02-01T00:00:00Z"},
            {.day = "2025-01-01", .recording = "b", .createdUtc = "2026-01-01T00:00:00Z"},
            {.day = "2025-01-01", .recording = "c", .createdUtc = "2026-03-01T00:00:00Z"}});
    QCOMPARE(filesOf(found.points), std::string("1 0 2"));
}

void TestSensorCalibrations::onlySensor_needsNoChoice()
{
    QCOMPARE(taken({{.day = "2025-01-01"}}).serial, std::string("17"));
    QCOMPARE(taken({{.day = "2025-01-01"}}, " 17 ").points.size(), std::size_t(1));
}

void TestSensorCalibrations::severalSensors_areNamed()
{
    const std::vector<MadeCalibration> made{{.day = "2025-01-01", .serial = "B 2"},
        {.day = "2025-02-01", .serial = "A 1"}, {.day = "2025-03-01", .serial = "B 2"}};
    const auto none = calibrationsOfSensor(madeCalibrations(made), {});
    QVERIFY(!none);
    QCOMPARE(none.error().kind, ErrorKind::Usage);
    const std::string sentence = english(none.error().message);
    QVERIFY2(sentence.find("of 2 sensors") != std::string::npos, sentence.c_str());
    QVERIFY2(sentence.find("serial number: A 1, B 2.") != std::string::npos, sentence.c_str());
    QCOMPARE(filesOf(taken(made, "B 2").points), std::string("0 2"));
    QVERIFY(taken(made, "B 2").leftOut.empty()); // of others nothing is said
}

void TestSensorCalibrations::manySensors_areNotAllNamed()
{
    std::vector<MadeCalibration> made;
    for (int i = 0; i < 30; ++i)
        made.push_back({.day = "2025-01-01", .serial = "serial-" + std::to_string(100 + i)});
    const std::string sentence = whyNot(madeCalibrations(made));
    QVERIFY(sentence.find("of 30 sensors") != std::string::npos);
    QVERIFY(sentence.find("serial-111, ...") != std::string::npos);
    QVERIFY(sentence.find("serial-112") == std::string::npos);
}

void TestSensorCalibrations::unknownSensor_isRefused()
{
    const std::string sentence = whyNot(madeCalibrations({{.day = "2025-01-01"}}), "18");
    QVERIFY2(sentence.find("serial number 18; there are results of 17.") != std::string::npos,
        sentence.c_str());
}

void TestSensorCalibrations::withoutSerial_isLeftOutAndSaid()
{
    const SensorCalibrations found
        = taken({{.day = "2025-01-01"}, {.day = "2025-02-01", .serial = "  "}});
    QCOMPARE(filesOf(found.points), std::string("0"));
    QCOMPARE(filesOf(found.leftOut), std::string("1"));
    QVERIFY(found.leftOut[0].reason.find("serial number") != std::string::npos);
}

/// A withdrawn certificate does not stand for another result of the same recordings either.
void TestSensorCalibrations::notInForce_isLeftOutAndSaid()
{
    auto all = madeCalibrations({{.day = "2021-03-01", .recording = "same"},
        {.day = "2021-03-01", .recording = "same", .createdUtc = "2027-01-01T00:00:00Z"},
        {.day = "2022-03-01"}});
    all[1].notInForce = "Certificate 2 was withdrawn: wrong gas";
    const SensorCalibrations sensor = calibrationsOfSensor(all, {}).value();
    QCOMPARE(filesOf(sensor.points), std::string("0 2"));
    QCOMPARE(filesOf(sensor.leftOut), std::string("1"));
    QVERIFY(sensor.leftOut[0].why == LeftOutFor::NotInForce);
    QCOMPARE(sensor.leftOut[0].reason, all[1].notInForce);
    QCOMPARE(leftOutName(LeftOutFor::NotInForce), "not_in_force");
    QCOMPARE(leftOutName(LeftOutFor::NoSerial), "no_serial");
    QCOMPARE(leftOutName(LeftOutFor::SameRecordings), "same_recordings");
}

void TestSensorCalibrations::sensors_areCounted()
{
    const auto sensors
        = sensorsOf(madeCalibrations({{.day = "2021-03-01", .serial = "18"}, {.day = "2022-03-01"},
            {.day = "2023-03-01", .serial = "18"}, {.day = "2024-03-01", .serial = ""}}));
    QCOMPARE(sensors.size(), std::size_t(2));
    QCOMPARE(
        sensors[0].serial + ' ' + std::to_string(sensors[0].calibrations), std::string("17 1"));
    QCOMPARE(
        sensors[1].serial + ' ' + std::to_string(sensors[1].calibrations), std::string("18 2"));
    QVERIFY(sensorsOf({}).empty());
}

void TestSensorCalibrations::noneWithSerial_isRefused()
{
    const auto all = madeCalibrations({{.day = "2025-01-01", .serial = ""}});
    QVERIFY(whyNot(all).find("None of the results states the serial number") == 0);
    QVERIFY(whyNot(all, "17").find("None of the results states the serial number") == 0);
    QVERIFY(!whyNot({}).empty());
}

void TestSensorCalibrations::sameRecordings_countOnce()
{
    const auto first = madeCalibration({.day = "2025-01-01", .recording = "a"}, "old", 3);
    const auto second = madeCalibration(
        {.day = "2025-01-01", .recording = "a", .createdUtc = "2026-07-01T00:00:00Z"}, "new", 4);
    for (const auto &all : {std::vector{first, second}, std::vector{second, first}}) {
        const auto found = calibrationsOfSensor(all, {});
        QCOMPARE(filesOf(found->points), std::string("new"));
        QCOMPARE(filesOf(found->leftOut), std::string("old"));
        QCOMPARE(found->leftOut[0].number, Index(3));
        QVERIFY(found->leftOut[0].reason.find("certificate 4 (new)") != std::string::npos);
    }
}

void TestSensorCalibrations::newestOfThree_standsForTheOthers()
{
    const SensorCalibrations found
        = taken({{.day = "2025-01-01", .recording = "a", .createdUtc = "2026-02-01T00:00:00Z"},
            {.day = "2025-01-02", .recording = "a", .createdUtc = "2026-09-01T00:00:00Z"},
            {.day = "2025-01-03", .recording = "a", .createdUtc = "2026-05-01T00:00:00Z"}});
    QCOMPARE(filesOf(found.points), std::string("1"));
    QCOMPARE(filesOf(found.leftOut), std::string("0 2"));
    for (const LeftOutCalibration &one : found.leftOut)
        QVERIFY(one.reason.find("are in 1, which") != std::string::npos);
}

void TestSensorCalibrations::blockedOne_givesWay()
{
    const auto good = madeCalibration({.day = "2025-01-01", .recording = "a"}, "good");
    const auto newer = blocked(madeCalibration(
        {.day = "2025-01-01", .recording = "a", .createdUtc = "2027-01-01T00:00:00Z"}, "newer"));
    QCOMPARE(filesOf(calibrationsOfSensor({newer, good}, {})->points), std::string("good"));
    QCOMPARE(filesOf(calibrationsOfSensor({newer}, {})->points), std::string("newer"));
}

void TestSensorCalibrations::equalOnes_leaveOne()
{
    const SensorCalibrations found
        = taken({{.day = "2025-01-01"}, {.day = "2025-01-01"}, {.day = "2025-01-01"}});
    QCOMPARE(filesOf(found.points), std::string("0"));
    QCOMPARE(filesOf(found.leftOut), std::string("1 2"));
}

void TestSensorCalibrations::unknownRecordings_areNotTheSame()
{
    auto all = madeCalibrations({{.day = "2025-01-01"}, {.day = "2025-01-01"}});
    for (EarlierCalibration &one : all)
        one.recordings.clear();
    QCOMPARE(filesOf(calibrationsOfSensor(all, {})->points), std::string("0 1"));
}

void TestSensorCalibrations::sameRecordings_ofAnotherSensor_areItsOwn()
{
    const SensorCalibrations found = taken({{.day = "2025-01-01", .recording = "a"},
                                               {.day = "2025-01-01",
                                                   .serial = "18",
                                                   .recording = "a",
                                                   .createdUtc = "2026-09-01T00:00:00Z"}},
        "17");
    QCOMPARE(filesOf(found.points), std::string("0"));
}

void TestSensorCalibrations::name_isThatOfTheCertificate()
{
    QCOMPARE(calibrationName(17, "a/results.json"), std::string("certificate 17 (a/results.json)"));
    QCOMPARE(calibrationName(0, "a/results.json"), std::string("a/results.json"));
}

DYNCAL_TEST(TestSensorCalibrations)
#include "tst_sensor_calibrations.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_velocity.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <nlohmann/json.hpp>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kVelocity_m_s = 512.8;
constexpr double kRounding = 1e-12;

Channel channelOf(const char *name, ChannelRole role)
{
    Channel channel = testing::doubleChannel(Eigen::VectorXd::Zero(4), kRate_Hz);
    channel.name = name;
    channel.role = role;
    return channel;
}

/// A DUT and two side sensors.
CaptureSet captureSet()
{
    CaptureSet set;
    set.shots.resize(2);
    for (Shot &shot : set.shots)
        shot.channels = {channelOf("PT1", ChannelRole::Dut),
            channelOf("near", ChannelRole::DrivenSide), channelOf("far", ChannelRole::Other)};
    return set;
}

ArrivalSensor sensorAt(const char *channel, double distance_m, double u_distance_m = 0.0)
{
    ArrivalSensor sensor;
    sensor.channel = channel;
    sensor.distanceToEndWall_m = distance_m;
    sensor.u_distance_m = u_distance_m;
    return sensor;
}

SeenArrival seenAt(const char *channel, double time_s, double u_s = 1e-7, double rise_s = 0.0)
{
    SideArrival arrival;
    arrival.time_s = time_s;
    arrival.u_time_s = u_s;
    arrival.rise_s = rise_s;
    return {channel, arrival};
}

std::string sentence(const VelocityEstimate &estimate)
{
    return estimate.missing ? english(*estimate.missing) : std::string();
}

bool contains(const std::string &text, const char *part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class TestShockVelocity : public QObject
{
    Q_OBJECT

private slots:
    void typedVelocity_winsOverEverything()
    {
        ShockSettings settings;
        settings.velocity_m_s = 432.1;
        settings.counters = {{2.0, 1.0, 1e-3, 0.0, 0.0}};
        const auto estimate = estimateVelocity(captureSet(), 1, {}, {}, settings);
        QCOMPARE(estimate.velocity_m_s.value(), 432.1);
        QVERIFY(!estimate.fit && !estimate.missing && !estimate.problem);
    }

    void sensorAndDut_distanceOverTime()
    {
        ShockSettings settings;
        settings.attenuation = "none";
        settings.arrivalSensors = {sensorAt("near", 0.6)};
        const DutArrival dut{1, 2e-3, 2e-7, true};
        const auto estimate = estimateVelocity(
            captureSet(), 1, dut, {seenAt("near", 2e-3 - 0.6 / kVelocity_m_s)}, settings);
        QVERIFY(std::abs(*estimate.velocity_m_s / kVelocity_m_s - 1.0) < kRounding);
        QVERIFY(std::abs(*estimate.arrival_s - (2e-3 - 0.6 / kVelocity_m_s)) < 1e-15);
        QCOMPARE(estimate.distance_m, 0.6);
        QCOMPARE(estimate.sightings.size(), std::size_t(2));
        QVERIFY(estimate.sightings[1].isDut && estimate.sightings[1].channel == "PT1");
        QCOMPARE(estimate.sightings[1].u_time_s, 2e-7);
        QVERIFY(!estimate.usesUncorrectedDut);
    }

    void countersWinOverArrivals()
    {
        ShockSettings settings;
        settings.attenuation = "none";
        settings.arrivalSensors = {sensorAt("near", 0.6)};
        settings.counters = {{1.5, 0.5, 1.0 / 400.0, 0.0, 0.0}};
        const auto estimate = estimateVelocity(
            captureSet(), 1, DutArrival{1, 2e-3, 0.0, true}, {seenAt("near", 1e-3)}, settings);
        QVERIFY(std::abs(*estimate.velocity_m_s - 400.0) < 1e-9);
        QVERIFY(estimate.sightings.empty());
    }

    void orderOfTheSensors_changesNothing()
    {
        ShockSettings settings;
        settings.useDutArrival = false;
        settings.attenuation = "none";
        std::vector<ArrivalSensor> sensors{
            sensorAt("near", 0.4, 1e-3), sensorAt("far", 1.1, 2e-3), sensorAt("dut", 0.0, 5e-4)};
        const std::vector<SeenArrival> seen{
            seenAt("dut", 2.15e-3), seenAt("far", 0.0), seenAt("near", 1.37e-3)};
        std::sort(sensors.begin(), sensors.end(),
            [](const auto &a, const auto &b) { return a.channel < b.channel; });
        settings.arrivalSensors = sensors;
        const auto first = estimateVelocity(captureSet(), 1, {}, seen, settings);
        do {
            settings.arrivalSensors = sensors;
            const auto other = estimateVelocity(captureSet(), 1, {}, seen, settings);
            QCOMPARE(*other.velocity_m_s, *first.velocity_m_s);
            QCOMPARE(other.distance_m, 1.1);
            QCOMPARE(other.sightings[0].channel, std::string("far"));
        } while (std::next_permutation(sensors.begin(), sensors.end(),
            [](const auto &a, const auto &b) { return a.channel < b.channel; }));
    }

    void distances_uncertaintyOfTheVelocity()
    {
        // Two places: u(W)/W = hypot(u1, u2)/(x1 - x2). Three equally far apart: the one in the
        // middle has no lever.
        ShockSettings settings;
        settings.useDutArrival = false;
        settings.arrivalSensors = {sensorAt("far", 1.0, 3e-3), sensorAt("near", 0.5, 4e-3)};
        auto estimate = estimateVelocity(
            captureSet(), 1, {}, {seenAt("far", 0.0), seenAt("near", 1e-3)}, settings);
        QVERIFY(std::abs(estimate.relativeDistanceUncertainty - 5e-3 / 0.5) < kRounding);
        settings.arrivalSensors
            = {sensorAt("far", 1.0, 3e-3), sensorAt("near", 0.5, 1.0), sensorAt("dut", 0.0, 4e-3)};
        estimate = estimateVelocity(captureSet(), 1, {},
            {seenAt("far", 0.0), seenAt("near", 1e-3), seenAt("dut", 2e-3)}, settings);
        QVERIFY(std::abs(estimate.relativeDistanceUncertainty - 5e-3) < kRounding);
    }

    void delay_isTakenOffWhateverTheArrivalIs()
    {
        ShockSettings settings;
        ArrivalSensor sensor = sensorAt("near", 0.6);
        const auto sighting = [&] {
            settings.arrivalSensors = {sensor};
            return estimateVelocity(captureSet(), 1, DutArrival{1, 2e-3, 0.0, true},
                {seenAt("near", 1e-3, 1e-7, 3e-6)}, settings)
                .sightings.front();
        };
        Sighting seen = sighting(); // nothing typed: a rectangle from 0 to 0.85 of the rise
        QVERIFY(std::abs(seen.time_s - (1e-3 - 0.425 * 3e-6)) < 1e-17);
        QVERIFY(std::abs(seen.u_delay_s - 0.85 * 3e-6 / std::sqrt(12.0)) < 1e-20);
        QCOMPARE(seen.u_time_s, 1e-7);
        sensor.delay_s = 5e-6;
        sensor.u_delay_s = 2e-7;
        seen = sighting();
        QVERIFY(std::abs(seen.time_s - 0.995e-3) < 1e-15);
        QCOMPARE(seen.u_delay_s, 2e-7);
        sensor.arrival_s = 1.1e-3; // typed: a time of the record too
        seen = sighting();
        QVERIFY(std::abs(seen.time_s - 1.095e-3) < 1e-15);
        QCOMPARE(seen.u_time_s, 1e-7); // no better than the search
        sensor.u_arrival_s = 4e-7;
        QCOMPARE(sighting().u_time_s, 4e-7);
        sensor.delay_s.reset();
        QVERIFY(std::abs(sighting().u_delay_s - 0.85 * 3e-6 / std::sqrt(12.0)) < 1e-20);
    }

    void dutWithoutUncertainty_hasThatOfItsSampling()
    {
        ShockSettings settings;
        settings.arrivalSensors = {sensorAt("near", 0.6)};
        const auto estimate = estimateVelocity(
            captureSet(), 1, DutArrival{1, 2e-3, 0.0, false}, {seenAt("near", 1e-3)}, settings);
        QVERIFY(std::abs(estimate.sightings[1].u_time_s - 1e-6 / std::sqrt(12.0)) < 1e-20);
        QVERIFY(estimate.usesUncorrectedDut);
    }

    void arrivals_shotByShot_elseForAll()
    {
        ShockSettings settings;
        ArrivalSensor sensor = sensorAt("near", 0.6);
        sensor.arrival_s = 1e-3;
        sensor.shotArrival_s = {std::nullopt, 1.2e-3};
        settings.arrivalSensors = {sensor};
        // An entry that is empty means: found, not the one for all shots.
        QVERIFY(!arrivalSensors(captureSet(), 1, settings)[0].arrival_s);
        QCOMPARE(arrivalSensors(captureSet(), 2, settings)[0].arrival_s.value(), 1.2e-3);
        settings.arrivalSensors[0].shotArrival_s.clear();
        QCOMPARE(arrivalSensors(captureSet(), 2, settings)[0].arrival_s.value(), 1e-3);
        QCOMPARE(arrivalChannels(settings), std::vector<std::string>{"near"});
    }

    void tubesDescription_standsForTheFirstSideSensor()
    {
        CaptureSet set = captureSet();
        QVERIFY(arrivalSensors(set, 1, {}).empty());
        set.tube = {{"endflange_to_sensor2_m", "0.445"}, {"u_endflange_to_sensor2_m", "0.001"}};
        const auto sensors = arrivalSensors(set, 1, {});
        QCOMPARE(sensors.size(), std::size_t(1));
        QCOMPARE(sensors[0].channel, std::string("near"));
        QCOMPARE(sensors[0].distanceToEndWall_m, 0.445);
        QCOMPARE(sensors[0].u_distance_m, 0.001);
        for (const char *nonsense : {"0", "-1", "nan", "far"}) {
            set.tube["endflange_to_sensor2_m"] = nonsense;
            QVERIFY(arrivalSensors(set, 1, {}).empty());
        }
    }

    void whatIsMissing_isSaid()
    {
        ShockSettings settings;
        const DutArrival dut{1, 2e-3, 0.0, true};
        CaptureSet set = captureSet();
        QVERIFY(contains(sentence(estimateVelocity(set, 1, dut, {}, settings)), "the distance"));
        set.shots[0].channels[1].role = ChannelRole::Other;
        QVERIFY(
            contains(sentence(estimateVelocity(set, 1, dut, {}, settings)), "no channel marks"));
        settings.arrivalSensors = {sensorAt("near", 0.6)};
        QVERIFY(contains(sentence(estimateVelocity(set, 1, dut, {}, settings)), "'near'"));
        const std::vector<SeenArrival> seen{seenAt("near", 1e-3)};
        QVERIFY(contains(sentence(estimateVelocity(set, 1, {}, seen, settings)), "at the DUT"));
        const DutArrival unknown{1, std::nan(""), 0.0, true};
        QVERIFY(
            contains(sentence(estimateVelocity(set, 1, unknown, seen, settings)), "at the DUT"));
        settings.dutPosition = kSideWall; // then the DUT marks nothing at the wall
        const auto estimate = estimateVelocity(set, 1, dut, seen, settings);
        QVERIFY(contains(sentence(estimate), "two arrival sensors"));
        QVERIFY(!estimate.velocity_m_s);
        QCOMPARE(estimate.arrival_s.value(), 1e-3); // the arrival itself is known
        settings.arrivalSensors.push_back(sensorAt("far", 0.6)); // two at one place are one
        QVERIFY(!sentence(
            estimateVelocity(set, 1, dut, {seenAt("near", 1e-3), seenAt("far", 1e-3)}, settings))
                     .empty());
    }

    void wrongOrder_isAProblemWithItsCorrection()
    {
        ShockSettings settings;
        settings.arrivalSensors = {sensorAt("near", 0.6)};
        for (const double late_s : {0.0, 3e-4}) {
            const auto estimate = estimateVelocity(captureSet(), 1, DutArrival{1, 1e-3, 0.0, true},
                {seenAt("near", 1e-3 + late_s)}, settings);
            QVERIFY(!estimate.velocity_m_s && estimate.problem);
            QCOMPARE(estimate.problem->findingId, std::string("SHK-001"));
            QVERIFY(estimate.problem->kind == ErrorKind::DataBlocked);
            QVERIFY(estimate.correction.has_value());
            const auto roles = nlohmann::json::parse(estimate.correction->value);
            QCOMPARE(roles["near"].get<std::string>(), std::string("dut"));
            QCOMPARE(roles["PT1"].get<std::string>(), std::string("driven_side"));
        }
        // Between two side sensors nothing can be exchanged.
        settings.useDutArrival = false;
        settings.arrivalSensors.push_back(sensorAt("far", 1.2));
        const auto estimate = estimateVelocity(
            captureSet(), 1, {}, {seenAt("near", 0.0), seenAt("far", 1e-3)}, settings);
        QVERIFY(estimate.problem && !estimate.correction);
        QVERIFY(contains(english(estimate.problem->message), "1 ms"));
    }

    void seenArrivals_ofTheRecords()
    {
        // A step at sample 1000 of "near"; "far" was not looked at.
        Eigen::VectorXd values = Eigen::VectorXd::Zero(3000);
        values.tail(2000).setOnes();
        CaptureSet set = captureSet();
        set.shots[0].channels[1].samples = testing::doubleChannel(values, kRate_Hz).samples;
        RecordStarts starts;
        starts.shots.resize(2);
        starts.shots[0].resize(3);
        DetectedStart start;
        start.sample = 1000;
        start.time_s = 1000.0 / kRate_Hz;
        starts.shots[0][1] = start;
        ShockSettings settings;
        settings.arrivalSensors
            = {sensorAt("far", 1.2), sensorAt("driven_side", 0.6), sensorAt("?", 1.0)};
        const auto seen = seenArrivals(set, 1, settings, starts, 2e-3);
        QCOMPARE(seen.size(), std::size_t(3));
        QVERIFY(!seen[0].found && !seen[2].found);
        QCOMPARE(seen[1].channel, std::string("driven_side")); // as the recipe calls it
        QVERIFY(std::abs(seen[1].found->time_s - 999.5 / kRate_Hz) < 1e-12);
        QVERIFY(!seenArrivals(set, 2, settings, starts, {})[1].found);
    }
};

DYNCAL_TEST(TestShockVelocity)
#include "tst_shock_velocity.moc"

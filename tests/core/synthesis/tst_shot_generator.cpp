// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/shot_generator.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"
#include "core/base/number_text.h"
#include "core/synthesis/sensor_simulator.h"
#include "tests/core/synthesis/simulated_shots.h"

#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <limits>
#include <set>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

std::string hashOf(const SimulatedCapture &capture)
{
    std::string text;
    for (const Shot &shot : capture.set.shots) {
        for (const Channel &channel : shot.channels)
            text += sha256OfSamples(channel.samples);
    }
    return sha256Hex(text);
}

} // namespace

class TestShotGenerator : public QObject
{
    Q_OBJECT

private slots:
    void defaults_threeShotsOfThreeChannels();
    void capture_describesTubeSensorsAndConditions();
    void range_everyPreset_wellUsedAndNeverClipped();
    void counts_goldenHash_sameOnEveryMachine();
    void counts_sameSeed_identical_otherSeed_different();
    void counts_ofAShot_independentOfTheOthers();
    void settings_nonsense_usageNamingValueAndRange();
    void stop_requested_cancelled();
    void progress_risesToOne();
    void defaultCapture_fast();
};

void TestShotGenerator::defaults_threeShotsOfThreeChannels()
{
    SimulationSettings settings;
    settings.sensor = sensorPreset("optic3").value();
    settings.duration_s = 0.004; // the rest is as by default
    const SimulatedCapture capture = simulated(settings);
    QCOMPARE(capture.set.shots.size(), std::size_t(3));
    QCOMPARE(capture.truth.size(), std::size_t(3));
    const ShotLevel levels[] = {ShotLevel::Low, ShotLevel::Medium, ShotLevel::High};
    const char *names[] = {"DUT", "Driven side", "Driver"};
    const ChannelRole roles[] = {ChannelRole::Dut, ChannelRole::DrivenSide, ChannelRole::Driver};
    std::set<std::string> hashes;
    for (std::size_t s = 0; s < 3; ++s) {
        const Shot &shot = capture.set.shots[s];
        QCOMPARE(shot.level, levels[s]);
        QVERIFY(shot.included);
        QCOMPARE(shot.input, Index(0));
        QCOMPARE(shot.channels.size(), std::size_t(3));
        for (std::size_t c = 0; c < 3; ++c) {
            const Channel &channel = shot.channels[c];
            QCOMPARE(channel.name, std::string(names[c]));
            QCOMPARE(channel.role, roles[c]);
            QCOMPARE(channel.sampleRate_Hz, 100e6);
            QCOMPARE(channel.samples.size(), Index(400000));
            QCOMPARE(channel.t0_s, -0.4e-3); // 10 % before the trigger
            QVERIFY(channel.samples.type() == SampleType::Int16);
            QCOMPARE(channel.adcBits, 14);
            QCOMPARE(*channel.adcMin, -8192.0);
            QCOMPARE(*channel.adcMax, 8191.0);
            QCOMPARE(channel.unit, std::string(c == 0 ? "V" : "Pa"));
            QCOMPARE(channel.sha256, sha256OfSamples(channel.samples));
            QVERIFY(capture.set.sensors.count(channel.sensorId) == 1);
            hashes.insert(channel.sha256);
        }
    }
    QCOMPARE(hashes.size(), std::size_t(9));
    QCOMPARE(capture.set.inputs.size(), std::size_t(1));
}

void TestShotGenerator::capture_describesTubeSensorsAndConditions()
{
    const SimulatedCapture capture = simulated(smallSettings());
    const CaptureSet &set = capture.set;
    QCOMPARE(*set.tubeNumber("driven_length_m"), 0.97);
    QCOMPARE(*set.tubeNumber("driver_length_m"), 0.97);
    QCOMPARE(*set.tubeNumber("inner_diameter_m"), 0.1);
    QCOMPARE(*set.tubeNumber("endflange_to_sensor2_m"), 0.8);
    QCOMPARE(*set.tubeNumber("u_endflange_to_sensor2_m"), 0.0002);
    QCOMPARE(set.sensors.at("dut").at("role"), std::string("dut"));
    QCOMPARE(parseNumber(set.sensors.at("dut").at("sensitivity")).value(), 5e-6);
    QCOMPARE(set.instruments.at("digitizer").at("adc_bits"), std::string("14"));
    for (std::size_t s = 0; s < set.shots.size(); ++s) {
        const Environment &environment = set.shots[s].environment;
        QCOMPARE(environment.p1_Pa, 101100.0);
        QCOMPARE(environment.u_p1_Pa, 30.0);
        QCOMPARE(environment.T1_K, 294.15);
        QCOMPARE(environment.u_T1_K, 0.3);
        QCOMPARE(environment.T4_K, 295.35);
        QCOMPARE(environment.p4_Pa, capture.truth[s].at("p4_Pa"));
        QCOMPARE(environment.relativeHumidity, 0.0); // its gas is dry
        // What was written down is not the truth, but within its stated uncertainty.
        const ShotTruth &truth = capture.truth[s];
        QVERIFY(truth.at("p1_Pa") != environment.p1_Pa);
        QVERIFY(std::abs(truth.at("p1_Pa") - environment.p1_Pa) < kSigmas * 30.0);
        QVERIFY(truth.at("T1_K") != environment.T1_K);
        QVERIFY(std::abs(truth.at("T1_K") - environment.T1_K) < kSigmas * 0.3);
        QVERIFY(truth.at("distance_m") != 0.8);
        QVERIFY(std::abs(truth.at("distance_m") - 0.8) < kSigmas * 0.0002);
    }
}

void TestShotGenerator::range_everyPreset_wellUsedAndNeverClipped()
{
    for (const SensorSpec &preset : sensorPresets()) {
        const SimulatedCapture capture = simulated(smallSettings(preset.name.c_str()));
        double highest = 0.0;
        for (const Shot &shot : capture.set.shots) {
            for (const Channel &channel : shot.channels) {
                for (Index i = 0; i < channel.samples.size(); ++i) {
                    const double count = channel.samples.at(i);
                    QVERIFY(count > *channel.adcMin && count < *channel.adcMax);
                    if (channel.role == ChannelRole::Dut)
                        highest = std::max(highest, count / *channel.adcMax);
                }
            }
        }
        QCOMPARE(capture.truth[2].at("input_range_V"), 5.0);
        QVERIFY2(highest > 0.55 && highest < 0.98,
            qPrintable(QString("%1: %2").arg(preset.name.c_str()).arg(highest)));
    }
}

void TestShotGenerator::counts_goldenHash_sameOnEveryMachine()
{
    // The counts are a promise: projects and documents quote results of simulated captures.
    const SimulatedCapture capture = simulated(smallSettings());
    QCOMPARE(QString::fromStdString(hashOf(capture)),
        QString("965d8c0aa1ccb4df466a4879b9714170602afe257b70045bf1e1176f48f640ad"));
    SimulationSettings other = smallSettings("optic4");
    other.seed = 42;
    other.bits = 16;
    other.noise = 0.05;
    other.defects = {{DefectKind::Drift, 1}, {DefectKind::RingVar, 2}, {DefectKind::Fs50, 3}};
    QCOMPARE(QString::fromStdString(hashOf(simulated(other))),
        QString("7ba497e96715b3ee854d5b516407be37ccf56dcbee08ccb9ee7e25b2630b181c"));
}

void TestShotGenerator::counts_sameSeed_identical_otherSeed_different()
{
    SimulationSettings settings = smallSettings();
    const SimulatedCapture first = simulated(settings);
    const SimulatedCapture again = simulated(settings);
    QCOMPARE(hashOf(first), hashOf(again));
    QCOMPARE(first.truth, again.truth);
    settings.seed = 2;
    const SimulatedCapture other = simulated(settings);
    for (std::size_t s = 0; s < 3; ++s) {
        for (std::size_t c = 0; c < 3; ++c)
            QVERIFY(first.set.shots[s].channels[c].sha256 != other.set.shots[s].channels[c].sha256);
        QVERIFY(first.truth[s].at("arrival_s") != other.truth[s].at("arrival_s"));
    }
}

void TestShotGenerator::counts_ofAShot_independentOfTheOthers()
{
    SimulationSettings settings = smallSettings();
    settings.shots = {ShotLevel::High, ShotLevel::High};
    const SimulatedCapture two = simulated(settings);
    settings.shots.push_back(ShotLevel::High);
    settings.defects = {{DefectKind::NoStep, 3}};
    const SimulatedCapture three = simulated(settings);
    for (std::size_t s = 0; s < 2; ++s) {
        for (std::size_t c = 0; c < 3; ++c)
            QCOMPARE(two.set.shots[s].channels[c].sha256, three.set.shots[s].channels[c].sha256);
    }
    QVERIFY(two.set.shots[0].channels[0].sha256 != two.set.shots[1].channels[0].sha256);
}

void TestShotGenerator::settings_nonsense_usageNamingValueAndRange()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [](const SimulationSettings &settings, const char *word) {
        const auto capture = simulateShots(settings);
        QVERIFY2(!capture.has_value(), word);
        QCOMPARE(capture.error().kind, ErrorKind::Usage);
        const std::string text = english(capture.error().message);
        QVERIFY2(text.find(word) != std::string::npos, text.c_str());
    };
    for (const double rate_Hz : {0.0, -1.0, 99e3, 1.1e9, nan}) {
        SimulationSettings settings = smallSettings();
        settings.sampleRate_Hz = rate_Hz;
        refused(settings, "sample_rate_hz");
    }
    for (const double duration_s : {0.0, 0.002, -1.0, 1.5, 1e300, nan}) {
        SimulationSettings settings = smallSettings();
        settings.duration_s = duration_s;
        refused(settings, "duration_s");
    }
    for (const double noise : {-0.1, 1.1, nan}) {
        SimulationSettings settings = smallSettings();
        settings.noise = noise;
        refused(settings, "noise");
    }
    for (const int bits : {-1, 0, 7, 29, 64}) {
        SimulationSettings settings = smallSettings();
        settings.bits = bits;
        refused(settings, "bits");
    }
    SimulationSettings huge = smallSettings();
    huge.sampleRate_Hz = 1e9;
    huge.duration_s = 1.0;
    refused(huge, "samples per channel");
    huge.duration_s = 0.1;
    huge.shots.assign(10, ShotLevel::Low);
    refused(huge, "samples in all");
    SimulationSettings none = smallSettings();
    none.shots.clear();
    refused(none, "number of shots");
    none.shots = {ShotLevel::Low, ShotLevel::None};
    refused(none, "low, medium or high");
    SimulationSettings sensor = smallSettings();
    sensor.sensor.modes[0].zeta = 0.0;
    refused(sensor, "zeta = 0");
    for (const double rate_Hz : {4.6e6, 4.66e6}) { // optic3 rings at 2.33 MHz
        SimulationSettings coarse = smallSettings();
        coarse.sensor = sensorPreset("optic3").value();
        coarse.sampleRate_Hz = rate_Hz;
        refused(coarse, "it needs more than 4.66 MHz");
    }
    SimulationSettings defect = smallSettings();
    defect.defects = {{DefectKind::Clip, 4}};
    refused(defect, "1 to 3");
    SimulationSettings noisy = smallSettings();
    noisy.noise = 20.0;
    QCOMPARE(english(simulateShots(noisy).error().message),
        std::string("The simulation is asked for noise = 20; it must lie in 0 .. 1."));
}

void TestShotGenerator::stop_requested_cancelled()
{
    std::stop_source source;
    JobControl control;
    control.stop = source.get_token();
    int calls = 0;
    control.progress = [&](double) {
        if (++calls == 3)
            source.request_stop();
    };
    const auto capture = simulateShots(smallSettings(), control);
    QVERIFY(!capture.has_value());
    QCOMPARE(capture.error().kind, ErrorKind::Cancelled);
    QCOMPARE(calls, 3);
}

void TestShotGenerator::progress_risesToOne()
{
    JobControl control;
    double last = 0.0;
    control.progress = [&](double fraction) {
        QVERIFY(fraction >= last);
        last = fraction;
    };
    QVERIFY(simulateShots(smallSettings(), control).has_value());
    QVERIFY(std::abs(last - 1.0) < 1e-12);
}

void TestShotGenerator::defaultCapture_fast()
{
    constexpr double kMost_s = 10.0; // 0.7 s was seen
    SimulationSettings settings;
    settings.sensor = sensorPreset("optic3").value();
    QElapsedTimer timer;
    timer.start();
    const SimulatedCapture capture = simulated(settings);
    const double elapsed_s = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
    qInfo("18 million samples in %.2f s", elapsed_s);
    QCOMPARE(capture.set.shots[2].channels[2].samples.size(), Index(2000000));
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
    QVERIFY(elapsed_s < kMost_s);
#else
    Q_UNUSED(kMost_s);
#endif
}

DYNCAL_TEST(TestShotGenerator)
#include "tst_shot_generator.moc"

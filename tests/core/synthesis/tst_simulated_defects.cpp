// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/synthesis/shot_generator.h"
#include "tests/support/test_program.h"

#include "core/base/content_hash.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/sensor_defects.h"
#include "core/synthesis/sensor_simulator.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

SimulationSettings settingsWith(const std::vector<Defect> &defects, const char *preset = "optic3")
{
    SimulationSettings settings;
    settings.sensor = sensorPreset(preset).value();
    settings.sampleRate_Hz = 20e6;
    settings.duration_s = 0.006;
    settings.defects = defects;
    return settings;
}

SimulatedCapture simulated(const SimulationSettings &settings)
{
    return simulateShots(settings).value();
}

const Channel &dutOf(const SimulatedCapture &capture, std::size_t shot)
{
    return capture.set.shots.at(shot).channels.at(0);
}

Index sampleAt(const Channel &channel, double time_s)
{
    return static_cast<Index>((time_s - channel.t0_s) * channel.sampleRate_Hz);
}

double meanBetween(const Channel &channel, double begin_s, double end_s)
{
    const Index begin = sampleAt(channel, begin_s);
    return physicalValues(channel, begin, sampleAt(channel, end_s) - begin).mean();
}

/// Longest run of samples at the upper rail.
Index longestClippedRun(const Channel &channel)
{
    Index longest = 0;
    Index run = 0;
    for (Index i = 0; i < channel.samples.size(); ++i) {
        run = channel.samples.at(i) >= *channel.adcMax ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    return longest;
}

/// Every channel of the shots that the defect does not concern is as without it.
void verifyOthersUntouched(const SimulationSettings &settings, Index concerned)
{
    SimulationSettings clean = settings;
    clean.defects.clear();
    const SimulatedCapture with = simulated(settings);
    const SimulatedCapture without = simulated(clean);
    for (std::size_t s = 0; s < with.set.shots.size(); ++s) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (static_cast<Index>(s) + 1 != concerned)
                QCOMPARE(
                    with.set.shots[s].channels[c].sha256, without.set.shots[s].channels[c].sha256);
        }
    }
}

} // namespace

class TestSimulatedDefects : public QObject
{
    Q_OBJECT

private slots:
    void parse_everyKind_data();
    void parse_everyKind();
    void parse_shotNumber();
    void parse_nonsense_usage_data();
    void parse_nonsense_usage();
    void oneShot_othersUntouched_data();
    void oneShot_othersUntouched();
    void withoutShotNumber_concernsAll();
    void clip_ringing_railCutsIt();
    void clip_withoutOvershoot_railCutsTheStep();
    void nan_threeInvalidSamplesInsideTheResponse();
    void swap_rolesExchangedNamesKept();
    void noStep_onlyNoise();
    void short_endsSoonAfterTheStep();
    void fs50_halfTheRateSameTruth();
    void drift_twoPercentPerMillisecond();
    void psi_valuesInPsiUnderBar();
    void ringVar_oneShotRingsDifferently();
    void ringVar_firstComponentBelow95Percent();
    void several_defectsAtOnce();
};

void TestSimulatedDefects::parse_everyKind_data()
{
    QTest::addColumn<QString>("word");
    QTest::addColumn<int>("kind");
    const std::pair<const char *, DefectKind> kinds[] = {{"clip", DefectKind::Clip},
        {"nan", DefectKind::Nan}, {"swap", DefectKind::Swap}, {"nostep", DefectKind::NoStep},
        {"short", DefectKind::Short}, {"fs50", DefectKind::Fs50}, {"drift", DefectKind::Drift},
        {"psi", DefectKind::Psi}, {"ringvar", DefectKind::RingVar}};
    for (const auto &[word, kind] : kinds)
        QTest::newRow(word) << QString(word) << static_cast<int>(kind);
}

void TestSimulatedDefects::parse_everyKind()
{
    QFETCH(QString, word);
    QFETCH(int, kind);
    const auto plain = parseDefect(word.toStdString());
    QVERIFY(plain.has_value());
    QCOMPARE(static_cast<int>(plain->kind), kind);
    QCOMPARE(plain->shot, Index(0));
    const auto numbered = parseDefect(word.toStdString() + "@12");
    QVERIFY(numbered.has_value());
    QCOMPARE(static_cast<int>(numbered->kind), kind);
    QCOMPARE(numbered->shot, Index(12));
}

void TestSimulatedDefects::parse_shotNumber()
{
    QCOMPARE(parseDefect("clip@1")->shot, Index(1));
    QCOMPARE(parseDefect("clip@003")->shot, Index(3));
}

void TestSimulatedDefects::parse_nonsense_usage_data()
{
    QTest::addColumn<QString>("text");
    for (const char *text :
        {"", "@", "@2", "clap", "Clip", "clip ", " clip", "clip@", "clip@0", "clip@-1", "clip@x",
            "clip@2x", "clip@2.0", "clip@ 2", "clip@2@3", "clip@99999999999999999999", "clip2"})
        QTest::newRow(text) << QString(text);
}

void TestSimulatedDefects::parse_nonsense_usage()
{
    QFETCH(QString, text);
    const auto defect = parseDefect(text.toStdString());
    QVERIFY(!defect.has_value());
    QCOMPARE(defect.error().kind, ErrorKind::Usage);
    const std::string sentence = english(defect.error().message);
    const bool unknown = sentence.find("clip, nan, swap, nostep, short, fs50, drift, psi, ringvar")
        != std::string::npos;
    QVERIFY2(unknown || sentence.find("'@'") != std::string::npos, sentence.c_str());
}

void TestSimulatedDefects::oneShot_othersUntouched_data()
{
    parse_everyKind_data();
}

void TestSimulatedDefects::oneShot_othersUntouched()
{
    QFETCH(QString, word);
    const auto defect = parseDefect(word.toStdString() + "@2");
    // The range of the converter is common to all shots; at this noise it has room to spare.
    verifyOthersUntouched(settingsWith({*defect}), 2);
}

void TestSimulatedDefects::withoutShotNumber_concernsAll()
{
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::Psi, 0}}));
    for (std::size_t s = 0; s < 3; ++s)
        QCOMPARE(dutOf(capture, s).unit, std::string("bar"));
    // Only "unlike the others" cannot be said of all.
    const SimulationSettings ringVar = settingsWith({{DefectKind::RingVar, 0}});
    QVERIFY(!hasDefect(ringVar, DefectKind::RingVar, 1));
    QVERIFY(hasDefect(ringVar, DefectKind::RingVar, 2));
    QVERIFY(!hasDefect(ringVar, DefectKind::RingVar, 3));
}

void TestSimulatedDefects::clip_ringing_railCutsIt()
{
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::Clip, 3}}));
    QVERIFY(longestClippedRun(dutOf(capture, 2)) >= 3);
    QCOMPARE(longestClippedRun(dutOf(capture, 0)), Index(0));
    const Channel &dut = dutOf(capture, 2);
    const ShotTruth &truth = capture.truth[2];
    const double plateau_V = truth.at("step_Pa") * truth.at("sensitivity");
    const double rail_V = physicalValue(dut, *dut.adcMax);
    QVERIFY(rail_V > 1.3 * plateau_V && rail_V < 1.6 * plateau_V);
    // Nothing is clipped before the step, and the plateau itself is whole.
    for (Index i = 0; i < sampleAt(dut, truth.at("arrival_s")); ++i)
        QVERIFY(dut.samples.at(i) < *dut.adcMax);
    const double settled
        = meanBetween(dut, truth.at("arrival_s") + 1e-4, truth.at("arrival_s") + 1e-3);
    QVERIFY(std::abs(settled / plateau_V - 1.0) < 1e-3);
}

void TestSimulatedDefects::clip_withoutOvershoot_railCutsTheStep()
{
    SimulationSettings settings = settingsWith({{DefectKind::Clip, 0}}, "optic4");
    settings.sensor.modes[0].zeta = 0.9;
    const SimulatedCapture capture = simulated(settings);
    for (std::size_t s = 0; s < 3; ++s)
        QVERIFY(longestClippedRun(dutOf(capture, s)) > 1000);
    const SimulatedCapture damped = simulated(settingsWith({{DefectKind::Clip, 0}}, "optic1"));
    for (std::size_t s = 0; s < 3; ++s)
        QVERIFY(longestClippedRun(dutOf(damped, s)) >= 3);
}

void TestSimulatedDefects::nan_threeInvalidSamplesInsideTheResponse()
{
    const SimulationSettings settings = settingsWith({{DefectKind::Nan, 2}});
    const SimulatedCapture capture = simulated(settings);
    const SimulatedCapture clean = simulated(settingsWith({}));
    const Channel &spoiled = dutOf(capture, 1);
    const Channel &whole = dutOf(clean, 1);
    QVERIFY(spoiled.samples.type() == SampleType::Float64);
    QCOMPARE(spoiled.samples.size(), whole.samples.size());
    QVERIFY(spoiled.sha256 == sha256OfSamples(spoiled.samples));
    Index invalid = 0;
    for (Index i = 0; i < spoiled.samples.size(); ++i) {
        const double value = physicalValue(spoiled, spoiled.samples.at(i));
        if (std::isnan(value)) {
            ++invalid;
            const double after_s = spoiled.timeOf_s(i) - capture.truth[1].at("arrival_s");
            QVERIFY(after_s >= 50e-6 && after_s < 50.3e-6);
        } else {
            QCOMPARE(value, physicalValue(whole, whole.samples.at(i)));
        }
    }
    QCOMPARE(invalid, Index(3));
    QVERIFY(std::abs(*spoiled.adcMax - physicalValue(whole, *whole.adcMax)) < 1e-12);
}

void TestSimulatedDefects::swap_rolesExchangedNamesKept()
{
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::Swap, 2}}));
    const SimulatedCapture clean = simulated(settingsWith({}));
    const Shot &shot = capture.set.shots[1];
    QCOMPARE(shot.channels[0].name, std::string("DUT"));
    QCOMPARE(shot.channels[0].role, ChannelRole::DrivenSide);
    QCOMPARE(shot.channels[1].name, std::string("Driven side"));
    QCOMPARE(shot.channels[1].role, ChannelRole::Dut);
    for (std::size_t c = 0; c < 3; ++c)
        QCOMPARE(shot.channels[c].sha256, clean.set.shots[1].channels[c].sha256);
    QCOMPARE(capture.set.shots[0].channels[0].role, ChannelRole::Dut);
}

void TestSimulatedDefects::noStep_onlyNoise()
{
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::NoStep, 2}}));
    const ShotTruth &truth = capture.truth[1];
    const double noise_V = truth.at("noise_sd_V");
    QVERIFY(noise_V > 0.0);
    const Channel &dut = dutOf(capture, 1);
    const Eigen::VectorXd values = physicalValues(dut, 0, dut.samples.size());
    QVERIFY(std::abs(values.mean()) < noise_V * 0.05);
    QVERIFY(values.cwiseAbs().maxCoeff() < 6.0 * noise_V);
    QCOMPARE(truth.at("step_Pa"), 0.0);
    QVERIFY(truth.count("arrival_s") == 0);
    QVERIFY(truth.count("velocity_m_s") == 0);
    // The diaphragm held: the side sensor is quiet, the driver keeps its pressure.
    const Channel &side = capture.set.shots[1].channels[1];
    QVERIFY(physicalValues(side, 0, side.samples.size()).cwiseAbs().maxCoeff() < 6.0 * 175.0);
    const Channel &driver = capture.set.shots[1].channels[2];
    QVERIFY(
        std::abs(meanBetween(driver, 4e-3, 5e-3) / meanBetween(driver, -5e-4, 0.0) - 1.0) < 1e-3);
}

void TestSimulatedDefects::short_endsSoonAfterTheStep()
{
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::Short, 3}}));
    const Channel &dut = dutOf(capture, 2);
    const double end_s = dut.timeOf_s(dut.samples.size());
    QVERIFY(std::abs(end_s - capture.truth[2].at("arrival_s") - 0.4e-3) < 1.1 / dut.sampleRate_Hz);
    for (const Channel &channel : capture.set.shots[2].channels)
        QCOMPARE(channel.samples.size(), dut.samples.size());
    const SimulatedCapture clean = simulated(settingsWith({}));
    for (Index i = 0; i < dut.samples.size(); ++i)
        QCOMPARE(dut.samples.at(i), dutOf(clean, 2).samples.at(i));
}

void TestSimulatedDefects::fs50_halfTheRateSameTruth()
{
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::Fs50, 3}}));
    const SimulatedCapture clean = simulated(settingsWith({}));
    QCOMPARE(capture.truth, clean.truth);
    for (std::size_t c = 0; c < 3; ++c) {
        const Channel &half = capture.set.shots[2].channels[c];
        const Channel &full = clean.set.shots[2].channels[c];
        QCOMPARE(half.sampleRate_Hz, 0.5 * full.sampleRate_Hz);
        QCOMPARE(half.samples.size() * 2, full.samples.size());
        QCOMPARE(half.t0_s, full.t0_s);
    }
    const double step_V = capture.truth[2].at("step_Pa") * capture.truth[2].at("sensitivity");
    const double begin_s = capture.truth[2].at("arrival_s") + 1e-4;
    QVERIFY(
        std::abs(meanBetween(dutOf(capture, 2), begin_s, begin_s + 1e-3) / step_V - 1.0) < 1e-3);
}

void TestSimulatedDefects::drift_twoPercentPerMillisecond()
{
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::Drift, 1}}));
    const Channel &dut = dutOf(capture, 0);
    const double step_V = capture.truth[0].at("step_Pa") * capture.truth[0].at("sensitivity");
    const double t0_s = dut.t0_s;
    const double rise
        = meanBetween(dut, t0_s + 2.0e-3, t0_s + 2.2e-3) - meanBetween(dut, t0_s, t0_s + 0.2e-3);
    QVERIFY2(std::abs(rise / step_V - 0.04) < 5e-4, qPrintable(QString::number(rise / step_V)));
    QCOMPARE(longestClippedRun(dut), Index(0));
    SimulationSettings lasting = settingsWith({{DefectKind::Drift, 0}});
    lasting.duration_s = 0.06; // the drift outgrows the step
    const SimulatedCapture whole = simulated(lasting);
    for (std::size_t s = 0; s < 3; ++s)
        QCOMPARE(longestClippedRun(dutOf(whole, s)), Index(0));
}

void TestSimulatedDefects::psi_valuesInPsiUnderBar()
{
    constexpr double kPascalPerPsi = 6894.757293168361;
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::Psi, 3}}));
    const Channel &dut = dutOf(capture, 2);
    QCOMPARE(dut.unit, std::string("bar"));
    const ShotTruth &truth = capture.truth[2];
    const double begin_s = truth.at("arrival_s") + 1e-4;
    const double expected = truth.at("step_Pa") / kPascalPerPsi;
    QVERIFY(expected > 55.0 && expected < 70.0);
    QVERIFY(std::abs(meanBetween(dut, begin_s, begin_s + 1e-3) / expected - 1.0) < 1e-3);
}

void TestSimulatedDefects::ringVar_oneShotRingsDifferently()
{
    const SensorSpec plain = sensorPreset("optic3").value();
    const SensorSpec loose = looselyMounted(plain);
    QVERIFY(checkSensor(loose).has_value());
    QCOMPARE(loose.modes[0].f0_Hz, plain.modes[0].f0_Hz);
    QCOMPARE(loose.modes[0].zeta, 2.0 * plain.modes[0].zeta);
    QVERIFY(loose.modes[0].weight != plain.modes[0].weight);
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::RingVar, 0}}));
    QCOMPARE(capture.truth[0].at("zeta"), 0.02);
    QCOMPARE(capture.truth[1].at("zeta"), 0.04);
    QCOMPARE(capture.truth[2].at("zeta"), 0.02);
    for (std::size_t s = 0; s < 3; ++s)
        QCOMPARE(longestClippedRun(dutOf(capture, s)), Index(0));
    for (const SensorSpec &preset : sensorPresets()) {
        QVERIFY(checkSensor(looselyMounted(preset)).has_value());
        QVERIFY(simulateShots(settingsWith({{DefectKind::RingVar, 1}}, preset.name.c_str()))
                    .has_value());
    }
}

void TestSimulatedDefects::ringVar_firstComponentBelow95Percent()
{
    for (const SensorSpec &preset : sensorPresets()) {
        const SimulatedCapture capture
            = simulated(settingsWith({{DefectKind::RingVar, 0}}, preset.name.c_str()));
        const Index count = 30000; // 1.5 ms from the step on, each shot by its own step
        Eigen::MatrixXd responses(count, 3);
        for (std::size_t s = 0; s < 3; ++s) {
            const ShotTruth &truth = capture.truth[s];
            const Channel &dut = dutOf(capture, s);
            responses.col(static_cast<Index>(s))
                = physicalValues(dut, sampleAt(dut, truth.at("arrival_s")), count)
                / (truth.at("step_Pa") * truth.at("sensitivity"));
        }
        const Eigen::Matrix3d gram = responses.transpose() * responses;
        Eigen::Vector3d direction(1.0, 1.0, 1.0); // power iteration: the largest eigenvalue
        for (int i = 0; i < 200; ++i)
            direction = (gram * direction).normalized();
        const double share = direction.dot(gram * direction) / gram.trace();
        QVERIFY2(share < 0.95, qPrintable(QString("%1 %2").arg(preset.name.c_str()).arg(share)));
    }
}

void TestSimulatedDefects::several_defectsAtOnce()
{
    const SimulatedCapture capture = simulated(settingsWith({{DefectKind::Psi, 1},
        {DefectKind::Nan, 1}, {DefectKind::Clip, 1}, {DefectKind::Short, 1}, {DefectKind::Fs50, 1},
        {DefectKind::Drift, 1}, {DefectKind::Swap, 1}, {DefectKind::Swap, 1}}));
    const Channel &dut = dutOf(capture, 0);
    QCOMPARE(dut.unit, std::string("bar"));
    QCOMPARE(dut.sampleRate_Hz, 10e6);
    QCOMPARE(dut.role, ChannelRole::DrivenSide); // asked for twice is asked for once
    QVERIFY(std::isnan(physicalValue(
        dut, dut.samples.at(sampleAt(dut, capture.truth[0].at("arrival_s") + 50e-6) + 1))));
    QVERIFY(dut.samples.size() < dutOf(capture, 2).samples.size() / 2);
}

DYNCAL_TEST(TestSimulatedDefects)
#include "tst_simulated_defects.moc"

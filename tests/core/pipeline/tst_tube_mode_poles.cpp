// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pipeline/tube_mode_poles.h"
#include "tests/support/second_order_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <string>

using namespace dyncal;

namespace {

constexpr double kSensor_Hz = 318e3;

/// A sensor's pair and one more at `frequency_Hz`.
SensorModel modelWithPairAt(double frequency_Hz, PoleClass poleClass = PoleClass::Sensor)
{
    SensorModel model = testing::secondOrderModel(kSensor_Hz, 0.02);
    const SensorModel other = testing::secondOrderModel(frequency_Hz, 0.01);
    for (Pole pole : other.poles) {
        pole.poleClass = poleClass;
        model.poles.push_back(pole);
    }
    return model;
}

FollowedPeak peakThat(bool followsGas)
{
    FollowedPeak peak;
    peak.shots = {1, 2, 3};
    for (const double frequency_Hz : {6080.0, 6400.0, 6800.0})
        peak.peaks.push_back({frequency_Hz / 15.3, frequency_Hz, 10.0});
    peak.test.followsGas = followsGas;
    return peak;
}

ShockConditionsSet tubeThatRingsAt(std::vector<double> frequencies_Hz)
{
    ShockConditionsSet set;
    for (const double frequency_Hz : frequencies_Hz) {
        ShockConditions shot;
        TubeResonance resonance;
        resonance.kind = ResonanceKind::Transverse;
        resonance.order = 0;
        resonance.m = 1;
        resonance.frequency_Hz = frequency_Hz;
        shot.resonances = {resonance};
        set.shots.push_back(shot);
    }
    return set;
}

bool isFlagged(const Pole &pole)
{
    return std::ranges::find(pole.flags, kTubeModeFlag) != pole.flags.end();
}

} // namespace

class TestTubeModePoles : public QObject
{
    Q_OBJECT

private slots:
    void peakThatFollowsTheGas_isACaution_data()
    {
        QTest::addColumn<double>("frequency_Hz");
        QTest::addColumn<bool>("isTube");
        QTest::newRow("lowest shot") << 6080.0 << true;
        QTest::newRow("between the shots") << 6550.0 << true;
        QTest::newRow("3 % above the highest") << 6990.0 << true;
        QTest::newRow("4 % above") << 7080.0 << false;
        QTest::newRow("4 % below") << 5830.0 << false;
    }
    void peakThatFollowsTheGas_isACaution()
    {
        QFETCH(double, frequency_Hz);
        QFETCH(bool, isTube);
        SensorModel model = modelWithPairAt(frequency_Hz);
        judgeTubeModes({peakThat(true)}, {}, model);
        QVERIFY(!isFlagged(model.poles[0]) && !isFlagged(model.poles[1]));
        QCOMPARE(isFlagged(model.poles[2]), isTube);
        QCOMPARE(isFlagged(model.poles[3]), isTube); // its conjugate too
        QCOMPARE(model.findings.size(), std::size_t(isTube ? 1 : 0));
        if (!isTube)
            return;
        QCOMPARE(model.findings[0].id, std::string("MOD-012"));
        QVERIFY(model.findings[0].severity == Severity::Caution);
        const std::string text = english(model.findings[0].message);
        QVERIFY2(text.find("6.08 kHz/6.4 kHz/6.8 kHz") != std::string::npos, text.c_str());
        QCOMPARE(*model.findings[0].value, 1.0);
    }

    void peakThatDoesNot_saysNothing()
    {
        SensorModel model = modelWithPairAt(6400.0);
        judgeTubeModes({peakThat(false)}, {}, model);
        QVERIFY(!isFlagged(model.poles[2]) && model.findings.empty());
    }

    void computedResonance_isANote()
    {
        SensorModel model = modelWithPairAt(6.3e3);
        judgeTubeModes({}, tubeThatRingsAt({6.0e3, 6.4e3}), model);
        QVERIFY(isFlagged(model.poles[2]));
        QCOMPARE(model.findings.size(), std::size_t(1));
        QVERIFY(model.findings[0].severity == Severity::Info);
        const std::string text = english(model.findings[0].message);
        QVERIFY2(text.find("6.3 kHz (transverse (1,0))") != std::string::npos, text.c_str());
    }

    void whatIsSeen_countsBeforeWhatIsComputed()
    {
        SensorModel model = modelWithPairAt(6400.0);
        judgeTubeModes({peakThat(true)}, tubeThatRingsAt({6.4e3}), model);
        QCOMPARE(model.findings.size(), std::size_t(1));
        QVERIFY(model.findings[0].severity == Severity::Caution);
        QCOMPARE(std::ranges::count(model.poles[2].flags, kTubeModeFlag), std::ptrdiff_t(1));
    }

    void polesInTheNoise_areFlaggedOnly()
    {
        SensorModel model = modelWithPairAt(6400.0, PoleClass::Other);
        judgeTubeModes({peakThat(true)}, {}, model);
        QVERIFY(isFlagged(model.poles[2]) && model.findings.empty());
    }

    void realPole_isNoOscillation()
    {
        SensorModel model = testing::secondOrderModel(kSensor_Hz, 0.02);
        Pole real = model.poles.front();
        real.z = 0.9;
        real.frequency_Hz = 6400.0;
        model.poles.push_back(real);
        judgeTubeModes({peakThat(true)}, tubeThatRingsAt({6.4e3}), model);
        QVERIFY(!isFlagged(model.poles.back()) && model.findings.empty());
    }
};

DYNCAL_TEST(TestTubeModePoles)
#include "tst_tube_mode_poles.moc"

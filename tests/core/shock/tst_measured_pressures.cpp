// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/pressure_units.h"
#include "core/shock/shock_estimate.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr double kT0_s = -1e-3;
constexpr double kVelocity_m_s = 512.8;
constexpr double kDistance_m = 0.8;
constexpr double kAtWall_s = 1e-3;
constexpr double kPlateau_s = 1.6e-3;
constexpr double kP1_Pa = 101100.0;
constexpr double kP4_Pa = 685e3;
constexpr double kBurst_s = kAtWall_s - 0.97 / kVelocity_m_s;

ShockStates states()
{
    return shockStates(Gas{}, kP1_Pa, 294.15, kVelocity_m_s).value();
}

struct Level
{
    double from_s;
    double value;
};

/// A record that holds each level from its time on.
Channel record(
    const char *name, ChannelRole role, const char *unit, const std::vector<Level> &levels)
{
    std::vector<double> values(6000);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double time_s = kT0_s + static_cast<double>(i) / kRate_Hz;
        for (const Level &level : levels) {
            if (time_s >= level.from_s)
                values[i] = level.value;
        }
    }
    Channel channel;
    channel.name = name;
    channel.role = role;
    channel.unit = unit;
    channel.sampleRate_Hz = kRate_Hz;
    channel.t0_s = kT0_s;
    channel.reference = PressureReference::Absolute;
    channel.samples = RawSamples(RawSamples::Counts(std::move(values)));
    return channel;
}

double side_s()
{
    return kAtWall_s - kDistance_m / kVelocity_m_s;
}

double back_s()
{
    return kAtWall_s + kDistance_m / states().reflectedVelocity_m_s;
}

/// What an absolute side sensor reads that is right, in its unit, off by `factor`.
Channel side(double pascalsPerUnit, const char *unit, double factor = 1.0, double offset_Pa = 0.0)
{
    const auto read
        = [&](double pressure_Pa) { return (factor * pressure_Pa + offset_Pa) / pascalsPerUnit; };
    return record("side", ChannelRole::DrivenSide, unit,
        {{kT0_s, read(kP1_Pa)}, {side_s(), read(states().shocked.pressure_Pa)},
            {back_s(), read(states().reflected.pressure_Pa)}});
}

Sighting sighting(const char *channel, double distance_m, double time_s)
{
    Sighting s;
    s.channel = channel;
    s.distance_m = distance_m;
    s.time_s = time_s;
    return s;
}

std::vector<MeasuredPressure> measured(const Shot &shot, const std::optional<double> &p4_Pa = {})
{
    return measuredPressures(shot, states(),
        {sighting("side", kDistance_m, side_s()), sighting("DUT", 0.0, kAtWall_s)}, kAtWall_s,
        kPlateau_s, kBurst_s, p4_Pa);
}

const MeasuredPressure *find(
    const std::vector<MeasuredPressure> &list, const char *region, const char *channel)
{
    const auto found = std::find_if(list.begin(), list.end(),
        [&](const MeasuredPressure &m) { return m.region == region && m.channel == channel; });
    return found != list.end() ? &*found : nullptr;
}

constexpr double kRounding = 1e-12;

} // namespace

class TestMeasuredPressures : public QObject
{
    Q_OBJECT

private slots:
    void sideSensor_absolute_readsP1P2P5_data()
    {
        QTest::addColumn<double>("pascals");
        QTest::addColumn<QString>("unit");
        QTest::addRow("Pa") << 1.0 << "Pa";
        QTest::addRow("bar") << 1e5 << "bar";
        QTest::addRow("psi") << pascalsPer("psi").value() << "psi";
    }

    void sideSensor_absolute_readsP1P2P5()
    {
        QFETCH(double, pascals);
        QFETCH(QString, unit);
        Shot shot;
        shot.channels = {side(pascals, unit.toStdString().c_str())};
        const auto list = measured(shot);
        QCOMPARE(list.size(), std::size_t(3));
        for (const MeasuredPressure &m : list) {
            QVERIFY2(std::abs(m.deviation()) < kRounding, m.region.c_str());
            QVERIFY(!m.wasGauge);
        }
        QCOMPARE(find(list, "p2", "side")->predicted_Pa, states().shocked.pressure_Pa);
    }

    void gauge_getsTheAmbientPressureElseP1()
    {
        Shot shot;
        shot.channels = {side(1.0, "Pa", 1.0, -kP1_Pa)};
        shot.channels[0].reference = PressureReference::Gauge;
        auto list = measured(shot);
        QVERIFY(std::abs(find(list, "p2", "side")->deviation()) < kRounding);
        QVERIFY(find(list, "p2", "side")->wasGauge);
        shot.environment.ambientPressure_Pa
            = 100e3; // 1.1 kPa below p1: a driven section under load
        list = measured(shot);
        QVERIFY(std::abs(
                    find(list, "p2", "side")->measured_Pa - (states().shocked.pressure_Pa - 1100.0))
            < 1e-6);
    }

    void dutInPascals_readsP5_volts_readNothing()
    {
        Shot shot;
        shot.channels = {record("DUT", ChannelRole::Dut, "Pa",
            {{kT0_s, kP1_Pa}, {kAtWall_s, states().reflected.pressure_Pa}})};
        const auto list = measured(shot);
        QVERIFY(find(list, "p1", "DUT") && find(list, "p5", "DUT"));
        QVERIFY(std::abs(find(list, "p5", "DUT")->deviation()) < kRounding);
        shot.channels[0].unit = "V";
        QVERIFY(measured(shot).empty());
    }

    void driver_readsP4BeforeTheBurst()
    {
        Shot shot;
        shot.channels = {record(
            "driver", ChannelRole::Driver, "Pa", {{kT0_s, kP4_Pa}, {kBurst_s, 0.6 * kP4_Pa}})};
        const auto list = measured(shot, kP4_Pa);
        // The record must reach back before the burst by 20 samples at least.
        QVERIFY(kBurst_s - kT0_s > 0.0 || list.empty());
        if (!list.empty())
            QVERIFY(std::abs(find(list, "p4", "driver")->deviation()) < kRounding);
        QVERIFY(measured(shot).empty()); // nothing to stand beside
    }

    void stateOfAFewSamples_isLeftOut()
    {
        Shot shot;
        shot.channels = {side(1.0, "Pa")};
        const auto list = measuredPressures(shot, states(),
            {sighting("side", 3e-3, kAtWall_s - 3e-3 / kVelocity_m_s)}, kAtWall_s, kPlateau_s,
            kBurst_s, {});
        QVERIFY(!find(list, "p2", "side")); // lasts 15 samples
    }

    void recordThatEndsEarly_isNotExtrapolated()
    {
        Shot shot;
        shot.channels = {side(1.0, "Pa")};
        shot.channels[0].t0_s = kAtWall_s - 1e-5; // begins behind the passing of the shock
        QVERIFY(!find(measured(shot), "p1", "side"));
        QVERIFY(!find(measured(shot), "p2", "side"));
    }

    void besides_keepsTheReadingsAndTakesOtherPredictions()
    {
        Shot shot;
        shot.channels = {side(1.0, "Pa")};
        const ShockStates other = shockStates(Gas{}, kP1_Pa, 294.15, 500.0).value();
        const auto before = measured(shot);
        const auto list = besides(before, other, {});
        QCOMPARE(list.size(), before.size());
        QCOMPARE(find(list, "p2", "side")->measured_Pa, find(before, "p2", "side")->measured_Pa);
        QCOMPARE(find(list, "p2", "side")->predicted_Pa, other.shocked.pressure_Pa);
        QCOMPARE(find(list, "p5", "side")->predicted_Pa, other.reflected.pressure_Pa);
    }
};

DYNCAL_TEST(TestMeasuredPressures)
#include "tst_measured_pressures.moc"

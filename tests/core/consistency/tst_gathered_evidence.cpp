// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/gathered_evidence.h"
#include "tests/support/made_evidence.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

Channel channelOf(const char *name, ChannelRole role, const char *unit, const char *sensor)
{
    Channel channel;
    channel.name = name;
    channel.role = role;
    channel.unit = unit;
    channel.sensorId = sensor;
    channel.sampleRate_Hz = 1e6;
    return channel;
}

CaptureSet captures(const Attributes &card)
{
    CaptureSet set;
    Shot shot;
    shot.environment.p4_Pa = 7e5;
    shot.channels = {channelOf("DUT", ChannelRole::Dut, "V", "dut"),
        channelOf("side 1", ChannelRole::DrivenSide, "kPa", "side")};
    set.shots = {shot};
    set.sensors["dut"] = card;
    set.sensors["side"] = {{"sensitivity", "7e-6"}, {"u_sensitivity", "7e-8"}};
    return set;
}

ShockConditions conditions()
{
    const ShotEvidence made = testing::madeEvidence({.places_m = {0.8}});
    ShockConditions c;
    c.shot = 1;
    c.measurement = made.measurement;
    c.step_Pa = made.step_Pa;
    c.seen = {{"side 1", made.readings[0].found}};
    return c;
}

ShotSensitivity sensitivity(double value = 12.5e-9)
{
    ShotSensitivity shot;
    shot.shot = 1;
    shot.sensitivity = value;
    shot.uLevel_relative = 1e-3;
    shot.unit = "V/Pa";
    return shot;
}

ShotEvidence evidenceWith(const Attributes &card, double value = 12.5e-9)
{
    const ShotSensitivity shot = sensitivity(value);
    return gatherEvidence(captures(card), {}, conditions(), &shot);
}

} // namespace

class TestGatheredEvidence : public QObject
{
    Q_OBJECT

private slots:
    void readings_inTheOrderOfTheSightings()
    {
        const ShotEvidence evidence = evidenceWith({});
        QCOMPARE(evidence.readings.size(), std::size_t(2));
        QCOMPARE(evidence.readings[0].channel, std::string("side 1"));
        QVERIFY(evidence.readings[0].found && !evidence.readings[0].isDut);
        QCOMPARE(*evidence.readings[0].pascals, 1e3); // kPa
        QVERIFY(std::abs(evidence.readings[0].uGain_relative - 0.01) < 1e-12);
        QVERIFY(evidence.readings[1].isDut && !evidence.readings[1].pascals);
    }

    void card_inOtherUnits_isBroughtToThatOfTheCalibration_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("number");
        QTest::addColumn<double>("factor");
        QTest::newRow("V/Pa") << "V/Pa"
                              << "12.5e-9" << 1.0;
        QTest::newRow("mV/kPa") << "mV/kPa"
                                << "0.0125" << 1e-6;
        QTest::newRow("mV/bar") << "mV/bar"
                                << "1.25" << 1e-8;
        QTest::newRow("uV/MPa") << "uV/MPa"
                                << "12500" << 1e-12;
        QTest::newRow("inverted") << "V/Pa"
                                  << "-12.5e-9" << 1.0;
    }

    void card_inOtherUnits_isBroughtToThatOfTheCalibration()
    {
        QFETCH(QString, unit);
        QFETCH(QString, number);
        QFETCH(double, factor);
        const ShotEvidence evidence = evidenceWith(
            {{"sensitivity", number.toStdString()}, {"sensitivity_unit", unit.toStdString()}});
        QVERIFY(evidence.card);
        QVERIFY(std::abs(evidence.card->sensitivity / std::abs(number.toDouble() * factor) - 1.0)
            < 1e-12);
        QCOMPARE(evidence.card->u_relative, kAssumedCard); // none is stated
    }

    void card_ofAnotherKind_isNone()
    {
        QVERIFY(!evidenceWith({{"sensitivity", "20"}, {"sensitivity_unit", "pC/bar"}}).card);
        QVERIFY(!evidenceWith({{"sensitivity", "20"}, {"sensitivity_unit", "V"}}).card);
        QVERIFY(!evidenceWith({{"sensitivity", "20"}, {"sensitivity_unit", "V/N"}}).card);
        QVERIFY(!evidenceWith({{"sensitivity", "much"}, {"sensitivity_unit", "V/Pa"}}).card);
        QVERIFY(!evidenceWith({{"sensitivity", "0"}, {"sensitivity_unit", "V/Pa"}}).card);
        QVERIFY(!evidenceWith({{"sensitivity", "20"}}).card);
        QVERIFY(!evidenceWith({}).card);
    }

    void card_inAUnitThatContradicts_isRemembered()
    {
        const Attributes amperes{{"sensitivity", "2"}, {"sensitivity_unit", "A/Pa"}};
        QCOMPARE(evidenceWith(amperes).otherUnitOfCard, std::string("A/Pa"));
        // The amplifier of a charge is between the two.
        QVERIFY(evidenceWith({{"sensitivity", "20"}, {"sensitivity_unit", "pC/bar"}})
                    .otherUnitOfCard.empty());
        QVERIFY(evidenceWith({{"sensitivity", "20"}, {"sensitivity_unit", "V/bar"}})
                    .otherUnitOfCard.empty());
        QVERIFY(evidenceWith({}).otherUnitOfCard.empty());
    }

    void sensorRecordedAsPressure_shouldReadWhatIsThere()
    {
        ShotSensitivity shot = sensitivity(0.97);
        shot.unit = "Pa/Pa";
        const auto with = [&](const Attributes &card) {
            return gatherEvidence(captures(card), {}, conditions(), &shot);
        };
        QCOMPARE(with({}).card->sensitivity, 1.0);
        QCOMPARE(with({}).card->u_relative, kAssumedCard);
        const ShotEvidence known = with({{"sensitivity", "12.5e-9"}, {"sensitivity_unit", "V/Pa"},
            {"u_sensitivity", "1.25e-10"}});
        QCOMPARE(known.card->sensitivity, 1.0);
        QVERIFY(std::abs(known.card->u_relative - 0.01) < 1e-12); // of what it was scaled with
        QVERIFY(known.otherUnitOfCard.empty());
    }

    void typedDelay_isMarked()
    {
        ShockSettings settings;
        settings.arrivalSensors = {{.channel = "side 1", .distanceToEndWall_m = 0.8}};
        QVERIFY(!gatherEvidence(captures({}), settings, conditions(), nullptr)
                     .readings[0]
                     .isDelayTyped);
        settings.arrivalSensors[0].delay_s = 1e-6;
        const ShotEvidence typed = gatherEvidence(captures({}), settings, conditions(), nullptr);
        QVERIFY(typed.readings[0].isDelayTyped && !typed.readings[1].isDelayTyped);
    }

    void statedUncertaintyOfTheCard_isTaken()
    {
        const ShotEvidence evidence = evidenceWith({{"sensitivity", "12.5e-9"},
            {"u_sensitivity", "1.25e-10"}, {"sensitivity_unit", "V/Pa"}});
        QVERIFY(std::abs(evidence.card->u_relative - 0.01) < 1e-12);
    }

    void invertedSensor_isComparedByItsSize()
    {
        QCOMPARE(*evidenceWith({}, -12.5e-9).sensitivity, 12.5e-9);
    }

    void withoutASensitivity_thereIsNone()
    {
        const ShotEvidence evidence = gatherEvidence(captures({}), {}, conditions(), nullptr);
        QVERIFY(!evidence.sensitivity && evidence.step_Pa && evidence.measurement);
    }

    void driver_needsItsState()
    {
        QVERIFY(!evidenceWith({}).driver); // conditions() has no region 4
        ShockConditions c = conditions();
        c.driver = GasState{6.8e5, 295.0, 8.0, 344.0, 0.0};
        c.driverGas = GasModel{};
        const ShotEvidence evidence = gatherEvidence(captures({}), {}, c, nullptr);
        QCOMPARE(evidence.driver->recorded_Pa, 7e5);
        QCOMPARE(evidence.driver->T4_K, 295.0);
        ShockSettings typed;
        typed.p4_Pa = 5e5;
        QCOMPARE(gatherEvidence(captures({}), typed, c, nullptr).driver->recorded_Pa, 5e5);
    }

    void typedStep_isKeptApart()
    {
        ShockConditions c = conditions();
        QVERIFY(!gatherEvidence(captures({}), {}, c, nullptr).typedStep_Pa);
        c.stepTyped = true;
        QCOMPARE(*gatherEvidence(captures({}), {}, c, nullptr).typedStep_Pa, *c.step_Pa);
    }

    void valuesThatAreNoNumbers_areNotTaken()
    {
        QVERIFY(!evidenceWith({{"sensitivity", "nan"}, {"sensitivity_unit", "V/Pa"}}).card);
        QVERIFY(!evidenceWith({{"sensitivity", "inf"}, {"sensitivity_unit", "V/Pa"}}).card);
        const ShotEvidence evidence = evidenceWith(
            {{"sensitivity", "12.5e-9"}, {"u_sensitivity", "nan"}, {"sensitivity_unit", "V/Pa"}});
        QCOMPARE(evidence.card->u_relative, kAssumedCard);
        ShockConditions c = conditions();
        c.driver = GasState{6.8e5, 295.0, 8.0, 344.0, 0.0};
        c.driverGas = GasModel{};
        CaptureSet set = captures({});
        set.shots[0].environment.p4_Pa = kUnknown;
        QVERIFY(!gatherEvidence(set, {}, c, nullptr).driver);
        set.shots[0].environment.p4_Pa = 7e5;
        c.driverGas.reset();
        QVERIFY(!gatherEvidence(set, {}, c, nullptr).driver);
    }

    void channelThatIsGone_orNoPressure_readsNoPascals()
    {
        CaptureSet set = captures({});
        set.shots[0].channels[1].unit = "V";
        const ShotEvidence volts = gatherEvidence(set, {}, conditions(), nullptr);
        QVERIFY(volts.readings[0].found && !volts.readings[0].pascals);
        set.shots[0].channels.pop_back();
        const ShotEvidence gone = gatherEvidence(set, {}, conditions(), nullptr);
        QCOMPARE(gone.readings.size(), std::size_t(2));
        QVERIFY(gone.readings[0].found && !gone.readings[0].pascals);
    }

    void withoutADut_orAVelocity_theRestIsGathered()
    {
        CaptureSet set = captures({{"sensitivity", "12.5e-9"}, {"sensitivity_unit", "V/Pa"}});
        set.shots[0].channels.erase(set.shots[0].channels.begin());
        const ShotSensitivity shot = sensitivity();
        const ShotEvidence noDut = gatherEvidence(set, {}, conditions(), &shot);
        QVERIFY(!noDut.sensitivity && !noDut.card && noDut.measurement && noDut.step_Pa);
        ShockConditions c = conditions();
        c.measurement.reset();
        const ShotEvidence noVelocity = gatherEvidence(captures({}), {}, c, &shot);
        QVERIFY(noVelocity.readings.empty() && noVelocity.sensitivity && noVelocity.step_Pa);
    }

    void everyShot_hasItsOwnCaptureAndNumber()
    {
        CaptureSet set = captures({});
        set.shots.push_back(set.shots[0]);
        set.shots[1].environment.p4_Pa = 9e5;
        ShockConditions c = conditions();
        c.shot = 2;
        c.driver = GasState{6.8e5, 295.0, 8.0, 344.0, 0.0};
        c.driverGas = GasModel{};
        const ShotEvidence evidence = gatherEvidence(set, {}, c, nullptr);
        QCOMPARE(evidence.shot, Index(2));
        QCOMPARE(evidence.driver->recorded_Pa, 9e5);
    }

    void sensorWithoutACard_hasTheAssumedGain()
    {
        CaptureSet set = captures({});
        set.sensors.clear();
        const ShotEvidence evidence = gatherEvidence(set, {}, conditions(), nullptr);
        QCOMPARE(evidence.readings[0].uGain_relative, kAssumedGain);
    }
};

DYNCAL_TEST(TestGatheredEvidence)
#include "tst_gathered_evidence.moc"

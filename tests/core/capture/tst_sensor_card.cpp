// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/sensor_card.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

Attributes card(const char *sensitivity, const char *unit, const char *u = "")
{
    return {{"sensitivity", sensitivity}, {"sensitivity_unit", unit}, {"u_sensitivity", u}};
}

Channel dutOf(const std::string &sensor)
{
    Channel channel;
    channel.name = "DUT";
    channel.role = ChannelRole::Dut;
    channel.sensorId = sensor;
    return channel;
}

/// One shot of each of these sensors.
CaptureSet shotsOf(const std::vector<std::string> &sensors)
{
    CaptureSet set;
    for (const std::string &sensor : sensors) {
        Shot shot;
        shot.channels = {dutOf(sensor)};
        set.shots.push_back(shot);
    }
    return set;
}

} // namespace

class TestSensorCard : public QObject
{
    Q_OBJECT

private slots:
    void sensitivity_isPerPascal_data()
    {
        QTest::addColumn<QString>("number");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("si");
        QTest::newRow("mV/bar") << "1.25"
                                << "mV/bar" << 1.25e-8 << "V/Pa";
        QTest::newRow("inverted") << "-2"
                                  << "V/MPa" << -2e-6 << "V/Pa";
        QTest::newRow("charge") << "20"
                                << "pC/bar" << 2e-4 << "pC/Pa";
        QTest::newRow("reads pressure") << "1"
                                        << "kPa/bar" << 0.01 << "Pa/Pa";
    }

    void sensitivity_isPerPascal()
    {
        QFETCH(QString, number);
        QFETCH(QString, unit);
        QFETCH(double, value);
        QFETCH(QString, si);
        const auto stated
            = sensitivityOfCard(card(number.toLatin1().constData(), unit.toLatin1().constData()));
        QVERIFY(stated && std::abs(stated->value / value - 1.0) < 1e-12);
        QCOMPARE(stated->unit, si.toStdString());
        QVERIFY(!stated->u_relative);
    }

    void whatIsNoSensitivity_isNone()
    {
        for (const char *number : {"", "0", "nan", "inf", "much"})
            QVERIFY(!sensitivityOfCard(card(number, "V/Pa")));
        for (const char *unit : {"", "V", "V/N", "/Pa", "V/"})
            QVERIFY(!sensitivityOfCard(card("20", unit)));
        QVERIFY(!sensitivityOfCard({}));
    }

    void uncertainty_isRelative_whateverTheUnit()
    {
        QVERIFY(std::abs(*relativeUncertaintyOfCard(card("-20", "", "0.1")) - 0.005) < 1e-15);
        QVERIFY(!relativeUncertaintyOfCard(card("20", "V/Pa", "0")));
        QVERIFY(!relativeUncertaintyOfCard(card("", "V/Pa", "0.1")));
    }

    void typedSensitivity_isHeldAgainstTheCard()
    {
        Channel channel = dutOf("dut");
        channel.unit = "V";
        const Attributes known = card("10", "mV/kPa", "0.05"); // 1e-5 V/Pa, u 0.5 %
        QVERIFY(!typedAgainstCard(known, channel, 1.0099e-5));
        QVERIFY(!typedAgainstCard(known, channel, -1e-5)); // the sign is the polarity's
        const auto said = typedAgainstCard(known, channel, 1.0101e-5);
        QVERIFY(said && said->id == "CAP-032" && said->severity == Severity::Caution);
        QCOMPARE(said->channel, std::string("DUT"));
        QVERIFY(std::abs(*said->value - 0.0101) < 1e-12);
        QVERIFY(english(said->message).find("10.101") != std::string::npos);
        const Attributes unstated = card("10", "mV/kPa");
        QVERIFY(!typedAgainstCard(unstated, channel, 1.019e-5));
        QVERIFY(typedAgainstCard(unstated, channel, 1.021e-5));
        channel.unit = "A"; // not what the card speaks of
        QVERIFY(!typedAgainstCard(known, channel, 2e-5));
    }

    void oneSensor_byItsSerialNumber()
    {
        CaptureSet set = shotsOf({"a", "b"});
        set.sensors["a"] = {{"serial", "17"}, {"model", "M"}, {"quantity", "pressure"}};
        set.sensors["b"] = {{"serial", "17"}, {"model", "M"}}; // the same one, described anew
        QVERIFY(checkOneSensor(set).empty());
        set.sensors["b"]["model"] = "N";
        const Findings said = checkOneSensor(set);
        QCOMPARE(said.size(), std::size_t(1));
        QCOMPARE(said[0].id, std::string("CAP-031"));
        QCOMPARE(said[0].shot, Index(2));
        QVERIFY(
            english(said[0].message).find("M 17, shot 2 of the sensor N 17") != std::string::npos);
        set.shots[1].included = false;
        QVERIFY(checkOneSensor(set).empty());
    }

    void withoutANumber_theIdCounts()
    {
        QVERIFY(checkOneSensor(shotsOf({"a", "a"})).empty());
        QVERIFY(checkOneSensor(shotsOf({"", "", ""})).empty()); // nobody knows
        QVERIFY(checkOneSensor(shotsOf({"a", ""})).empty());
        QCOMPARE(checkOneSensor(shotsOf({"", "a", "b"})).at(0).shot, Index(3));
        QVERIFY(checkOneSensor({}).empty());
    }
};

DYNCAL_TEST(TestSensorCard)
#include "tst_sensor_card.moc"

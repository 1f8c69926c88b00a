// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/joined_captures.h"
#include "tests/support/test_program.h"

#include <QtTest>

using namespace dyncal;

namespace {

/// `shots` shots of one file, all of the sensor "dut" with this card.
CaptureSet capture(const char *file, Index shots, const Attributes &card)
{
    CaptureSet set;
    InputFile input;
    input.path = input.file = file;
    set.inputs.push_back(input);
    Channel channel;
    channel.sensorId = "dut";
    Shot shot;
    shot.channels = {channel};
    set.shots.assign(static_cast<std::size_t>(shots), shot);
    set.sensors["dut"] = card;
    return set;
}

const Attributes &cardOfShot(const CaptureSet &set, std::size_t shot)
{
    return set.sensors.at(set.shots.at(shot).channels.front().sensorId);
}

} // namespace

class TestJoinedCaptures : public QObject
{
    Q_OBJECT

private slots:
    void numbersOfTheSecond_moveOn()
    {
        CaptureSet second = capture("b", 3, {});
        second.findings = {{.id = "CAP-006", .shot = 2}, {.id = "CAP-024"}};
        const CaptureSet all = joinedCaptures(capture("a", 2, {}), second);
        QCOMPARE(all.shots.size(), std::size_t(5));
        QCOMPARE(all.inputs.size(), std::size_t(2));
        QCOMPARE(all.shots[1].input, Index(0));
        QCOMPARE(all.shots[4].input, Index(1));
        QCOMPARE(all.findings[0].shot, Index(4));
        QCOMPARE(all.findings[1].shot, Index(0)); // of no single shot
    }

    void oneCard_staysOne()
    {
        const Attributes card{{"serial", "A1"}};
        const CaptureSet all = joinedCaptures(capture("a", 1, card), capture("b", 1, card));
        QCOMPARE(all.sensors.size(), std::size_t(1));
        QCOMPARE(all.shots[1].channels[0].sensorId, std::string("dut"));
    }

    void everyChannel_keepsItsOwnCard()
    {
        const Attributes cards[]{{{"serial", "A1"}}, {{"serial", "B2"}}, {{"serial", "C3"}}};
        CaptureSet all;
        for (const Attributes &card : cards)
            all = joinedCaptures(std::move(all), capture("f", 1, card));
        all = joinedCaptures(std::move(all), capture("f", 1, cards[1])); // a known one again
        QCOMPARE(all.sensors.size(), std::size_t(3));
        for (std::size_t shot = 0; shot < 4; ++shot)
            QCOMPARE(cardOfShot(all, shot), cards[shot < 3 ? shot : 1]);
    }

    void tube_isNeverAMixture()
    {
        CaptureSet first = capture("a", 1, {});
        CaptureSet second = capture("b", 1, {});
        second.tube = {{"driven_gas", "n2"}};
        QCOMPARE(joinedCaptures(first, second).tube, second.tube);
        first.tube = {{"driver_gas", "he"}};
        QCOMPARE(joinedCaptures(first, second).tube, first.tube);
    }
};

DYNCAL_TEST(TestJoinedCaptures)
#include "tst_joined_captures.moc"

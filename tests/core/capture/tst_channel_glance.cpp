// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/channel_glance.h"
#include "tests/support/simulated_example.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace dyncal;

namespace {

/// Noise of sd 1, and from `at` on a step with a ringing of the same height.
std::vector<double> ringingStep(double height, std::size_t at, unsigned seed, double ringing = 1.0)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise;
    std::vector<double> values(20000);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double t = static_cast<double>(i) - static_cast<double>(at);
        const double response
            = t < 0.0 ? 0.0 : height * (1.0 - ringing * std::exp(-t / 300.0) * std::cos(0.5 * t));
        values[i] = noise(random) + response;
    }
    return values;
}

} // namespace

/// What is said of a record before anything is known about it, on records whose truth is known.
class TestChannelGlance : public QObject
{
    Q_OBJECT

private slots:
    void step_isFoundWithItsNoise();
    void ofAChannel_isInItsUnit();
    void noStep_isNone();
    void trace_holdsEverySample();
    void invalidSamples_areLeftOut();
    void roles_ofSimulatedShots_areTheirs();
    void roles_withoutAStep_areOther();
    void roles_atOnce_theOneThatRingsIsTheDut();
    void roles_doNotDependOnTheOrder();
};

void TestChannelGlance::step_isFoundWithItsNoise()
{
    for (const unsigned seed : {1U, 2U, 3U}) {
        const ChannelGlance glance
            = glanceAt(std::span<const double>(ringingStep(50.0, 8130, seed)));
        QVERIFY(glance.steps());
        QVERIFY(std::abs(glance.noise - 1.0) < 0.1);
        QVERIFY(std::abs(glance.step - 50.0) < 10.0);
        QVERIFY(std::abs(static_cast<double>(glance.stepAt) - 40.65) <= 1.5); // of 100 stretches
    }
}

/// Counts of a quarter of a millivolt behind an offset, upside down and amplified tenfold.
void TestChannelGlance::ofAChannel_isInItsUnit()
{
    const std::vector<double> counts = ringingStep(50.0, 8130, 4);
    const ChannelGlance ofCounts = glanceAt(std::span<const double>(counts));
    Channel channel;
    channel.samples = RawSamples(std::vector<double>(counts));
    channel.polynomial = {3.0, 0.25e-3};
    channel.polarity = -1.0;
    channel.userScale = 0.1;
    const ChannelGlance glance = glanceAt(channel);
    constexpr double kVoltsPerCount = -0.25e-4;
    QVERIFY(std::abs(glance.step / (kVoltsPerCount * ofCounts.step) - 1.0) < 1e-9);
    QVERIFY(std::abs(glance.noise / std::abs(kVoltsPerCount * ofCounts.noise) - 1.0) < 1e-9);
    QCOMPARE(glance.trace.size(), ofCounts.trace.size());
    for (std::size_t i = 0; i < glance.trace.size(); ++i) {
        QVERIFY(glance.trace[i].min <= glance.trace[i].max);
        QCOMPARE(glance.trace[i].min, physicalValue(channel, ofCounts.trace[i].max));
    }
}

void TestChannelGlance::noStep_isNone()
{
    for (unsigned seed = 1; seed <= 50; ++seed)
        QVERIFY(!glanceAt(std::span<const double>(ringingStep(0.0, 8130, seed))).steps());
    QVERIFY(!glanceAt(std::span<const double>(std::vector<double>(500, 2.5))).steps());
    QVERIFY(!glanceAt(std::span<const double>()).steps());
    QVERIFY(glanceAt(std::span<const double>()).trace.empty());
}

void TestChannelGlance::trace_holdsEverySample()
{
    const std::vector<double> values = ringingStep(20.0, 5000, 4);
    const ChannelGlance glance = glanceAt(std::span(values));
    QCOMPARE(glance.trace.size(), std::size_t(100));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const SampleExtremes &stretch = glance.trace[i / 200];
        QVERIFY(stretch.any && stretch.min <= values[i] && values[i] <= stretch.max);
    }
    // A record that is not in memory as numbers is looked at in parts, to the same end.
    const ChannelGlance read = glanceAt(RawSamples(values));
    QCOMPARE(read.trace.size(), glance.trace.size());
    QCOMPARE(read.stepAt, glance.stepAt);
    QCOMPARE(read.step, glance.step);
}

void TestChannelGlance::invalidSamples_areLeftOut()
{
    std::vector<double> values = ringingStep(50.0, 8130, 5);
    for (std::size_t i = 0; i < values.size(); i += 7)
        values[i] = std::numeric_limits<double>::quiet_NaN();
    const ChannelGlance glance = glanceAt(std::span<const double>(values));
    QVERIFY(glance.steps());
    QVERIFY(std::isfinite(glance.noise) && std::isfinite(glance.step));
    QVERIFY(glance.trace.front().invalid);
    const std::vector<double> nothing(100, std::numeric_limits<double>::quiet_NaN());
    QVERIFY(!glanceAt(std::span(nothing)).steps());
}

void TestChannelGlance::roles_ofSimulatedShots_areTheirs()
{
    const auto set = testing::simulatedExample(1e7);
    for (const Shot &shot : set->shots) {
        std::vector<ChannelGlance> glances;
        for (const Channel &channel : shot.channels)
            glances.push_back(glanceAt(channel.samples));
        const std::vector<ChannelRole> roles = proposedRoles(glances);
        for (std::size_t i = 0; i < roles.size(); ++i) {
            const ChannelRole truth = shot.channels[i].role;
            if (truth == ChannelRole::Dut || truth == ChannelRole::DrivenSide)
                QCOMPARE(roles[i], truth);
            else
                QVERIFY(roles[i] != ChannelRole::Dut && roles[i] != ChannelRole::DrivenSide);
        }
    }
}

void TestChannelGlance::roles_withoutAStep_areOther()
{
    const std::vector<ChannelGlance> channels{
        glanceAt(std::span<const double>(ringingStep(0.0, 100, 6))),
        glanceAt(std::span<const double>(ringingStep(0.0, 100, 7)))};
    QCOMPARE(proposedRoles(channels), std::vector<ChannelRole>(2, ChannelRole::Other));
    QVERIFY(proposedRoles({}).empty());
}

void TestChannelGlance::roles_atOnce_theOneThatRingsIsTheDut()
{
    const std::vector<ChannelGlance> channels{
        glanceAt(std::span<const double>(ringingStep(80.0, 8130, 8, 0.0))),
        glanceAt(std::span<const double>(ringingStep(40.0, 8130, 9, 1.0)))};
    QCOMPARE(
        proposedRoles(channels), (std::vector<ChannelRole>{ChannelRole::Other, ChannelRole::Dut}));
}

void TestChannelGlance::roles_doNotDependOnTheOrder()
{
    std::vector<ChannelGlance> channels{
        glanceAt(std::span<const double>(ringingStep(40.0, 9000, 10))),
        glanceAt(std::span<const double>(ringingStep(40.0, 6000, 11))),
        glanceAt(std::span<const double>(ringingStep(0.0, 6000, 12)))};
    std::vector<ChannelRole> roles{ChannelRole::Dut, ChannelRole::DrivenSide, ChannelRole::Other};
    std::vector<std::size_t> order{0, 1, 2};
    do {
        std::vector<ChannelGlance> shuffled;
        std::vector<ChannelRole> expected;
        for (const std::size_t i : order) {
            shuffled.push_back(channels[i]);
            expected.push_back(roles[i]);
        }
        QCOMPARE(proposedRoles(shuffled), expected);
    } while (std::ranges::next_permutation(order).found);
}

DYNCAL_TEST(TestChannelGlance)
#include "tst_channel_glance.moc"

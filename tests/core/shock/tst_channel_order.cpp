// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/channel_order.h"
#include "core/shock/shock_velocity.h"
#include "core/signal/record_starts.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;

/// A step with a little noise at a sample.
Channel stepAt(const char *name, ChannelRole role, Index sample)
{
    std::mt19937 random(static_cast<unsigned>(sample));
    std::normal_distribution<double> noise(0.0, 0.01);
    std::vector<double> values(6000);
    for (Index i = 0; i < 6000; ++i)
        values[static_cast<std::size_t>(i)] = (i >= sample ? 1.0 : 0.0) + noise(random);
    Channel channel;
    channel.name = name;
    channel.role = role;
    channel.sampleRate_Hz = kRate_Hz;
    channel.samples = RawSamples(RawSamples::Counts(std::move(values)));
    return channel;
}

CaptureSet setOf(Index dut, Index side)
{
    Shot shot;
    shot.channels
        = {stepAt("Sensor", ChannelRole::Dut, dut), stepAt("Wall", ChannelRole::DrivenSide, side)};
    CaptureSet set;
    set.shots = {shot};
    return set;
}

std::vector<DutArrival> arrivalAt(Index sample)
{
    return {{1, static_cast<double>(sample) / kRate_Hz}};
}

Findings checked(const CaptureSet &set, const std::vector<DutArrival> &arrivals)
{
    return checkChannelOrder(set, arrivals, detectStarts(set, {}).value());
}

} // namespace

class TestChannelOrder : public QObject
{
    Q_OBJECT

private slots:
    void dutFirst_isCap010WithTheTimeBetween()
    {
        const Findings findings = checked(setOf(2000, 3500), arrivalAt(2000));
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings[0].id, std::string("CAP-010"));
        QCOMPARE(findings[0].severity, Severity::Caution);
        QCOMPARE(findings[0].shot, Index(1));
        constexpr double kOneSample_s = 1e-6;
        QVERIFY(std::abs(findings[0].value.value() - 1.5e-3) <= kOneSample_s);
        const QString text = QString::fromStdString(english(findings[0].message));
        QVERIFY2(text.contains("'Sensor' 1.5 ms before 'Wall'"), qPrintable(text));
    }

    void sideFirst_isAsItShouldBe()
    {
        QVERIFY(checked(setOf(3500, 2000), arrivalAt(3500)).empty());
    }

    void sameTime_isNoSwap() { QVERIFY(checked(setOf(2000, 2003), arrivalAt(2000)).empty()); }

    void withoutSideSensorOrArrival_nothingIsSaid()
    {
        CaptureSet set = setOf(2000, 3500);
        QVERIFY(checked(set, {}).empty());
        set.shots[0].channels.pop_back();
        QVERIFY(checked(set, arrivalAt(2000)).empty());
    }

    void excludedShot_isNotLookedAt()
    {
        CaptureSet set = setOf(2000, 3500);
        set.shots[0].included = false;
        QVERIFY(checked(set, arrivalAt(2000)).empty());
    }
};

DYNCAL_TEST(TestChannelOrder)
#include "tst_channel_order.moc"

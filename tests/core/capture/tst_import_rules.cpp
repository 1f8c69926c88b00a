// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/content_hash.h"
#include "core/capture/capture_check.h"
#include "core/capture/import_rules.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

Channel channel(const char *name, std::vector<double> values, double rate_Hz = 1e6)
{
    Channel c;
    c.name = name;
    c.samples = RawSamples(RawSamples::Counts(std::move(values)));
    c.sampleRate_Hz = rate_Hz;
    c.sha256 = sha256OfSamples(c.samples);
    return c;
}

Channel counts(const char *name, std::vector<std::int16_t> values)
{
    Channel c = channel(name, {});
    c.samples = RawSamples(RawSamples::Counts(std::move(values)));
    c.sha256 = sha256OfSamples(c.samples);
    return c;
}

CaptureSet set(std::vector<std::vector<Channel>> shots)
{
    CaptureSet s;
    for (auto &channels : shots) {
        Shot shot;
        shot.channels = std::move(channels);
        s.shots.push_back(std::move(shot));
    }
    return s;
}

std::vector<double> ramp(int count, double step = 1.0)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(i * step);
    return values;
}

const Finding *find(const Findings &findings, const std::string &id)
{
    const auto found = std::find_if(
        findings.begin(), findings.end(), [&](const Finding &f) { return f.id == id; });
    return found != findings.end() ? &*found : nullptr;
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

} // namespace

class TestImportRules : public QObject
{
    Q_OBJECT

private slots:
    void oneChannel_isTheDut()
    {
        const auto done = applyImportSettings(set({{channel("x", ramp(9))}}), {});
        QVERIFY(done && done->shots[0].channelWithRole(ChannelRole::Dut));
    }

    void twoChannelsWithoutRole_stayOther()
    {
        const auto done
            = applyImportSettings(set({{channel("x", ramp(9)), channel("y", ramp(9))}}), {});
        QVERIFY(done && !done->shots[0].channelWithRole(ChannelRole::Dut));
        QVERIFY(find(checkCaptures(*done), "CAP-002"));
    }

    void recipeRole_replacesTheFiles()
    {
        CaptureSet s = set({{channel("x", ramp(9)), channel("y", ramp(9))}});
        s.shots[0].channels[0].role = ChannelRole::Dut;
        ImportSettings settings;
        settings.channels = {{"y", "dut"}};
        const auto done = applyImportSettings(s, settings);
        QVERIFY(done.has_value());
        QCOMPARE(done->shots[0].channelWithRole(ChannelRole::Dut)->name, std::string("y"));
        QCOMPARE(done->shots[0].channels[0].role, ChannelRole::Other);
    }

    void unknownChannel_isRefusedWithTheKnownOnes()
    {
        ImportSettings settings;
        settings.channels = {{"z", "dut"}};
        const auto done
            = applyImportSettings(set({{channel("x", ramp(9)), channel("y", ramp(9))}}), settings);
        QVERIFY(!done);
        QCOMPARE(done.error().kind, ErrorKind::Usage);
        QVERIFY(english(done.error().message).find("'x', 'y'") != std::string::npos);
    }

    void missingRate_isRefusedUnlessGiven()
    {
        ImportSettings settings;
        QVERIFY(!applyImportSettings(set({{channel("x", ramp(9), 0.0)}}), settings));
        settings.sampleRate_Hz = 5e4;
        const auto done = applyImportSettings(set({{channel("x", ramp(9), 0.0)}}), settings);
        QVERIFY(done && done->shots[0].channels[0].sampleRate_Hz == 5e4);
        QVERIFY(!find(done->findings, "CAP-025"));
        const auto replaced = applyImportSettings(set({{channel("x", ramp(9), 1e5)}}), settings);
        QVERIFY(find(replaced->findings, "CAP-025"));
    }

    void unitScalePolarity_actOnTheDutOnly()
    {
        CaptureSet s = set({{channel("dut", ramp(9)), channel("side", ramp(9))}});
        s.shots[0].channels[0].role = ChannelRole::Dut;
        ImportSettings settings;
        settings.unit = "kPa";
        settings.scale = 2.5;
        settings.polarity = -1;
        settings.reference = "absolute";
        const auto done = applyImportSettings(s, settings);
        const Channel &dut = done->shots[0].channels[0];
        QCOMPARE(physicalValues(dut, 2, 1)[0], -5.0);
        QCOMPARE(dut.unit, std::string("kPa"));
        QCOMPARE(dut.reference, PressureReference::Absolute);
        QCOMPARE(physicalValues(done->shots[0].channels[1], 2, 1)[0], 2.0);
    }

    void interpolation_fillsShortGapsOnly()
    {
        std::vector<double> values = ramp(20);
        values[5] = values[6] = kNaN;
        for (std::size_t i = 10; i < 14; ++i)
            values[i] = kNaN;
        ImportSettings settings;
        settings.interpolateInvalid = 2;
        const auto done = applyImportSettings(set({{channel("x", values)}}), settings);
        const Channel &dut = done->shots[0].channels[0];
        QCOMPARE(dut.samples.at(5), 5.0);
        QCOMPARE(dut.samples.at(6), 6.0);
        QVERIFY(std::isnan(dut.samples.at(11)));
        QCOMPARE(find(done->findings, "CAP-022")->value.value_or(0), 2.0);
        QCOMPARE(find(checkCaptures(*done), "CAP-006")->value.value_or(0), 4.0);
    }

    void interpolation_leavesGapsAtTheEnds()
    {
        std::vector<double> values = ramp(10);
        values.front() = values.back() = kNaN;
        ImportSettings settings;
        settings.interpolateInvalid = 5;
        const auto done = applyImportSettings(set({{channel("x", values)}}), settings);
        QVERIFY(std::isnan(done->shots[0].channels[0].samples.at(0)));
        QVERIFY(std::isnan(done->shots[0].channels[0].samples.at(9)));
    }

    void exclusion_keepsTheReasonAndOneShot()
    {
        const CaptureSet two = set({{channel("x", ramp(9))}, {channel("x", ramp(9, 2.0))}});
        ImportSettings settings;
        settings.exclude = {{2, "diaphragm held"}};
        const auto done = applyImportSettings(two, settings);
        QVERIFY(done && !done->shots[1].included);
        QCOMPARE(done->shots[1].excludeReason, std::string("diaphragm held"));
        QVERIFY(find(checkCaptures(*done), "CAP-017"));
        settings.exclude = {{1, "a"}, {2, "b"}};
        QCOMPARE(applyImportSettings(two, settings).error().kind, ErrorKind::DataBlocked);
        settings.exclude = {{3, "c"}};
        QCOMPARE(applyImportSettings(two, settings).error().kind, ErrorKind::Usage);
    }

    void levels_mustMatchTheShots()
    {
        ImportSettings settings;
        settings.levels = {"low", "high"};
        const CaptureSet two = set({{channel("x", ramp(9))}, {channel("x", ramp(9, 2.0))}});
        QCOMPARE(applyImportSettings(two, settings)->shots[1].level, ShotLevel::High);
        settings.levels = {"low"};
        QVERIFY(!applyImportSettings(two, settings));
    }

    void checks_flatAndSaturated()
    {
        const auto flat
            = applyImportSettings(set({{channel("x", std::vector<double>(50, 3.0))}}), {});
        QCOMPARE(find(checkCaptures(*flat), "CAP-008")->severity, Severity::Block);

        std::vector<std::int16_t> clipped{0, 5, 100, 100, 100, 7, -20, 3};
        const auto top = applyImportSettings(set({{counts("x", clipped)}}), {});
        const Findings findings = checkCaptures(*top);
        QVERIFY(find(findings, "CAP-007"));
        QCOMPARE(find(findings, "CAP-007")->time_s.value_or(-1), 2e-6);

        CaptureSet ranged = set({{counts("x", clipped)}});
        ranged.shots[0].channels[0].adcMax = 8191.0; // far from the rail: a plateau, no saturation
        ranged.shots[0].channels[0].adcMin = -8192.0;
        QVERIFY(!find(checkCaptures(*applyImportSettings(ranged, {})), "CAP-007"));
    }

    void checks_compareTheShots()
    {
        const auto done = applyImportSettings(
            set({{channel("x", ramp(100))}, {channel("x", ramp(50, 2.0), 5e5)},
                {channel("x", ramp(100))}, {channel("x", ramp(40, 3.0))}}),
            {});
        const Findings findings = checkCaptures(*done);
        QVERIFY(find(findings, "CAP-004"));
        QVERIFY(find(findings, "CAP-005"));
        QCOMPARE(find(findings, "CAP-011")->shot, Index(3));
        QVERIFY(!find(findings, "CAP-017"));
    }

    void checks_ofAnEmptyChannel_doNotCrash()
    {
        CaptureSet s = set({{channel("x", {})}});
        s.shots[0].channels[0].role = ChannelRole::Dut;
        QVERIFY(find(checkCaptures(s), "CAP-008"));
        s = set({{channel("x", {kNaN, kNaN})}});
        s.shots[0].channels[0].role = ChannelRole::Dut;
        QVERIFY(find(checkCaptures(s), "CAP-008"));
        QVERIFY(checkCaptures({}).empty());
    }
};

QTEST_APPLESS_MAIN(TestImportRules)
#include "tst_import_rules.moc"

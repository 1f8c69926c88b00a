// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/capture_check.h"
#include "tests/support/test_program.h"

#include "core/capture/flat_top.h"
#include "core/capture/record_survey.h"
#include "tests/core/capture/capture_test_support.h"

#include <QElapsedTimer>

#include <numbers>
#include <random>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using Counts = std::vector<std::int16_t>;

CaptureSet setOf(std::vector<Shot> shots)
{
    CaptureSet set;
    set.shots = std::move(shots);
    for (Shot &shot : set.shots) {
        for (Channel &channel : shot.channels)
            channel.sha256 = sha256OfSamples(channel.samples);
    }
    return set;
}

Findings checksOf(RawSamples::Counts counts, const CheckSettings &settings = {})
{
    Findings findings = checkCaptures(setOf({shotOf(std::move(counts))}), settings);
    std::erase_if(findings, [](const Finding &f) { return f.id == "CAP-017"; }); // one shot
    return findings;
}

const Finding *find(const Findings &findings, const std::string &id)
{
    const auto found = std::find_if(
        findings.begin(), findings.end(), [&](const Finding &f) { return f.id == id; });
    return found != findings.end() ? &*found : nullptr;
}

/// A ringing step from sample 2000 on, as values; with noise of this standard deviation.
std::vector<double> ringingStep(double noise, Index size = 8000)
{
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<double> values(static_cast<std::size_t>(size));
    for (Index i = 0; i < size; ++i) {
        const double t = static_cast<double>(i - 2000);
        const double clean = t < 0
            ? 0.0
            : 1.0 - std::exp(-t / 900.0) * std::cos(2.0 * std::numbers::pi * t / 43.0);
        values[static_cast<std::size_t>(i)] = clean + noise * normal(random);
    }
    return values;
}

std::vector<double> clippedAt(std::vector<double> values, double rail)
{
    for (double &value : values)
        value = std::min(value, rail);
    return values;
}

Counts rounded(const std::vector<double> &values, double codes)
{
    Counts counts;
    for (const double value : values)
        counts.push_back(static_cast<std::int16_t>(std::lround(value * codes)));
    return counts;
}

/// Samples in a source that cannot be read any more.
class LostSource : public SampleSource
{
public:
    bool read(Index, Index, std::byte *) const override { return false; }
};

} // namespace

class TestCaptureCheck : public QObject
{
    Q_OBJECT

private slots:
    void cleanRecord_hasNoFinding()
    {
        QVERIFY(checksOf(rounded(ringingStep(0.01), 4000.0)).empty());
        QVERIFY(checksOf(ringingStep(0.01)).empty());
    }

    void noDut_isCap002()
    {
        Shot shot = shotOf(Counts{1, 2, 3});
        shot.channels[0].role = ChannelRole::Other;
        QCOMPARE(find(checkCaptures(setOf({shot})), "CAP-002")->severity, Severity::Block);
    }

    void invalidSamples_areCountedAndPlaced()
    {
        std::vector<double> values = ringingStep(0.01);
        values[300] = values[302] = kNan;
        values[301] = std::numeric_limits<double>::infinity();
        const Findings findings = checksOf(values);
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings[0].id, std::string("CAP-006"));
        QCOMPARE(findings[0].value.value(), 3.0);
        QCOMPARE(findings[0].time_s.value(), 300e-6);
        QVERIFY(contains(english(findings[0].message), "samples 300 to 302"));
    }

    void constantChannel_isFlat_data()
    {
        QTest::addColumn<bool>("isDut");
        QTest::newRow("DUT blocks") << true;
        QTest::newRow("another is a caution") << false;
    }

    void constantChannel_isFlat()
    {
        QFETCH(bool, isDut);
        Shot shot = shotOf(Counts(50, 3));
        shot.channels[0].role = isDut ? ChannelRole::Dut : ChannelRole::Trigger;
        const Findings findings = checkCaptures(setOf({shot}));
        QCOMPARE(find(findings, "CAP-008")->severity, isDut ? Severity::Block : Severity::Caution);
    }

    void ditheringChannel_isFlatWithinItsLimit()
    {
        Counts counts(1000, 0);
        for (std::size_t i = 0; i < counts.size(); i += 2)
            counts[i] = 1; // standard deviation half a code
        const Findings findings = checksOf(counts);
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings[0].id, std::string("CAP-008"));
        QCOMPARE(findings[0].value.value(), 0.5);
        CheckSettings settings;
        settings.flatCodes = 0.4;
        QVERIFY(checksOf(counts, settings).empty());
        Shot trigger = shotOf(counts);
        trigger.channels[0].role = ChannelRole::Trigger; // one bit is all a trigger has
        QVERIFY(!find(checkCaptures(setOf({trigger})), "CAP-008"));
    }

    void shortPulseInALongQuietRecord_isNotFlat()
    {
        Counts counts(1000000, 0);
        counts[5000] = 300; // the standard deviation of all is 0.3 codes
        QVERIFY(checksOf(counts).empty());
    }

    void emptyOrInvalidChannel_isFlatAndSaysWhy_data()
    {
        QTest::addColumn<std::vector<double>>("values");
        QTest::addColumn<QString>("words");
        const double inf = std::numeric_limits<double>::infinity();
        QTest::newRow("empty") << std::vector<double>{} << "has no samples";
        QTest::newRow("NaN") << std::vector<double>{kNan, kNan}
                             << "none of its 2 samples is a number";
        QTest::newRow("infinite") << std::vector<double>{inf, -inf, kNan}
                                  << "none of its 3 samples is a number";
        QTest::newRow("one") << std::vector<double>{0.5} << "a single valid sample, 500 mV";
        QTest::newRow("one and NaN")
            << std::vector<double>{kNan, 0.5, kNan} << "a single valid sample, 500 mV";
        QTest::newRow("equal and NaN")
            << std::vector<double>{0.5, kNan, 0.5} << "all its valid samples (2) are 500 mV";
        QTest::newRow("equal") << std::vector<double>{0.5, 0.5} << "all 2 samples are 500 mV";
    }

    void emptyOrInvalidChannel_isFlatAndSaysWhy()
    {
        QFETCH(std::vector<double>, values);
        QFETCH(QString, words);
        const Findings findings = checksOf(values);
        const Finding *flat = find(findings, "CAP-008");
        QVERIFY(flat);
        QCOMPARE(flat->severity, Severity::Block);
        const QString sentence = QString::fromStdString(english(flat->message));
        QVERIFY2(sentence.contains(words), qPrintable(sentence));
        QVERIFY2(!sentence.contains("nan") && !sentence.contains("inf"), qPrintable(sentence));
    }

    void noCaptures_haveNoFindings()
    {
        QVERIFY(checkCaptures({}).empty());
        QVERIFY(find(checksOf(Counts()), "CAP-008"));
    }

    void knownRails_decideAlone()
    {
        Counts clipped = rounded(clippedAt(ringingStep(0.01), 1.4), 4000.0);
        Shot shot = shotOf(clipped);
        Channel &dut = shot.channels[0];
        dut.adcMax = 8191.0; // far from the rail: whatever it is, it is no saturation
        dut.adcMin = -8192.0;
        QVERIFY(!find(checkCaptures(setOf({shot})), "CAP-007"));
        dut.adcMax = 5600.0;
        const Findings findings = checkCaptures(setOf({shot}));
        const Finding *finding = find(findings, "CAP-007");
        QVERIFY(finding);
        QVERIFY(finding->time_s.value() >= 2000e-6);
        QCOMPARE(finding->severity, Severity::Caution);
    }

    void saturationRun_isALimit()
    {
        Shot shot = shotOf(Counts{0, 50, 100, 100, 100, 7, -20, 3, 9, -4});
        shot.channels[0].adcMax = 100.0;
        CheckSettings settings;
        QVERIFY(find(checkCaptures(setOf({shot}), settings), "CAP-007"));
        settings.saturationRun = 4;
        QVERIFY(!find(checkCaptures(setOf({shot}), settings), "CAP-007"));
    }

    void unknownRails_flatTopOfAMovingSignal_isSaturation_data()
    {
        QTest::addColumn<double>("noise");
        QTest::addColumn<bool>("asCounts");
        QTest::newRow("without noise, values") << 0.0 << false;
        QTest::newRow("without noise, counts") << 0.0 << true;
        QTest::newRow("noise, values") << 0.01 << false;
        QTest::newRow("noise, counts") << 0.01 << true;
    }

    void unknownRails_flatTopOfAMovingSignal_isSaturation()
    {
        QFETCH(double, noise);
        QFETCH(bool, asCounts);
        for (const double rail : {1.2, 1.5}) {
            const std::vector<double> values = clippedAt(ringingStep(noise), rail);
            const Findings findings
                = asCounts ? checksOf(rounded(values, 4000.0)) : checksOf(values);
            QCOMPARE(findings.size(), std::size_t(1));
            QCOMPARE(findings[0].id, std::string("CAP-007"));
            QVERIFY(findings[0].time_s.value() >= 2000e-6);
            QVERIFY(findings[0].value.value() >= 3.0);
        }
    }

    void unknownRails_noisyPlateauCutOff_isSaturation()
    {
        // A level above the limit that never comes back: one long run to the end of the record.
        std::mt19937 random(3);
        std::normal_distribution<double> normal;
        std::vector<double> values(4000);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = std::min((i < 1500 ? 0.0 : 1.1) + 0.01 * normal(random), 1.0);
        QVERIFY(find(checksOf(values), "CAP-007"));
        QVERIFY(find(checksOf(rounded(values, 4000.0)), "CAP-007"));
    }

    void unknownRails_computedPlateau_isNoSaturation_data()
    {
        QTest::addColumn<int>("rise"); ///< samples
        QTest::addColumn<bool>("falls");
        for (const int rise : {1, 2, 5, 50}) {
            QTest::addRow("step, %d", rise) << rise << false;
            QTest::addRow("pulse, %d", rise) << rise << true;
        }
    }

    void unknownRails_computedPlateau_isNoSaturation()
    {
        QFETCH(int, rise);
        QFETCH(bool, falls);
        std::vector<double> values(4000, 0.0);
        for (Index i = 1000; i < 4000; ++i)
            values[static_cast<std::size_t>(i)]
                = std::min(static_cast<double>(i - 999) / static_cast<double>(rise), 1.0);
        if (falls)
            std::fill(values.begin() + 3000, values.end(), 0.0);
        QVERIFY(checksOf(values).empty());
        QVERIFY(checksOf(rounded(values, 4000.0)).empty());
    }

    void unknownRails_roundedPeaks_areNoSaturation()
    {
        // Slow enough that several samples at a peak share one code.
        for (const double perPeriod : {50.0, 300.0, 2000.0}) {
            std::vector<double> sine(20000);
            for (std::size_t i = 0; i < sine.size(); ++i)
                sine[i] = std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / perPeriod);
            QVERIFY(checksOf(rounded(sine, 2000.0)).empty());
        }
    }

    void twins_areOneCautionThatNamesBoth()
    {
        CaptureSet set = setOf(
            {shotOf(ringingStep(0.01)), shotOf(ringingStep(0.02)), shotOf(ringingStep(0.01))});
        set.inputs = {{"d/low.h5", "low.h5", "1", "h"}, {"d/mid.h5", "mid.h5", "2", "h"},
            {"d/high.h5", "high.h5", "3", "h"}};
        for (Index i = 0; i < 3; ++i)
            set.shots[static_cast<std::size_t>(i)].input = i;
        const Findings findings = checkCaptures(set);
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings[0].id, std::string("CAP-011"));
        QCOMPARE(findings[0].shot, Index(3));
        QVERIFY(contains(english(findings[0].message), "low.h5"));
        QVERIFY(contains(english(findings[0].message), "high.h5"));
        set.shots[0].included = false;
        QVERIFY(checkCaptures(set).empty());
    }

    void shots_areCompared()
    {
        const Findings findings = checkCaptures(setOf({shotOf(ringingStep(0.01)),
            shotOf(ringingStep(0.02), 5e5), shotOf(ringingStep(0.01, 7000))}));
        QCOMPARE(findings.size(), std::size_t(2));
        QCOMPARE(find(findings, "CAP-004")->severity, Severity::Caution);
        QCOMPARE(find(findings, "CAP-005")->severity, Severity::Info);
    }

    void oneShot_isAnInfo()
    {
        const Findings findings = checkCaptures(setOf({shotOf(ringingStep(0.01))}));
        QCOMPARE(findings.size(), std::size_t(1));
        QCOMPARE(findings[0].id, std::string("CAP-017"));
    }

    void excludedShot_isNotLookedAt()
    {
        CaptureSet set = setOf({shotOf(ringingStep(0.01)), shotOf(Counts(10, 1))});
        set.shots[1].included = false;
        QVERIFY(!find(checkCaptures(set), "CAP-008"));
    }

    void samplesOutOfReach_areCap015()
    {
        Shot shot = shotOf(Counts());
        shot.channels[0].samples
            = RawSamples(std::make_shared<LostSource>(), SampleType::Int16, 100);
        const Findings findings = checkCaptures(setOf({shot}));
        QCOMPARE(find(findings, "CAP-015")->severity, Severity::Block);
        QVERIFY(!find(findings, "CAP-008"));
    }

    void survey_ofEveryType_findsExtremesAndRuns()
    {
        const auto check = [](auto zero) {
            using T = decltype(zero);
            std::vector<T> values(10000, T(20));
            for (std::size_t i = 4094; i < 4099; ++i)
                values[i] = T(90); // across the end of a stretch
            values[5000] = T(90);
            values[9000] = values[9001] = T(3);
            const RecordSurvey survey = surveyRecord(RawSamples(RawSamples::Counts(values)));
            QCOMPARE(survey.highest, 90.0);
            QCOMPARE(survey.lowest, 3.0);
            QCOMPARE(survey.top.begin, Index(4094));
            QCOMPARE(survey.top.count, Index(5));
            QCOMPARE(survey.bottom.begin, Index(9000));
            QCOMPARE(survey.bottom.count, Index(2));
            QCOMPARE(survey.invalid, Index(0));
        };
        check(std::int8_t());
        check(std::uint8_t());
        check(std::int16_t());
        check(std::uint16_t());
        check(std::int32_t());
        check(float());
        check(double());
    }

    void survey_extremesOfTheType_doNotOverflow()
    {
        std::vector<std::int16_t> values(100000, -32768);
        const RecordSurvey all = surveyRecord(RawSamples(RawSamples::Counts(values)));
        QVERIFY(all.isConstant());
        QCOMPARE(all.sd, 0.0);
        for (std::size_t i = 0; i < values.size(); i += 2)
            values[i] = 32767;
        const RecordSurvey half = surveyRecord(RawSamples(RawSamples::Counts(values)));
        QCOMPARE(half.sd, 32767.5);
        std::vector<std::uint16_t> large(100000, 65535);
        for (std::size_t i = 0; i < large.size(); i += 2)
            large[i] = 65533; // squares beyond 31 bits
        QVERIFY(std::abs(surveyRecord(RawSamples(RawSamples::Counts(large))).sd - 1.0) < 1e-5);
        std::ranges::fill(large, std::uint16_t(65535));
        large[1] = 65534;
        QVERIFY(surveyRecord(RawSamples(RawSamples::Counts(large))).sd < 0.01);
        std::vector<std::int32_t> wide(10000, std::numeric_limits<std::int32_t>::min());
        wide[0] = std::numeric_limits<std::int32_t>::max();
        QCOMPARE(surveyRecord(RawSamples(RawSamples::Counts(wide))).highest, 2147483647.0);
    }

    void survey_runInterruptedByInvalidSamples_isTwoRuns()
    {
        std::vector<double> values(9000, 0.0);
        for (std::size_t i = 4000; i < 4300; ++i)
            values[i] = 1.0;
        values[4100] = kNan;
        const RecordSurvey survey = surveyRecord(RawSamples(RawSamples::Counts(values)));
        QCOMPARE(survey.top.begin, Index(4101));
        QCOMPARE(survey.top.count, Index(199));
        QCOMPARE(survey.invalid, Index(1));
    }

    void survey_largeRecord_isQuick()
    {
        // 100 MS of int16 are to take well under 0.2 s; a tenth of it here, with tenfold room for a
        // busy machine.
        constexpr qint64 kLimit_ms = 200;
        Counts counts(10000000);
        for (std::size_t i = 0; i < counts.size(); ++i)
            counts[i] = static_cast<std::int16_t>((i * 2654435761U >> 16) & 0x3fff);
        const RawSamples samples{RawSamples::Counts(counts)};
        QElapsedTimer timer;
        timer.start();
        const RecordSurvey survey = surveyRecord(samples);
        const qint64 took_ms = timer.elapsed();
        qInfo("10 MS of int16 in %lld ms", took_ms);
        QVERIFY(survey.highest > 1000.0);
        QVERIFY(took_ms < kLimit_ms);
    }
};

DYNCAL_TEST(TestCaptureCheck)
#include "tst_capture_check.moc"

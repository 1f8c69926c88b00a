// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rate and length of the model input: the rules of docs/method/model-input.md as they are written,
// over sensors from a hertz to gigahertz, and at the edges.

#include "core/realization/input/rate_choice.h"
#include "core/signal/resampler.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace dyncal;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

SpectrumResult spectrumWith(double frequency_Hz, double q)
{
    SpectrumResult spectrum;
    spectrum.resonances.push_back({frequency_Hz, 30.0, q, {}});
    spectrum.resonances.push_back({3.0 * frequency_Hz, 10.0, 2.0 * q, {}});
    return spectrum;
}

SensorTraits ringing(double resonance_Hz, double ringTime_s)
{
    SensorTraits traits;
    traits.ringing = {{resonance_Hz, ringTime_s}};
    return traits;
}

/// Span of the filter as the page has it, 12 M / rate.
double span_s(double rate_Hz, Index factor)
{
    return factor > 1 ? 12.0 * static_cast<double>(factor) / rate_Hz : 0.0;
}

/// 1, 2, 5, 10 ...: the one behind `factor`.
Index nextStep(Index factor)
{
    Index decade = 1;
    while (10 * decade <= factor)
        decade *= 10;
    return factor == decade ? 2 * decade : factor == 2 * decade ? 5 * decade : 10 * decade;
}

} // namespace

class TestRateChoice : public QObject
{
    Q_OBJECT

private slots:
    void reduction_isTheLargestThatKeepsTheRinging()
    {
        std::mt19937_64 random(4);
        std::uniform_real_distribution<double> decade(0.0, 1.0);
        for (int i = 0; i < 300; ++i) {
            const double rate_Hz = std::pow(10.0, 3.0 + 5.0 * decade(random));
            const double f_Hz = rate_Hz / std::pow(10.0, 0.4 + 3.0 * decade(random));
            const double ring_s = std::pow(10.0, 2.5 * decade(random)) / f_Hz;
            const auto keeps = [&](Index factor) {
                return rate_Hz / static_cast<double>(factor) >= 4.0 * f_Hz
                    && span_s(rate_Hz, factor) <= ring_s;
            };
            const Index chosen = chooseReduction(rate_Hz, ringing(f_Hz, ring_s));
            QVERIFY(chosen == 1 || keeps(chosen));
            QVERIFY(!keeps(nextStep(chosen)));
        }
    }

    void everyResonanceThatStandsOut_isKept()
    {
        // The most prominent one is the lowest; the highest decays first.
        SpectrumResult spectrum;
        spectrum.resonances = {{75e3, 25.0, 100.0, {}}, {318e3, 24.0, 25.0, {}},
            {30e3, 19.1, 40.0, {}}, {3.01e6, 18.9, 5.0, {}}};
        const SensorTraits traits = sensorTraits({}, spectrum);
        QCOMPARE(traits.ringing.size(), std::size_t(3));
        QCOMPARE(chooseReduction(10e6, traits), Index(5)); // 2 MHz: 6.3 per period of 318 kHz
        QCOMPARE(chooseReduction(10e6, ringing(75e3, 4e-4)), Index(20)); // for that one alone
        // A comb of harmonics belongs to one burst.
        spectrum.resonances
            = {{3.5e6, 14.0, 9.0, {}}, {6.99e6, 13.0, 17.0, {}}, {20.98e6, 12.0, 49.0, {}}};
        QCOMPARE(sensorTraits({}, spectrum).ringing.size(), std::size_t(1));
        spectrum.resonances[2].frequency_Hz = 5.05 * 3.5e6; // a wide maximum, read a little low
        QCOMPARE(sensorTraits({}, spectrum).ringing.size(), std::size_t(1));
        spectrum.resonances[2].frequency_Hz = 5.4 * 3.5e6;
        QCOMPARE(sensorTraits({}, spectrum).ringing.size(), std::size_t(2));
        const double longest_s = 100.0 / (std::numbers::pi * 75e3);
        QCOMPARE(
            chooseSamples(100e3, traits), static_cast<Index>(std::ceil(12.0 * longest_s * 100e3)));
    }

    void reduction_isTheLargestThatKeepsTheRise()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> decade(0.0, 1.0);
        for (int i = 0; i < 200; ++i) {
            SensorTraits traits;
            const double rate_Hz = std::pow(10.0, 3.0 + 5.0 * decade(random));
            const double rise_s = std::pow(10.0, 4.0 * decade(random)) / rate_Hz;
            traits.riseTime_s = rise_s;
            const auto keeps = [&](Index factor) {
                return rate_Hz / static_cast<double>(factor) >= 10.0 / rise_s
                    && span_s(rate_Hz, factor) <= 0.5 * rise_s;
            };
            const Index chosen = chooseReduction(rate_Hz, traits);
            QVERIFY(chosen == 1 || keeps(chosen));
            QVERIFY(!keeps(nextStep(chosen)));
        }
    }

    void reduction_isRoundInEveryDecade_andNeverBelowOne()
    {
        QCOMPARE(chooseReduction(1e6, {}), Index(1)); // nothing known
        QCOMPARE(chooseReduction(1e6, ringing(1e6, 1.0)), Index(1)); // already too low
        // Exactly four samples per period are enough.
        QCOMPARE(chooseReduction(8e6, ringing(1e6, 1.0)), Index(2));
        QCOMPARE(chooseReduction(7.99e6, ringing(1e6, 1.0)), Index(1));
        // A resonance without a known Q says nothing of the ring time: no reduction.
        SensorTraits noQ;
        noQ.ringing = {{1e3, std::nullopt}};
        noQ.riseTime_s = 1.0;
        QCOMPARE(chooseReduction(1e6, noQ), Index(1));
    }

    void reduction_ofAVeryLongRecord_isChosenAtOnce()
    {
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(chooseReduction(1e9, ringing(100.0, 1.0)), Index(2000000));
        QCOMPARE(chooseReduction(1e300, ringing(1.0, 1.0)) > 0, true);
        constexpr qint64 kAtOnce_ms = 100;
        QVERIFY2(timer.elapsed() < kAtOnce_ms, qPrintable(QString::number(timer.elapsed())));
    }

    void spanOfTheFilter_isThatOfItsDesign()
    {
        for (const double factor : {1.0, 1.5, 2.0, 7.3, 10.0, 200.0})
            QCOMPARE(antiAliasSpan_s(factor, 3e6), designAntiAliasFilter(factor, 3e6).span_s());
    }

    void unitOfTime_changesNeitherReductionNorSamples()
    {
        for (const double f_Hz : {1e3, 1.3e4, 2.2e5}) {
            const SensorTraits one = ringing(f_Hz, 30.0 / f_Hz);
            for (const double time : {1e-6, 1e3}) {
                const SensorTraits other = ringing(f_Hz / time, 30.0 / f_Hz * time);
                QCOMPARE(chooseReduction(1e6 / time, other), chooseReduction(1e6, one));
                QCOMPARE(chooseSamples(1e6 / time, other), chooseSamples(1e6, one));
            }
        }
    }

    void samples_areTwelveRingTimesOrTwentyRises_withinBounds()
    {
        SensorTraits traits = ringing(1e4, 5e-5);
        QCOMPARE(chooseSamples(1e6, traits), Index(600)); // 12 x 50
        QCOMPARE(chooseSamples(1e5, traits), Index(200)); // 60 are too few
        QCOMPARE(chooseSamples(1e7, traits), Index(1000)); // 6000 too many
        traits.riseTime_s = 1e-5; // the ringing lasts longer, and is known
        QCOMPARE(chooseSamples(1e6, traits), Index(600));
        traits.ringing[0].ringTime_s.reset();
        QCOMPARE(chooseSamples(2.5e6, traits), Index(500)); // 20 x 25
        QCOMPARE(chooseSamples(1e6, {}), Index(1000));
        SensorTraits drifting;
        drifting.riseTime_s = 25e-6;
        drifting.drifts = true;
        QCOMPARE(chooseSamples(2.5e6, drifting), Index(2000));
        // Part of a sample is a sample.
        QCOMPARE(chooseSamples(1.0001e6, ringing(1e4, 5e-5)), Index(601));
    }

    void samples_ofAnEndlessRinging_areTheMost()
    {
        for (const double ring_s : {1e300, kInf, 1e15})
            QCOMPARE(chooseSamples(1e9, ringing(1e4, ring_s)), Index(1000));
        QCOMPARE(chooseSamples(1e9, ringing(1e4, 0.0)), Index(200));
    }

    void traits_areOfTheMostProminentResonance_andTheMeanRise()
    {
        const SensorTraits traits = sensorTraits({}, spectrumWith(2e5, 25.0));
        QCOMPARE(traits.ringing.size(), std::size_t(1)); // the other one is 20 dB below
        QCOMPARE(traits.ringing[0].frequency_Hz, 2e5);
        // A decay e^(-pi f t / Q): Q/(pi f) is its time constant.
        QVERIFY(std::abs(*traits.ringing[0].ringTime_s - 25.0 / (std::numbers::pi * 2e5)) < 1e-15);
        QVERIFY(!traits.riseTime_s);
        QVERIFY(!sensorTraits({}, spectrumWith(2e5, 0.0)).ringing[0].ringTime_s);
        std::vector<WindowedResponse> responses(3);
        responses[0].riseTime_s = 1e-6;
        responses[2].riseTime_s = 4e-6; // the second shows none
        const SensorTraits rise = sensorTraits(responses, {});
        QCOMPARE(*rise.riseTime_s, 2.5e-6);
        QVERIFY(rise.ringing.empty());
    }

    void rateThatCannotHoldTheResonance_namesWhereItWouldAppear_data()
    {
        QTest::addColumn<double>("rate_Hz");
        QTest::addColumn<QString>("alias");
        QTest::newRow("twice") << 2e6 << "1.00 MHz";
        QTest::newRow("once") << 1e6 << "0 Hz";
        QTest::newRow("1.5 times") << 1.5e6 << "500 kHz";
        QTest::newRow("below") << 0.4e6 << "200 kHz";
        QTest::newRow("far below") << 0.3e6 << "100 kHz";
    }
    void rateThatCannotHoldTheResonance_namesWhereItWouldAppear()
    {
        QFETCH(double, rate_Hz);
        QFETCH(QString, alias);
        const auto judged = judgeRate(rate_Hz, ringing(1e6, 1.0));
        QVERIFY(!judged.has_value());
        QCOMPARE(judged.error().findingId, std::string("MIN-001"));
        const double shown
            = std::abs(1e6 - rate_Hz * std::round(1e6 / rate_Hz)); // |f - k rate|, the smallest
        QVERIFY(shown <= 0.5 * rate_Hz);
        const std::string text = english(judged.error().message);
        const QString first = alias.split(' ').front();
        QVERIFY2(text.find(" appear at " + first.left(1).toStdString()) != std::string::npos,
            text.c_str());
        QVERIFY(text.find("more than 2") != std::string::npos);
    }

    void samplesPerPeriod_areSaidByTheirNumber()
    {
        const auto findingsAt = [](double perPeriod) {
            return judgeRate(perPeriod * 1e5, ringing(1e5, 1.0)).value();
        };
        QVERIFY(judgeRate(1.0, {}).value().empty()); // no resonance, nothing to judge
        for (const double few : {2.0001, 3.0, 3.999}) {
            const Findings findings = findingsAt(few);
            QCOMPARE(findings.size(), std::size_t(1));
            QCOMPARE(findings[0].id, std::string("MIN-002"));
            QVERIFY(findings[0].severity == Severity::Caution);
            QVERIFY(std::abs(*findings[0].value - few) < 1e-12);
        }
        for (const double some : {4.0, 7.0, 9.99})
            QVERIFY(findingsAt(some).at(0).severity == Severity::Info);
        for (const double plenty : {10.0, 1e6})
            QVERIFY(findingsAt(plenty).empty());
    }

    void offsetInsideTheFilter_isACautionWithBothTimes()
    {
        const Finding finding = insideFilterFinding(1.5e-6, 6e-6);
        QCOMPARE(finding.id, std::string("MIN-006"));
        QVERIFY(finding.severity == Severity::Caution);
        QCOMPARE(*finding.value, 1.5e-6);
        QCOMPARE(*finding.limit, 6e-6);
        const std::string text = english(finding.message);
        QVERIFY(text.find("1.5 \xC2\xB5s") < text.find("6 \xC2\xB5s"));
    }
};

DYNCAL_TEST(TestRateChoice)
#include "tst_rate_choice.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What of the model's characteristics may be stated: values of the second-order sensor by its
// closed form while they lie inside the band and the window, bounds where they lie beyond.

#include "core/base/constants.h"
#include "core/model_analysis/stated_characteristics.h"
#include "tests/support/second_order_model.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

using namespace dyncal;

namespace {

constexpr double kF0_Hz = 1e6;
constexpr double kZeta = 0.3;
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Where abs(G) is `ratio`, above the resonance or below it: (1 - x)^2 + 4 zeta^2 x = 1/ratio^2,
/// x = (f/f0)^2.
double edge_Hz(double ratio, bool isUpper)
{
    const double b = 1.0 - 2.0 * kZeta * kZeta;
    const double root = std::sqrt(b * b - 1.0 + 1.0 / (ratio * ratio));
    return kF0_Hz * std::sqrt(b + (isUpper ? root : -root));
}

/// Of the second-order sensor, in a band and a window that hold everything.
ResponseResult wholeResponse()
{
    ResponseResult response;
    response.characteristics = stepCharacteristics(
        testing::secondOrderModel(kF0_Hz, kZeta), ResponseTreatment::StepDeflated);
    response.fLow_Hz = 1e3;
    response.fHigh_Hz = 10e6;
    response.modelLimit_Hz = 10e6;
    response.window_s = 1e-3;
    response.resolution_s = 1e-8;
    return response;
}

bool isValue(const StatedValue &stated, double expected)
{
    return stated.value && !stated.above && !stated.below
        && std::abs(*stated.value / expected - 1.0) < 1e-9;
}

bool isAbove(const StatedValue &stated, double bound)
{
    return !stated.value && stated.above == bound && !stated.below;
}

bool isBelow(const StatedValue &stated, double bound)
{
    return !stated.value && !stated.above && stated.below == bound;
}

bool isNothing(const StatedValue &stated)
{
    return !stated.value && !stated.above && !stated.below
        && english(stated.words).starts_with("not determined (");
}

} // namespace

class TestStatedCharacteristics : public QObject
{
    Q_OBJECT

private slots:
    void insideBandAndWindow_areTheClosedForms()
    {
        const StatedCharacteristics found = statedCharacteristics(wholeResponse());
        QVERIFY(isValue(found.within5percent_Hz, edge_Hz(1.05, false)));
        QVERIFY(isValue(found.within10percent_Hz, edge_Hz(1.10, false)));
        QVERIFY(isValue(found.minus3dB_Hz, edge_Hz(std::sqrt(0.5), true)));
        const double root = std::sqrt(1.0 - kZeta * kZeta);
        QVERIFY(found.overshoot_percent.value
            && std::abs(*found.overshoot_percent.value
                   - 100.0 * std::exp(-std::numbers::pi * kZeta / root))
                < 1e-4);
        QVERIFY(found.riseTime_s.value && found.settlingTime_s.value);
    }

    void words_haveThreeDigits()
    {
        const StatedCharacteristics found = statedCharacteristics(wholeResponse());
        QCOMPARE(english(found.minus3dB_Hz.words), std::string("1.45 MHz"));
        QCOMPARE(english(found.overshoot_percent.words), std::string("37.2 %"));
    }

    /// The edge wanders through the band's end: a value up to it, then the end as a bound.
    void edgeBeyondTheBand_isABound()
    {
        const double edge = edge_Hz(std::sqrt(0.5), true);
        for (const bool byModel : {false, true}) {
            for (const double share : {0.5, 0.999, 1.001, 3.0}) {
                ResponseResult response = wholeResponse();
                (byModel ? response.modelLimit_Hz : response.fHigh_Hz) = share * edge;
                const StatedCharacteristics found = statedCharacteristics(response);
                QVERIFY(share < 1.0 ? isAbove(found.minus3dB_Hz, share * edge)
                                    : isValue(found.minus3dB_Hz, edge));
                QVERIFY(share * edge < edge_Hz(1.05, false)
                    || isValue(found.within5percent_Hz, edge_Hz(1.05, false)));
            }
        }
    }

    void edgeBelowTheBand_isABound()
    {
        ResponseResult response = wholeResponse();
        response.fLow_Hz = 1.001 * edge_Hz(1.05, false);
        const StatedCharacteristics found = statedCharacteristics(response);
        QVERIFY(isBelow(found.within5percent_Hz, response.fLow_Hz));
        QVERIFY(isValue(found.within10percent_Hz, edge_Hz(1.10, false)));
    }

    void edgeThatDoesNotExist_isABound()
    {
        // A sensor whose magnitude never falls: what is known is that it does not inside the band.
        ResponseResult response = wholeResponse();
        response.characteristics.minus3dB_Hz.reset();
        QVERIFY(isAbove(statedCharacteristics(response).minus3dB_Hz, 10e6));
        response.fHigh_Hz = response.modelLimit_Hz = kInf;
        QVERIFY(isNothing(statedCharacteristics(response).minus3dB_Hz));
    }

    void bound_isRoundedToItsSafeSide()
    {
        ResponseResult response = wholeResponse();
        response.fHigh_Hz = 1.2389e6;
        QCOMPARE(english(statedCharacteristics(response).minus3dB_Hz.words),
            std::string("above 1.23 MHz (the band of the response ends there)"));
        response.resolution_s = 0.50005e-6;
        QCOMPARE(english(statedCharacteristics(response).riseTime_s.words),
            std::string("below 1.01 \xC2\xB5s (two samples)"));
    }

    void riseShorterThanTwoSamples_isABound()
    {
        ResponseResult response = wholeResponse();
        const double rise_s = *response.characteristics.riseTime_s;
        response.resolution_s = 0.499 * rise_s;
        QVERIFY(isValue(statedCharacteristics(response).riseTime_s, rise_s));
        response.resolution_s = 0.501 * rise_s;
        QVERIFY(isBelow(statedCharacteristics(response).riseTime_s, 2.0 * 0.501 * rise_s));
        // A settling is not blurred by the sampling: it is read from a decay of many samples.
        QVERIFY(statedCharacteristics(response).settlingTime_s.value);
    }

    void behindTheWindow_nothingIsStated()
    {
        ResponseResult response = wholeResponse();
        const StepCharacteristics &found = response.characteristics;
        response.window_s = 0.9 * *found.settlingTime_s;
        StatedCharacteristics stated = statedCharacteristics(response);
        QVERIFY(isAbove(stated.settlingTime_s, response.window_s));
        QVERIFY(stated.overshoot_percent.value && stated.riseTime_s.value);
        // The top lies half a period of the damped frequency behind the onset.
        const double top_s = 0.5 / (kF0_Hz * std::sqrt(1.0 - kZeta * kZeta));
        QVERIFY(std::abs(*found.top_s / top_s - 1.0) < 0.02); // of the grid
        response.window_s = 0.9 * top_s;
        stated = statedCharacteristics(response);
        QVERIFY(isNothing(stated.overshoot_percent));
        QVERIFY(stated.riseTime_s.value);
        response.window_s = 0.9 * *found.riseTime_s;
        QVERIFY(isAbove(statedCharacteristics(response).riseTime_s, response.window_s));
    }

    void nothingFound_saysWhy()
    {
        const std::pair<CharacteristicsGap, const char *> gaps[]
            = {{CharacteristicsGap::FreeDecay, "free decay"},
                {CharacteristicsGap::Diverges, "diverges"},
                {CharacteristicsGap::LevelUnknown, "level"}, {CharacteristicsGap::None, "range"}};
        for (const auto &[gap, word] : gaps) {
            ResponseResult response = wholeResponse();
            response.characteristics = {};
            response.gap = gap;
            const StatedCharacteristics stated = statedCharacteristics(response);
            for (const StatedValue *value :
                {&stated.riseTime_s, &stated.overshoot_percent, &stated.settlingTime_s,
                    &stated.within5percent_Hz, &stated.within10percent_Hz, &stated.minus3dB_Hz}) {
                QVERIFY(isNothing(*value));
                QVERIFY2(english(value->words).find(word) != std::string::npos, word);
            }
        }
    }

    void numbersThatAreNone_areNotDetermined()
    {
        for (const double none : {kUnknown, kInf, -kInf}) {
            ResponseResult response = wholeResponse();
            StepCharacteristics &found = response.characteristics;
            found.riseTime_s = found.overshoot_percent = found.minus3dB_Hz = none;
            const StatedCharacteristics stated = statedCharacteristics(response);
            QVERIFY(isNothing(stated.riseTime_s) && isNothing(stated.overshoot_percent));
            QVERIFY(isNothing(stated.minus3dB_Hz));
            response = wholeResponse();
            response.fHigh_Hz = kUnknown;
            QVERIFY(isNothing(statedCharacteristics(response).within5percent_Hz));
        }
    }

    void riseOfARecord_likewise()
    {
        WindowedResponse record;
        record.sampleRate_Hz = 1e6;
        QVERIFY(!statedRise(record).value && !statedRise(record).below);
        record.riseTime_s = 2.1e-6;
        QVERIFY(isValue(statedRise(record), 2.1e-6));
        record.riseTime_s = 1.9e-6;
        QVERIFY(isBelow(statedRise(record), 2e-6));
        QCOMPARE(
            english(statedRise(record).words), std::string("below 2.00 \xC2\xB5s (two samples)"));
        record.overshoot_percent = 40.0;
        QVERIFY(!statedOvershoot_percent(record)); // the top lies between samples
        record.riseTime_s = 2.1e-6;
        QCOMPARE(statedOvershoot_percent(record).value(), 40.0);
        record.riseTime_s = 1.9e-6;
        record.sampleRate_Hz = 0.0; // not known: nothing speaks against the reading
        QVERIFY(isValue(statedRise(record), 1.9e-6));
    }
};

DYNCAL_TEST(TestStatedCharacteristics)
#include "tst_stated_characteristics.moc"

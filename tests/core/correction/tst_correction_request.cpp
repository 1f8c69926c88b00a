// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/correction_request.h"
#include "tests/support/known_sensor.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

constexpr double kRate_Hz = 5e6;

std::string whyNot(
    const KnownResponse &response, double rate_Hz, const CorrectionSettings &settings)
{
    const auto lowPass = requestedLowPass(response, rate_Hz, settings);
    return lowPass ? std::string() : english(lowPass.error().message);
}

} // namespace

class TestCorrectionRequest : public QObject
{
    Q_OBJECT

private slots:
    void whatIsLeftOpen_isPutIn()
    {
        const KnownResponse response = TrueSensor().known();
        const auto lowPass = requestedLowPass(response, kRate_Hz, {});
        QVERIFY(lowPass.has_value());
        QVERIFY(isNear(lowPass->band_Hz, widestBand_Hz(response, kRate_Hz)));
        QVERIFY(isNear(lowPass->edge_Hz, 1.5 * lowPass->band_Hz));
        QVERIFY(lowPass->kind == LowPassKind::Gaussian);
    }

    void whatIsStated_isTaken()
    {
        const auto lowPass = requestedLowPass(
            TrueSensor().known(), kRate_Hz, {100e3, 120e3, {}, LowPassKind::TwoPole});
        QVERIFY(lowPass.has_value());
        QCOMPARE(lowPass->band_Hz, 100e3);
        QCOMPARE(lowPass->edge_Hz, 120e3);
        QVERIFY(lowPass->kind == LowPassKind::TwoPole);
    }

    /// Both ends of what was measured are possible, a hair beyond is not.
    void bandsEnd_isTheLastRow()
    {
        KnownResponse response = TrueSensor().known();
        const double last_Hz = response.knot_Hz[26];
        QVERIFY(requestedLowPass(response, kRate_Hz, {last_Hz}).has_value());
        QVERIFY(!requestedLowPass(response, kRate_Hz, {last_Hz * (1.0 + 1e-12)}));
        QVERIFY(requestedLowPass(response, kRate_Hz, {1000.0}).has_value());
        QVERIFY(!requestedLowPass(response, kRate_Hz, {999.0}));
        response.knot_Hz[0] = 10.0; // without a level the first row is the lowest
        QVERIFY(requestedLowPass(response, kRate_Hz, {500.0}).has_value());
    }

    /// The edge ends where the response is known, and at 0.45 of the rate.
    void edgesEnd_isWhatIsKnown()
    {
        KnownResponse response = TrueSensor().known();
        QVERIFY(requestedLowPass(response, kRate_Hz, {300e3, 1e6}).has_value());
        QVERIFY(!requestedLowPass(response, kRate_Hz, {300e3, 1.001e6}));
        response.validTo_Hz = 1e9;
        QVERIFY(requestedLowPass(response, 1e6, {300e3, 450e3}).has_value());
        QVERIFY(!requestedLowPass(response, 1e6, {300e3, 451e3}));
    }

    /// Two poles have no edge: one that could not be is no reason.
    void edgeOfTwoPoles_isOfNoMeaning()
    {
        const KnownResponse response = TrueSensor().known();
        QVERIFY(requestedLowPass(response, kRate_Hz, {300e3, 1.0, {}, LowPassKind::TwoPole}));
        QVERIFY(!requestedLowPass(response, kRate_Hz, {300e3, 1.0}));
    }

    void numbersThatAreNone_areRefused()
    {
        const KnownResponse response = TrueSensor().known();
        for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY), -1.0, 0.0}) {
            QVERIFY(!whyNot(response, kRate_Hz, {bad}).empty());
            QVERIFY(!whyNot(response, kRate_Hz, {100e3, bad}).empty());
            QVERIFY(!whyNot(response, bad, {100e3}).empty());
        }
    }

    /// The reason names what was asked for and what is possible.
    void reason_namesAskedAndPossible()
    {
        const std::string beyond = whyNot(TrueSensor().known(), kRate_Hz, {2e6});
        QVERIFY(beyond.find("2 MHz") != std::string::npos);
        QVERIFY(beyond.find("1 kHz") != std::string::npos);
        QVERIFY(beyond.find("316.2 kHz") != std::string::npos);
    }

    /// A sensor far above its resonance: noise of its band's end would be 64 times as large.
    void amplification_isThatOfTheInverse()
    {
        const TrueSensor slow{25e3, 0.7, 1.0};
        const KnownResponse response = slow.known();
        const double least_Hz = 25e3 * std::sqrt(50.0);
        QVERIFY(requestedLowPass(response, kRate_Hz, {0.99 * least_Hz}).has_value());
        const std::string why = whyNot(response, kRate_Hz, {200e3});
        QVERIFY(why.find("At 200 kHz the sensor answers 64") != std::string::npos);
        const double widest_Hz = widestBand_Hz(response, kRate_Hz);
        QVERIFY(widest_Hz < least_Hz && widest_Hz > 0.99 * least_Hz);
    }
};

DYNCAL_TEST(TestCorrectionRequest)
#include "tst_correction_request.moc"

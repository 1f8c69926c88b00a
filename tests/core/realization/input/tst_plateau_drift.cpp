// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether a plateau that drifts is told from one that does not: levels of known slope in noise of
// known colour.

#include "core/realization/input/plateau_drift.h"
#include "core/realization/input/rate_choice.h"
#include "tests/support/simulated_calibration.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kRate_Hz = 1e6;
constexpr Index kSamples = 4000;
constexpr double kFrom_s = 400e-6;

/// A level of 1 that has changed by `change` at the window's end.
WindowedResponse plateau(double change, double noise, double ar1, std::uint64_t seed)
{
    RandomStream random(seed, 0, 3);
    WindowedResponse response;
    response.sampleRate_Hz = kRate_Hz;
    response.noise = testing::simulatedNoise(random, 2000, noise, ar1);
    response.values = testing::simulatedNoise(random, kSamples + 100, noise, ar1);
    response.lead = 50;
    response.length = kSamples;
    for (Index i = 0; i < kSamples; ++i)
        response.values[response.lead + i]
            += 1.0 + change * static_cast<double>(i) / static_cast<double>(kSamples);
    return response;
}

int driftsOf(double change, double noise, double ar1, int runs)
{
    int found = 0;
    for (int seed = 1; seed <= runs; ++seed)
        found += levelsDriftBehind(
            {plateau(change, noise, ar1, static_cast<std::uint64_t>(seed))}, kFrom_s);
    return found;
}

} // namespace

class TestPlateauDrift : public QObject
{
    Q_OBJECT

private slots:
    void aLevelThatStays_doesNotDrift()
    {
        QCOMPARE(driftsOf(0.0, 0.01, 0.0, 500), 0);
        QVERIFY(driftsOf(0.0, 0.01, 0.9, 500) <= 1);
        QVERIFY(driftsOf(0.0, 0.05, 0.99, 500) <= 2);
    }

    /// u of the change by white noise of 1 % over 3600 samples is 0.06 % (sqrt(12/3600)).
    void aLevelThatMoves_drifts()
    {
        QCOMPARE(driftsOf(0.01, 0.01, 0.0, 200), 200);
        QCOMPARE(driftsOf(-0.01, 0.01, 0.0, 200), 200);
        QVERIFY(driftsOf(0.002, 0.01, 0.0, 200) < 20);
    }

    void whatIsTooSmallToMatter_doesNotDrift()
    {
        QCOMPARE(driftsOf(0.0009, 1e-6, 0.0, 1), 0);
        QCOMPARE(driftsOf(0.0013, 1e-6, 0.0, 1), 1);
    }

    void mostShots_decide()
    {
        const WindowedResponse still = plateau(0.0, 0.01, 0.0, 1);
        const WindowedResponse moving = plateau(0.02, 0.01, 0.0, 2);
        QVERIFY(levelsDriftBehind({still, moving, moving}, kFrom_s));
        QVERIFY(!levelsDriftBehind({still, still, moving}, kFrom_s));
        QVERIFY(!levelsDriftBehind({still, moving}, kFrom_s));
        QVERIFY(!levelsDriftBehind({}, kFrom_s));
    }

    void shortStretches_sayNothing()
    {
        const WindowedResponse moving = plateau(0.05, 0.001, 0.0, 2);
        QVERIFY(levelsDriftBehind({moving}, 3.6e-3));
        QVERIFY(!levelsDriftBehind({moving}, 3.7e-3)); // 300 samples are left
        QVERIFY(!levelsDriftBehind({moving}, 1.0));
    }

    void onlyASensorThatDoesNotRing_isAsked()
    {
        WindowedResponse moving = plateau(0.05, 0.001, 0.0, 2);
        QVERIFY(!sensorTraits({moving}, {}).drifts); // no rise time, no twenty of them
        moving.riseTime_s = 20e-6;
        QVERIFY(sensorTraits({moving}, {}).drifts);
        SpectrumResult spectrum;
        spectrum.resonances.push_back({1e5, 30.0, 20.0, {}});
        QVERIFY(!sensorTraits({moving}, spectrum).drifts);
    }
};

DYNCAL_TEST(TestPlateauDrift)
#include "tst_plateau_drift.moc"

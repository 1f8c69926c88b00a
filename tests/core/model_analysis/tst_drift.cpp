// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/drift.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

using namespace dyncal;

namespace {

constexpr double kLevel = 0.8; ///< of the step, in the units of the series
constexpr double kSpan_s = 3e-4;
constexpr double kBand_s = 1.5e-3; ///< middle of the settle band
constexpr double kRing_rad_s = 2e6;

/// A step of kLevel that falls by h (1 - e^(-t/tau)), seen by a sensor so fast that it adds
/// nothing: the model of it, and the level that the settle band reads.
struct Drifting
{
    double share = 0.0;
    double tau_s = 0.0;
    SensorModel model;
    std::vector<WindowedResponse> responses;

    Drifting(double h, double tau)
        : share(h)
        , tau_s(tau)
    {
        model.poles.resize(2);
        model.poles[0].s_rad_s = {-kRing_rad_s, 0.0};
        model.poles[1].s_rad_s = {-1.0 / tau, 0.0};
        model.slowPoles = {1};
        SeriesFit fit;
        fit.shot = 1;
        fit.plateauGain = (1.0 - h) * kLevel;
        fit.stepLevel = kLevel;
        fit.u_stepLevel = 1e-4 * kLevel;
        fit.amplitudes.resize(2);
        fit.amplitudes << 0.0, h * kLevel;
        model.series = {fit};
        model.plateauGain = fit.plateauGain;
        model.stepLevel = kLevel;
        model.amplitudes = fit.amplitudes;
        WindowedResponse response;
        response.shot = 1;
        response.step = kLevel * (1.0 + h * std::expm1(-kBand_s / tau));
        response.sampleRate_Hz = 1e7;
        response.noiseSd = 1e-3;
        response.settle_s = {kBand_s - 5e-4, kBand_s + 5e-4};
        responses = {response};
    }

    DriftResult found() const { return findDrift(responses, model, kSpan_s); }
};

bool isNear(std::complex<double> a, std::complex<double> b, double relative)
{
    return std::abs(a - b) <= relative * std::abs(b);
}

std::complex<double> highPass(double f_Hz, double tau_s)
{
    const std::complex<double> turns(0.0, 2.0 * std::numbers::pi * f_Hz * tau_s);
    return turns / (1.0 + turns);
}

} // namespace

class TestDrift : public QObject
{
    Q_OBJECT

private slots:
    void noSlowPole_noDrift()
    {
        Drifting still(0.02, 5e-4);
        still.model.slowPoles.clear();
        QCOMPARE(still.found().kind, DriftKind::None);
        QVERIFY(still.found().shots.empty());
        QVERIFY(modelledDrift(still.model, 1e3) == 1.0);
    }

    void heat_isReadInTheSettleBandAndLeavesTheResponse_data()
    {
        QTest::addColumn<double>("share");
        QTest::addColumn<double>("tau_s");
        QTest::newRow("2 % in 0.5 ms") << 0.02 << 5e-4;
        QTest::newRow("5 % in 0.1 ms") << 0.05 << 1e-4;
        QTest::newRow("3 % in 2 ms, hardly begun") << 0.03 << 2e-3;
        QTest::newRow("rising by 2 %") << -0.02 << 5e-4;
    }
    void heat_isReadInTheSettleBandAndLeavesTheResponse()
    {
        QFETCH(double, share);
        QFETCH(double, tau_s);
        const DriftResult drift = Drifting(share, tau_s).found();
        QCOMPARE(drift.kind, DriftKind::Heat);
        const ShotDrift &shot = drift.shots.at(0);
        QVERIFY(isNear(shot.relative, share * std::expm1(-kBand_s / tau_s), 1e-9));
        QVERIFY(isNear(shot.tau_s, tau_s, 1e-6) && isNear(shot.share, share, 1e-6));
        QVERIFY(isNear(shot.at_s, kBand_s, 1e-12));
        // Level to 1e-4; 10^4 samples of 1e-3 in the band: 1e-5 of 0.8.
        const double expected = std::hypot(1e-4 * (1.0 + shot.relative), 1e-5 / kLevel);
        QVERIFY(isNear(shot.u, expected, 1e-9));
        QVERIFY(drift.keptAt(100.0) == 1.0);
        QCOMPARE(drift.ofShot(1), &shot);
        QVERIFY(!drift.ofShot(2));
    }

    void coupling_staysInTheResponse_data()
    {
        QTest::addColumn<double>("tau_s");
        QTest::newRow("20 ms") << 2e-2;
        QTest::newRow("5 ms") << 5e-3;
        QTest::newRow("1 ms") << 1e-3;
    }
    void coupling_staysInTheResponse()
    {
        QFETCH(double, tau_s);
        const DriftResult drift = Drifting(1.0, tau_s).found();
        QCOMPARE(drift.kind, DriftKind::AcCoupling);
        QVERIFY(isNear(drift.shots.at(0).tau_s, tau_s, 1e-9));
        for (const double f_Hz : {1.0, 30.0, 1e4})
            QVERIFY(isNear(drift.keptAt(f_Hz), highPass(f_Hz, tau_s), 1e-9));
    }

    void whatNeitherExplains_isUndetermined()
    {
        // The level falls by a tenth while the model sees it rise.
        Drifting odd(-0.02, 5e-4);
        odd.responses[0].step = 0.9 * kLevel;
        odd.model.series[0].amplitudes[1] = -0.8 * kLevel;
        QCOMPARE(odd.found().kind, DriftKind::Undetermined);
    }

    void modelledDrift_isOneLessShareOfALowPass()
    {
        const Drifting heat(0.04, 5e-4);
        for (const double f_Hz : {1.0, 300.0, 1e5}) {
            const std::complex<double> expected
                = 1.0 - heat.share + heat.share * highPass(f_Hz, heat.tau_s);
            QVERIFY(isNear(modelledDrift(heat.model, f_Hz), expected, 1e-9));
        }
    }
};

DYNCAL_TEST(TestDrift)
#include "tst_drift.moc"

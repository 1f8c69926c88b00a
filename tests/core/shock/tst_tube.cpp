// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/tube_resonances.h"
#include "core/shock/tube_waves.h"
#include "tests/support/side_wall_averaging.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

using namespace dyncal;

namespace {

constexpr double kT4_K = 295.35;

ShockStates thesisStates(double velocity_m_s = 512.8)
{
    return shockStates(Gas{}, 101100.0, 294.15, velocity_m_s).value();
}

TubeGeometry geometry(double driver_m, double velocity_m_s = 512.8)
{
    const double p4_Pa = driverPressure_Pa(thesisStates(velocity_m_s), Gas{}, Gas{}, kT4_K).value();
    return {0.97, driver_m, gasAtRest(Gas{}, p4_Pa, kT4_K), Gas{}};
}

} // namespace

class TestTube : public QObject
{
    Q_OBJECT

private slots:
    void plateau_thesisTube_1626usAnd615Hz();
    void rarefaction_shortDrivers_againstEulerSolution_data();
    void rarefaction_shortDrivers_againstEulerSolution();
    void rarefaction_longerDriver_comesLater();
    void reflectedHead_throughTheFan_againstIntegration_data();
    void reflectedHead_throughTheFan_againstIntegration();
    void reflectedHead_carriesItsInvariants();
    void reflectedHead_meetsTheContactAtTwiceItsExit();
    void paths_meetWhereTheyMust();
    void diagram_onTheRecordsAxis();
    void driverGasFront_ofTheThesis();
    void transverse_thesisTube_labelledFrequencies();
    void transverse_zeros_areZerosOfTheDerivative();
    void body_and_cavity_asInTheThesis();
    void candidates_withoutDimensions_none();
    void soundSpeedTest_gasModeAndSensor();
    void soundSpeedTest_undecided();
    void soundSpeedTest_degenerate_empty();
    void sideWall_averaging();
};

void TestTube::plateau_thesisTube_1626usAnd615Hz()
{
    const TubeWaves waves = tubeWaves(thesisStates(), geometry(0.97));
    qInfo("plateau %.4f ms (oracle 1.626), f_low %.1f Hz (615)", 1e3 * waves.plateau_s,
        1.0 / waves.plateau_s);
    QVERIFY(std::abs(waves.plateau_s - 1.626e-3) < 5.1e-7);
    QVERIFY(std::abs(1.0 / waves.plateau_s - 615.0) < 0.5);
    QCOMPARE(waves.plateauEnd, PlateauEnd::ContactSurface);
    QCOMPARE(waves.plateau_s, waves.contactReturn_s);
    QVERIFY(std::abs(waves.contactReturn_s / plateauTime_s(thesisStates(), 0.97) - 1.0) < 1e-12);
    QVERIFY(*waves.rarefactionReturn_s > waves.contactReturn_s);
}

void TestTube::rarefaction_shortDrivers_againstEulerSolution_data()
{
    QTest::addColumn<double>("driver_m");
    QTest::addColumn<double>("leaves_ms");
    // An Euler solution of the whole tube (1500 cells, second order) leaves its plateau then: last
    // time within 0.1 % of p5, read to 0.05 ms.
    QTest::addRow("0.2 m") << 0.2 << 0.88;
    QTest::addRow("0.3 m") << 0.3 << 1.53;
}

void TestTube::rarefaction_shortDrivers_againstEulerSolution()
{
    QFETCH(double, driver_m);
    QFETCH(double, leaves_ms);
    const TubeWaves waves = tubeWaves(thesisStates(), geometry(driver_m));
    qInfo("driver %.1f m: rarefaction %.3f ms after the step", driver_m,
        1e3 * *waves.rarefactionReturn_s);
    QCOMPARE(waves.plateauEnd, PlateauEnd::DriverRarefaction);
    QVERIFY(std::abs(1e3 * waves.plateau_s - leaves_ms) < 0.05);
}

void TestTube::rarefaction_longerDriver_comesLater()
{
    double before_s = 0.0;
    for (double driver_m = 0.1; driver_m < 2.0; driver_m *= 1.1) {
        const TubeWaves waves = tubeWaves(thesisStates(), geometry(driver_m));
        QVERIFY(*waves.rarefactionReturn_s > before_s);
        // Continuous where the way changes from the moving to the stopped contact surface.
        QVERIFY(
            before_s == 0.0 || *waves.rarefactionReturn_s - before_s < 0.25e-3 * driver_m / 0.1);
        before_s = *waves.rarefactionReturn_s;
        QVERIFY(waves.plateau_s <= waves.contactReturn_s);
    }
}

namespace {

/// Where the reflected head leaves the fan, by integrating dx/dt = u + a from the driver's end; the
/// fan gives u and a at every place: x/t = u - a and u + 2a/(g-1) = 2 a4/(g-1).
TubePoint integratedExit(double driver_m, double a4_m_s, double a3_m_s, double gamma)
{
    const double g1 = gamma - 1.0;
    const auto soundSpeed = [&](double x_m, double t_s) {
        return (2.0 * a4_m_s / g1 - x_m / t_s) * g1 / (gamma + 1.0);
    };
    const auto slope = [&](double x_m, double t_s) {
        const double a_m_s = soundSpeed(x_m, t_s);
        return 2.0 / g1 * (a4_m_s - a_m_s) + a_m_s;
    };
    TubePoint p{-driver_m, driver_m / a4_m_s};
    const double step_s = 1e-5 * p.time_s;
    for (;;) {
        const double k1 = slope(p.x_m, p.time_s);
        const double k2 = slope(p.x_m + 0.5 * step_s * k1, p.time_s + 0.5 * step_s);
        const double k3 = slope(p.x_m + 0.5 * step_s * k2, p.time_s + 0.5 * step_s);
        const double k4 = slope(p.x_m + step_s * k3, p.time_s + step_s);
        const TubePoint next{
            p.x_m + step_s * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0, p.time_s + step_s};
        const double before = soundSpeed(p.x_m, p.time_s) - a3_m_s;
        const double behind = soundSpeed(next.x_m, next.time_s) - a3_m_s;
        if (behind <= 0.0) {
            const double share = before / (before - behind);
            return {p.x_m + share * (next.x_m - p.x_m), p.time_s + share * step_s};
        }
        p = next;
    }
}

const TubePath &pathOf(const TubeWaves &waves, TubeLine line)
{
    for (const TubePath &path : waves.paths) {
        if (path.line == line)
            return path;
    }
    qFatal("no such line");
}

double a3Of(const ShockStates &states, double a4_m_s, double gamma)
{
    return a4_m_s - 0.5 * (gamma - 1.0) * states.shocked.velocity_m_s;
}

} // namespace

void TestTube::reflectedHead_throughTheFan_againstIntegration_data()
{
    QTest::addColumn<double>("driver_m");
    QTest::addColumn<double>("velocity_m_s");
    QTest::addRow("thesis") << 0.97 << 512.8;
    QTest::addRow("short driver") << 0.2 << 512.8;
    QTest::addRow("weak shock") << 0.5 << 380.0;
    QTest::addRow("strong shock") << 0.5 << 800.0;
}

void TestTube::reflectedHead_throughTheFan_againstIntegration()
{
    constexpr double kSteps = 1e-9; // linear interpolation within a step of 1e-5
    QFETCH(double, driver_m);
    QFETCH(double, velocity_m_s);
    const TubeGeometry tube = geometry(driver_m, velocity_m_s);
    const double a4_m_s = tube.driver->soundSpeed_m_s;
    const double a3_m_s = a3Of(thesisStates(velocity_m_s), a4_m_s, Gas{}.gamma);
    const TubeWaves waves = tubeWaves(thesisStates(velocity_m_s), tube);
    const TubePoint exit = pathOf(waves, TubeLine::RarefactionTail).points.back();
    const TubePoint integrated = integratedExit(driver_m, a4_m_s, a3_m_s, Gas{}.gamma);
    qInfo("leaves the fan at %.6f ms, integrated %.6f ms", 1e3 * exit.time_s,
        1e3 * integrated.time_s);
    QVERIFY(std::abs(exit.time_s / integrated.time_s - 1.0) < kSteps);
    QVERIFY(std::abs(exit.x_m - integrated.x_m) < kSteps * driver_m);
}

void TestTube::reflectedHead_carriesItsInvariants()
{
    // Inside the fan u + 2a/(g-1) is that of the gas at rest and x/t = u - a; the head itself runs
    // at u + a: its slope between two near points lies between those of their states.
    const double gamma = Gas{}.gamma;
    const TubeGeometry tube = geometry(0.3);
    const double a4_m_s = tube.driver->soundSpeed_m_s;
    const TubeWaves waves = tubeWaves(thesisStates(), tube);
    const auto &points = pathOf(waves, TubeLine::RarefactionHead).points;
    const TubePoint exit = pathOf(waves, TubeLine::RarefactionTail).points.back();
    int inside = 0;
    for (std::size_t i = 1; i + 1 < points.size() && points[i].time_s < exit.time_s; ++i) {
        const auto speed = [&](const TubePoint &p) {
            const double a_m_s
                = (2.0 * a4_m_s / (gamma - 1.0) - p.x_m / p.time_s) * (gamma - 1.0) / (gamma + 1.0);
            return 2.0 / (gamma - 1.0) * (a4_m_s - a_m_s) + a_m_s;
        };
        const double slope
            = (points[i + 1].x_m - points[i].x_m) / (points[i + 1].time_s - points[i].time_s);
        QVERIFY(slope > speed(points[i]) - 1e-6 && slope < speed(points[i + 1]) + 1e-6);
        ++inside;
    }
    QVERIFY(inside > 10);
}

void TestTube::reflectedHead_meetsTheContactAtTwiceItsExit()
{
    const TubeGeometry tube = geometry(0.2);
    const double a4_m_s = tube.driver->soundSpeed_m_s;
    const double u3_m_s = thesisStates().shocked.velocity_m_s;
    const TubeWaves waves = tubeWaves(thesisStates(), tube);
    const TubePoint exit = pathOf(waves, TubeLine::RarefactionTail).points.back();
    const auto &head = pathOf(waves, TubeLine::RarefactionHead).points;
    bool met = false;
    for (const TubePoint &p : head)
        met = met
            || (std::abs(p.time_s / (2.0 * exit.time_s) - 1.0) < 1e-12
                && std::abs(p.x_m / (u3_m_s * p.time_s) - 1.0) < 1e-12);
    QVERIFY(met);
    // docs/method/shock.md: 3.10 L4/a4, where the exponent (g+1)/2 would give 2.39.
    const double inDriverTimes = 2.0 * exit.time_s * a4_m_s / 0.2;
    const double ratio = a4_m_s / a3Of(thesisStates(), a4_m_s, Gas{}.gamma);
    qInfo("contact surface met at %.4f L4/a4; with (g+1)/2 %.4f", inDriverTimes,
        2.0 * std::pow(ratio, 0.5 * (Gas{}.gamma + 1.0)));
    QVERIFY(std::abs(inDriverTimes - 3.10) < 5e-3);
    QVERIFY(std::abs(2.0 * std::pow(ratio, 0.5 * (Gas{}.gamma + 1.0)) - 2.39) < 5e-3);
}

void TestTube::paths_meetWhereTheyMust()
{
    const ShockStates s = thesisStates();
    for (const double driver_m : {0.2, 0.97}) {
        const TubeWaves waves = tubeWaves(s, geometry(driver_m));
        QCOMPARE(waves.paths.size(), std::size_t(6));
        for (const TubePath &path : waves.paths) {
            for (std::size_t i = 1; i < path.points.size(); ++i)
                QVERIFY(path.points[i].time_s >= path.points[i - 1].time_s);
            QVERIFY(path.points.front().x_m >= -driver_m - 1e-12);
            QVERIFY(path.points.back().x_m <= 0.97 + 1e-12);
            if (path.line != TubeLine::RarefactionHead)
                continue;
            // To the driver's end at a4, and bent there.
            QVERIFY(std::abs(path.points[1].x_m + driver_m) < 1e-12);
            QVERIFY(
                std::abs(path.points[1].time_s * soundSpeed_m_s(Gas{}, kT4_K) - driver_m) < 1e-12);
            QVERIFY(std::abs(path.points.back().x_m - 0.97) < 1e-12);
        }
    }
    QCOMPARE(tubeWaves(s, {0.97, {}, {}, Gas{}}).paths.size(), std::size_t(4)); // no driver known
}

void TestTube::diagram_onTheRecordsAxis()
{
    const ShockStates s = thesisStates();
    const TubeWaves waves = tubeWaves(s, geometry(0.97));
    const double atWall_s = 1.2e-3;
    const TubeDiagram d = tubeDiagram(waves, s, atWall_s,
        {{"end wall", 0.0, {}, 0.0, 0.0}, {"side", 0.8, -0.36e-3, 0.0, 0.0}}, 1.6e-3);
    QCOMPARE(d.sensors.front().channel, std::string("side"));
    QVERIFY(std::abs(d.sensors.front().expected_s - (atWall_s - 0.8 / 512.8)) < 1e-12);
    QVERIFY(std::abs(d.burst_s + 0.97 / 512.8 - atWall_s) < 1e-12);
    QCOMPARE(d.plateau_s.begin, atWall_s);
    QCOMPARE(d.plateau_s.end, atWall_s + 1.6e-3);
}

void TestTube::driverGasFront_ofTheThesis()
{
    // Particle velocity 234.77 m/s over 0.97 m, less the shock's own way.
    const TubeWaves waves = tubeWaves(thesisStates(), geometry(0.97));
    QVERIFY(std::abs(waves.driverGasFront_s - (0.97 / 234.7695 - 0.97 / 512.8)) < 1e-8);
}

void TestTube::transverse_thesisTube_labelledFrequencies()
{
    // W = 512.82 m/s, which reproduces table 4.2: a5 = 444.382 m/s, printed as 444.4.
    const auto list = tubeResonances(thesisStates(512.82), {}, Gas{}, {{}, {}, {}, 0.1, 5130.0});
    const std::tuple<int, int, double> printed[]
        = {{1, 0, 2604}, {2, 0, 4320}, {0, 1, 5420}, {3, 0, 5943}, {4, 0, 7522}, {1, 1, 7541}};
    QVERIFY(list.size() >= 6);
    for (std::size_t i = 0; i < 6; ++i) {
        const auto &[m, n, frequency_Hz] = printed[i];
        qInfo("%s: %.1f Hz (oracle %.0f)", list[i].label().c_str(), list[i].frequency_Hz,
            frequency_Hz);
        QCOMPARE(list[i].m, m);
        QCOMPARE(list[i].n, n);
        QVERIFY(std::abs(list[i].frequency_Hz - frequency_Hz) < 0.51);
        QVERIFY(list[i].followsGas);
    }
    QCOMPARE(list[5].label(), std::string("transverse (1,1)"));
}

void TestTube::transverse_zeros_areZerosOfTheDerivative()
{
    double before = 0.0;
    for (const BesselZero &z : transverseZeros()) {
        // J_m' = (J_{m-1} - J_{m+1})/2, J_0' = -J_1.
        const double slope = z.m == 0
            ? -std::cyl_bessel_j(1.0, z.zero)
            : 0.5 * (std::cyl_bessel_j(z.m - 1.0, z.zero) - std::cyl_bessel_j(z.m + 1.0, z.zero));
        QVERIFY2(std::abs(slope) < 1e-9, qPrintable(QString("%1,%2").arg(z.m).arg(z.n)));
        QVERIFY(z.zero > before);
        before = z.zero;
        // Number of zeros of the derivative below: n circles.
        int sign = 0, changes = 0;
        for (double x = 0.3; x < z.zero - 1e-3; x += 0.01) {
            const double value = z.m == 0
                ? -std::cyl_bessel_j(1.0, x)
                : std::cyl_bessel_j(z.m - 1.0, x) - std::cyl_bessel_j(z.m + 1.0, x);
            const int now = value > 0.0 ? 1 : -1;
            changes += sign != 0 && now != sign ? 1 : 0;
            sign = now;
        }
        QCOMPARE(changes, z.m == 0 ? z.n - 1 : z.n);
    }
}

void TestTube::body_and_cavity_asInTheThesis()
{
    ShockStates s = thesisStates();
    s.driven.soundSpeed_m_s = 343.7; // eq 5.2 takes this one
    const TubeGeometry tube = geometry(0.97);
    const auto list = tubeResonances(s, tube.driver, Gas{}, {2.0, 0.97, 0.97, {}, 5130.0});
    const auto find = [&](ResonanceKind kind) {
        for (const TubeResonance &r : list) {
            if (r.kind == kind && r.order == 1)
                return r.frequency_Hz;
        }
        return 0.0;
    };
    QVERIFY(std::abs(find(ResonanceKind::Body) - 1282.5) < 1e-9);
    QVERIFY(std::abs(find(ResonanceKind::Cavity) - 85.925) < 1e-9);
    QVERIFY(std::abs(find(ResonanceKind::CavityShocked) - 229.0) < 0.1);
    // Between the whole tube at a3 = 297.6 m/s and at a5 = 444.4 m/s.
    const double mixed = find(ResonanceKind::CavityMixed);
    QVERIFY(mixed > 297.6 / 3.88 && mixed < 444.4 / 3.88);
    for (std::size_t i = 1; i < list.size(); ++i)
        QVERIFY(list[i].frequency_Hz >= list[i - 1].frequency_Hz);
}

void TestTube::candidates_withoutDimensions_none()
{
    QVERIFY(tubeResonances(thesisStates(), {}, Gas{}, {}).empty());
}

void TestTube::soundSpeedTest_gasModeAndSensor()
{
    std::vector<PeakOfShot> gas, sensor;
    for (const double a5 : {392.0, 418.0, 444.0}) {
        gas.push_back({a5, 17.0 * a5, 40.0});
        sensor.push_back({a5, 6800.0, 40.0});
    }
    const auto moving = testSoundSpeed(gas);
    QVERIFY(moving->followsGas && !moving->excludesGas);
    QVERIFY(std::abs(moving->slope - 1.0) < 1e-9);
    const auto fixed = testSoundSpeed(sensor);
    QVERIFY(!fixed->followsGas && fixed->excludesGas);
    QVERIFY(std::abs(fixed->slope) < 1e-9);
    // u of a slope over ln(444/392): 40/7000 over sqrt(sum of squares) of about 0.088.
    QVERIFY(std::abs(moving->u_slope - 0.064) < 0.005);
}

void TestTube::soundSpeedTest_undecided()
{
    // The same with peaks known to 10 %: agrees with both, so it says neither.
    std::vector<PeakOfShot> peaks;
    for (const double a5 : {392.0, 418.0, 444.0})
        peaks.push_back({a5, 17.0 * a5, 700.0});
    const auto test = testSoundSpeed(peaks);
    QVERIFY(!test->followsGas && !test->excludesGas);
    // A scatter larger than the stated uncertainty is taken instead.
    std::vector<PeakOfShot> scattered{
        {392.0, 6500.0, 1.0}, {418.0, 7500.0, 1.0}, {444.0, 7400.0, 1.0}};
    QVERIFY(testSoundSpeed(scattered)->u_slope > 0.5);
}

void TestTube::soundSpeedTest_degenerate_empty()
{
    QVERIFY(!testSoundSpeed({}));
    QVERIFY(!testSoundSpeed({{444.0, 7000.0, 10.0}}));
    QVERIFY(!testSoundSpeed({{444.0, 7000.0, 10.0}, {444.0, 7100.0, 10.0}}));
    QVERIFY(!testSoundSpeed({{444.0, 7000.0, 0.0}, {400.0, 7100.0, 10.0}}));
}

void TestTube::sideWall_averaging()
{
    const double limit_Hz = sideWallLimit_Hz(5.5e-3, 512.8);
    QVERIFY(std::abs(limit_Hz * 5.5e-3 / 512.8 - 0.514) < 1e-3); // metrology.md 1.2
    QVERIFY(std::abs(limit_Hz - 48e3) < 500.0);
    QVERIFY(std::abs(testing::sideWallAveraging(limit_Hz, 5.5e-3, 512.8) - std::sqrt(0.5)) < 1e-9);
    QCOMPARE(testing::sideWallAveraging(0.0, 5.5e-3, 512.8), 1.0);
    QVERIFY(std::abs(testing::sideWallAveraging(10.0, 5.5e-3, 512.8) - 1.0) < 1e-6);
}

DYNCAL_TEST(TestTube)
#include "tst_tube.moc"

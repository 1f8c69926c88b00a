// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What must hold of every shock whatever the gas: similarity, order, permutation, and inputs that
// are none.

#include "core/base/number_text.h"
#include "core/shock/moist_air.h"
#include "core/shock/shock_conditions.h"
#include "core/shock/shock_estimate.h"
#include "core/shock/variable_shock.h"
#include "tests/support/python_answer.h"
#include "tests/support/side_wall_averaging.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace dyncal;

namespace {

constexpr double kRounding = 1e-11; ///< of two ways through the same relations
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");
constexpr double kAir_Pa = 101e3;
constexpr double kRoom_K = 294.15;

GasModel modelOf(const std::string &substance, const char *heatCapacity = kConstantHeatCapacity)
{
    GasSettings settings;
    for (const NamedGas &gas : knownGases()) {
        if (substance == gas.name)
            settings = {gas.gamma, gas.molarMass_kg_mol, substance, heatCapacity};
    }
    settings.substance = substance;
    return gasModel(settings, {kAir_Pa, kRoom_K, 0.5, kUsualCarbonDioxide}).value();
}

std::vector<GasModel> allModels()
{
    std::vector<GasModel> models{modelOf("humid-air")};
    for (const NamedGas &gas : knownGases()) {
        models.push_back(modelOf(gas.name));
        models.push_back(modelOf(gas.name, kVariableHeatCapacity));
    }
    return models;
}

bool near(double found, double expected, double relative = kRounding)
{
    return std::abs(found - expected) <= relative * std::abs(expected);
}

/// The regions in order, by one member.
std::array<double, 3> regions(const ShockStates &states, double GasState::*member)
{
    return {states.driven.*member, states.shocked.*member, states.reflected.*member};
}

CaptureSet shotsOf(const std::vector<std::pair<double, double>> &pressureAndTemperature)
{
    CaptureSet set;
    for (const auto &[p1_Pa, T1_K] : pressureAndTemperature) {
        Shot shot;
        shot.environment.p1_Pa = p1_Pa;
        shot.environment.T1_K = T1_K;
        set.shots.push_back(shot);
    }
    return set;
}

ShockSettings settingsWithVelocity(double velocity_m_s)
{
    ShockSettings settings;
    settings.velocity_m_s = velocity_m_s;
    return settings;
}

Sighting seenAt(double distance_m, double time_s, double u_distance_m = 1e-4)
{
    return {"at " + numberText(distance_m), distance_m, u_distance_m, time_s, 1e-8, 0.0, false};
}

} // namespace

class TestShockProperties : public QObject
{
    Q_OBJECT

private slots:
    void similarity_pressureAndMassOnlyScale();
    void order_everythingRisesWithTheVelocity();
    void rest_idealGasInEveryRegion();
    void stateFromP2_hasThatP2_whateverTheGas();
    void velocityOfShockedPressure_refusesWhatIsNoShock();
    void sideWall_averagingIsTheMeanOverTheDisc();
    void resonances_scaleWithTheTube();
    void soundSpeedTest_findsTheExponent();
    void soundSpeedTest_unitsAndOrderDoNotMatter();
    void soundSpeedTest_withoutEnoughToGoBy_isEmpty();
    void velocityFit_againstNumpy();
    void velocityFit_unitsOrderAndOriginDoNotMatter();
    void velocityFit_ofNonsense_fails();
    void counters_ofNonsense_fail();
    void moistAir_nonsense_isRefusedByName();
    void conditions_permuteWithTheShots();
    void conditions_ofNonsense_haveNoStep_data();
    void conditions_ofNonsense_haveNoStep();
    void tubeOfNonsense_hasNoPlateau();
};

/// p1 -> a p1 scales pressures and densities; M -> b M with W -> W/sqrt(b) only velocities and
/// densities: nothing else may know either.
void TestShockProperties::similarity_pressureAndMassOnlyScale()
{
    for (const GasModel &gas : allModels()) {
        const double W = 1.45 * soundSpeed_m_s(gas.constants, kRoom_K);
        const ShockStates one = shockStatesOf(gas, kAir_Pa, kRoom_K, W).value();
        const ShockStates thin = shockStatesOf(gas, 1e-3 * kAir_Pa, kRoom_K, W).value();
        GasModel heavy = gas;
        heavy.constants.molarMass_kg_mol *= 2.0;
        const ShockStates slow
            = shockStatesOf(heavy, kAir_Pa, kRoom_K, W / std::numbers::sqrt2).value();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at
                = [i](const ShockStates &s, double GasState::*m) { return regions(s, m)[i]; };
            QVERIFY(near(at(thin, &GasState::pressure_Pa), 1e-3 * at(one, &GasState::pressure_Pa)));
            QVERIFY(near(at(thin, &GasState::temperature_K), at(one, &GasState::temperature_K)));
            QVERIFY(near(at(slow, &GasState::pressure_Pa), at(one, &GasState::pressure_Pa)));
            QVERIFY(
                near(at(slow, &GasState::density_kg_m3), 2.0 * at(one, &GasState::density_kg_m3)));
            QVERIFY(near(at(slow, &GasState::soundSpeed_m_s),
                at(one, &GasState::soundSpeed_m_s) / std::numbers::sqrt2));
        }
        QVERIFY(near(slow.mach, one.mach) && near(slow.reflectedMach, one.reflectedMach));
        // A tube sqrt(2) longer in time: the slow shock keeps the same distances.
        QVERIFY(near(plateauTime_s(slow, 3.0), std::numbers::sqrt2 * plateauTime_s(one, 3.0)));
        QVERIFY(near(plateauTime_s(one, 6.0), 2.0 * plateauTime_s(one, 3.0)));
    }
}

void TestShockProperties::order_everythingRisesWithTheVelocity()
{
    for (const GasModel &gas : allModels()) {
        const double a1 = soundSpeed_m_s(gas.constants, kRoom_K);
        ShockStates before = shockStatesOf(gas, kAir_Pa, kRoom_K, 1.0001 * a1).value();
        for (double mach = 1.001; mach < 1.7; mach *= 1.01) {
            const auto states = shockStatesOf(gas, kAir_Pa, kRoom_K, mach * a1);
            QVERIFY2(states.has_value(), gas.name.c_str());
            for (const auto member :
                {&GasState::pressure_Pa, &GasState::temperature_K, &GasState::density_kg_m3}) {
                const auto now = regions(*states, member), earlier = regions(before, member);
                QVERIFY(now[0] < now[1] && now[1] < now[2]);
                QVERIFY(now[1] > earlier[1] && now[2] > earlier[2]);
            }
            QVERIFY(states->shocked.velocity_m_s > before.shocked.velocity_m_s);
            QVERIFY(states->reflectedMach > 1.0 && states->reflectedMach < states->mach);
            before = *states;
        }
    }
}

void TestShockProperties::rest_idealGasInEveryRegion()
{
    for (const GasModel &gas : allModels()) {
        const auto states
            = shockStatesOf(gas, kAir_Pa, kRoom_K, 1.5 * soundSpeed_m_s(gas.constants, kRoom_K));
        for (const GasState &state : {states->driven, states->shocked, states->reflected})
            QVERIFY(near(state.pressure_Pa,
                state.density_kg_m3 * kGasConstant_J_molK * state.temperature_K
                    / gas.constants.molarMass_kg_mol));
        QCOMPARE(states->reflected.velocity_m_s, 0.0);
    }
}

/// The pressure that is typed is the pressure that comes out, with cp(T) too.
void TestShockProperties::stateFromP2_hasThatP2_whateverTheGas()
{
    for (const GasModel &gas : allModels()) {
        for (const double ratio : {1.001, 1.2, 2.4, 4.0}) { // weaker ones cancel in the energy
            const double p2_Pa = ratio * kAir_Pa;
            const auto velocity = velocityOfShockedPressure_m_s(gas, kAir_Pa, kRoom_K, p2_Pa);
            QVERIFY2(velocity.has_value(), gas.name.c_str());
            const auto states = shockStatesOf(gas, kAir_Pa, kRoom_K, *velocity);
            QVERIFY2(near(states->shocked.pressure_Pa, p2_Pa),
                (gas.name + " " + numberText(states->shocked.pressure_Pa / p2_Pa - 1.0)).c_str());
        }
    }
    ShockSettings settings;
    settings.stateFrom = "p2";
    settings.p2_Pa = 2.4e5;
    settings.drivenGas.heatCapacity = kVariableHeatCapacity;
    const auto result = estimateShockConditions(shotsOf({{kAir_Pa, kRoom_K}}), {}, settings);
    QVERIFY(near(result->shots[0].states->shocked.pressure_Pa, 2.4e5));
}

void TestShockProperties::velocityOfShockedPressure_refusesWhatIsNoShock()
{
    for (const GasModel &gas : {modelOf("air"), modelOf("air", kVariableHeatCapacity)}) {
        for (const double p2_Pa : {kAir_Pa, 0.5 * kAir_Pa, 0.0, -1e5, kNan, kInfinity}) {
            const auto refused = velocityOfShockedPressure_m_s(gas, kAir_Pa, kRoom_K, p2_Pa);
            QVERIFY(!refused && refused.error().findingId == "SHK-001");
        }
        for (const double p1_Pa : {0.0, kNan, kInfinity})
            QVERIFY(!velocityOfShockedPressure_m_s(gas, p1_Pa, kRoom_K, 2e5));
    }
    const auto hot = velocityOfShockedPressure_m_s(
        modelOf("air", kVariableHeatCapacity), kAir_Pa, kRoom_K, 1e8);
    QVERIFY(!hot && hot.error().findingId == "SHK-009");
}

/// Mean of e^(i k x) over a disc, summed in strips.
void TestShockProperties::sideWall_averagingIsTheMeanOverTheDisc()
{
    constexpr double kDiameter_m = 5.5e-3, kVelocity_m_s = 512.8;
    constexpr int kStrips = 20000;
    for (const double frequency_Hz : {1.0, 1e3, 2e4, 47.9e3, 1e5, 3e5}) {
        double sum = 0.0;
        for (int i = 0; i < kStrips; ++i) { // x = r sin(phi): the integrand has no edge
            const double phi = std::numbers::pi * ((i + 0.5) / kStrips - 0.5);
            const double x_m = 0.5 * kDiameter_m * std::sin(phi);
            sum += std::cos(phi) * std::cos(phi)
                * std::cos(2.0 * std::numbers::pi * frequency_Hz * x_m / kVelocity_m_s);
        }
        const double mean = std::abs(2.0 * sum / kStrips);
        QVERIFY(
            std::abs(testing::sideWallAveraging(frequency_Hz, kDiameter_m, kVelocity_m_s) - mean)
            < 1e-10);
    }
    const double limit_Hz = sideWallLimit_Hz(kDiameter_m, kVelocity_m_s);
    QVERIFY(near(testing::sideWallAveraging(limit_Hz, kDiameter_m, kVelocity_m_s), std::sqrt(0.5)));
    QCOMPARE(testing::sideWallAveraging(0.0, kDiameter_m, kVelocity_m_s), 1.0);
}

void TestShockProperties::resonances_scaleWithTheTube()
{
    const Gas air{};
    const ShockStates states = shockStates(air, kAir_Pa, kRoom_K, 512.8).value();
    const GasState driver = gasAtRest(air, 7e5, 295.0);
    const auto listOf = [&](double factor) {
        return tubeResonances(
            states, driver, air, {1.94 * factor, 0.97 * factor, 0.97 * factor, 0.1 * factor, 5130});
    };
    const auto one = listOf(1.0), two = listOf(2.0);
    QCOMPARE(one.size(), std::size_t(4 * 3 + 12));
    for (std::size_t i = 0; i < one.size(); ++i) {
        QCOMPARE(one[i].label(), two[i].label());
        QVERIFY(near(two[i].frequency_Hz, 0.5 * one[i].frequency_Hz));
        QVERIFY(i == 0 || one[i].frequency_Hz >= one[i - 1].frequency_Hz);
        QVERIFY(one[i].followsGas
            == (one[i].kind != ResonanceKind::Body && one[i].kind != ResonanceKind::Cavity));
        if (one[i].kind == ResonanceKind::Cavity)
            QVERIFY(near(
                one[i].frequency_Hz, one[i].order * states.driven.soundSpeed_m_s / (2.0 * 1.94)));
        if (one[i].kind == ResonanceKind::Body)
            QVERIFY(near(one[i].frequency_Hz, one[i].order * 5130.0 / (2.0 * 1.94)));
    }
    QVERIFY(tubeResonances(states, driver, air, {}).empty());
}

void TestShockProperties::soundSpeedTest_findsTheExponent()
{
    for (const double exponent : {0.0, 0.5, 1.0, -1.0, 2.0}) {
        std::vector<PeakOfShot> peaks;
        for (const double a_m_s : {390.0, 430.0, 480.0, 510.0})
            peaks.push_back({a_m_s, 6.8e3 * std::pow(a_m_s / 400.0, exponent), 5.0});
        const auto test = testSoundSpeed(peaks);
        QVERIFY(test.has_value());
        QVERIFY(std::abs(test->slope - exponent) < kRounding);
        QCOMPARE(test->followsGas, exponent == 1.0);
        QCOMPARE(test->excludesGas, exponent == 0.0);
        for (PeakOfShot &peak : peaks)
            peak.u_frequency_Hz *= 1e4; // so uncertain that nothing is excluded
        QVERIFY(!testSoundSpeed(peaks)->followsGas && !testSoundSpeed(peaks)->excludesGas);
    }
}

void TestShockProperties::soundSpeedTest_unitsAndOrderDoNotMatter()
{
    const std::vector<PeakOfShot> peaks{
        {390.0, 6.80e3, 5.0}, {430.0, 7.41e3, 9.0}, {480.0, 8.39e3, 2.0}, {510.0, 8.85e3, 7.0}};
    const auto expected = testSoundSpeed(peaks);
    std::vector<PeakOfShot> other(peaks.rbegin(), peaks.rend());
    std::swap(other[0], other[2]);
    for (PeakOfShot &peak : other)
        peak = {3.6 * peak.soundSpeed_m_s, 1e-3 * peak.frequency_Hz, 1e-3 * peak.u_frequency_Hz};
    QVERIFY(near(testSoundSpeed(other)->slope, expected->slope));
    QVERIFY(near(testSoundSpeed(other)->u_slope, expected->u_slope));
}

void TestShockProperties::soundSpeedTest_withoutEnoughToGoBy_isEmpty()
{
    QVERIFY(!testSoundSpeed({}));
    QVERIFY(!testSoundSpeed({{400.0, 1e3, 1.0}}));
    QVERIFY(!testSoundSpeed({{400.0, 1e3, 1.0}, {400.0, 1.1e3, 1.0}, {400.0, 1.2e3, 1.0}}));
    for (const double bad : {0.0, kNan, -1.0, kInfinity}) {
        QVERIFY(!testSoundSpeed({{bad, 1e3, 1.0}, {500.0, 1.1e3, 1.0}, {450.0, 1e3, 1.0}}));
        if (bad != -1.0)
            QVERIFY(!testSoundSpeed({{400.0, 1e3, bad}, {500.0, 1.1e3, 1.0}, {450.0, 1e3, 1.0}}));
    }
}

/// Weighted least squares by numpy's own: velocity at the wall, its gradient, chi-square.
void TestShockProperties::velocityFit_againstNumpy()
{
    using dyncal::testing::python;
    const char *const script = R"py(
import numpy as np
x = np.array([1.4, 1.1, 0.8, 0.5, 0.2]); ux = np.array([1e-4, 3e-4, 2e-4, 1e-3, 5e-5])
t = 2e-3 - x / 512.8 + 4e-6 * x**2 + np.array([3, -4, 2, 5, -1]) * 1e-7
W0 = -1 / np.polyfit(x, t, 1)[0]
w = 1 / np.sqrt(1e-16 + (ux / W0)**2)
for degree in (1, 2):
    c, v = np.polyfit(x, t, degree, w=w, cov='unscaled')
    W = -1 / c[-2]
    print(repr(W), repr(c[-1]), repr(np.sum((w * (t - np.polyval(c, x)))**2)),
          repr(2 * c[0] * W**2 if degree == 2 else 0.0),
          repr(2 * v[0][0]**0.5 * W**2 if degree == 2 else 0.0))
)py";
    const auto answer = python({"-c", script});
    if (!answer.ran)
        QSKIP("python3 with numpy is missing: the fit is not compared");
    const QList<QByteArray> lines = answer.out.trimmed().split('\n');
    std::vector<Sighting> list;
    const double x[] = {1.4, 1.1, 0.8, 0.5, 0.2}, u[] = {1e-4, 3e-4, 2e-4, 1e-3, 5e-5},
                 e[] = {3, -4, 2, 5, -1};
    for (int i = 0; i < 5; ++i)
        list.push_back(seenAt(x[i], 2e-3 - x[i] / 512.8 + 4e-6 * x[i] * x[i] + e[i] * 1e-7, u[i]));
    for (const bool bent : {false, true}) {
        const auto fit = fitVelocity(list, bent ? Attenuation::Linear : Attenuation::None);
        const QList<QByteArray> numbers = lines[bent ? 1 : 0].split(' ');
        constexpr double kFit = 1e-9; // numpy solves by SVD of scaled columns
        QVERIFY(near(fit->velocity_m_s, numbers[0].toDouble(), kFit));
        QVERIFY(near(fit->arrivalAtWall_s, numbers[1].toDouble(), kFit));
        QVERIFY(near(*fit->chiSquare, numbers[2].toDouble(), kFit));
        QCOMPARE(fit->attenuated, bent);
        if (bent) {
            QVERIFY(near(*fit->gradient_per_s, numbers[3].toDouble(), 1e-7));
            QVERIFY(near(*fit->u_gradient_per_s, numbers[4].toDouble(), 1e-7));
        }
    }
}

void TestShockProperties::velocityFit_unitsOrderAndOriginDoNotMatter()
{
    const std::vector<Sighting> list{
        seenAt(1.2, 1e-4), seenAt(0.9, 7.1e-4), seenAt(0.5, 1.46e-3), seenAt(0.1, 2.24e-3)};
    for (const Attenuation attenuation : {Attenuation::None, Attenuation::Linear}) {
        const double velocity_m_s = fitVelocity(list, attenuation)->velocity_m_s;
        std::vector<Sighting> other(list.rbegin(), list.rend());
        std::swap(other[1], other[3]);
        for (Sighting &s : other)
            s.time_s += 17.25; // a recorder that has run for a while
        const auto fit = fitVelocity(other, attenuation);
        QVERIFY(near(fit->velocity_m_s, velocity_m_s, 1e-9)); // 17 s cost five digits of the times
        for (Sighting &s : other) {
            s.distance_m *= 0.5; // half a metre is the unit
            s.u_distance_m *= 0.5;
        }
        QVERIFY(near(fitVelocity(other, attenuation)->velocity_m_s, 0.5 * velocity_m_s, 1e-9));
    }
}

void TestShockProperties::velocityFit_ofNonsense_fails()
{
    const auto refused = [](const std::vector<Sighting> &list) {
        const auto fit = fitVelocity(list, Attenuation::None);
        return !fit && english(fit.error().message).size() > 20;
    };
    QVERIFY(refused({}));
    QVERIFY(refused({seenAt(0.8, 1e-3)}));
    QVERIFY(refused({seenAt(0.8, 1e-3), seenAt(0.8, 2e-3)}));
    QVERIFY(refused({seenAt(0.8, 2e-3), seenAt(0.0, 1e-3)})); // away from the wall
    QVERIFY(refused({seenAt(0.8, 1e-3), seenAt(0.0, 1e-3)})); // at once
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        QVERIFY(refused({seenAt(0.8, bad), seenAt(0.0, 1e-3)}));
        QVERIFY(refused({seenAt(0.8, 0.0), seenAt(0.0, bad)}));
        QVERIFY(refused({seenAt(bad, 0.0), seenAt(0.0, 1e-3)}));
        QVERIFY(refused({seenAt(0.8, 0.0), seenAt(0.4, bad), seenAt(0.0, 1e-3)}));
    }
}

void TestShockProperties::counters_ofNonsense_fail()
{
    const CounterReading fine{1.4, 1.1, 5.85e-4, 1e-4, 1e-8};
    QVERIFY(near(fitCounters({fine}, Attenuation::None)->velocity_m_s, 0.3 / 5.85e-4));
    QVERIFY(!fitCounters({}, Attenuation::Automatic));
    for (const double bad : {kNan, kInfinity, -1.0, 0.0}) {
        CounterReading far = fine, time = fine;
        far.far_m = bad;
        time.time_s = bad;
        QVERIFY2(!fitCounters({fine, far}, Attenuation::None), numberText(bad).c_str());
        QVERIFY2(!fitCounters({fine, time}, Attenuation::None), numberText(bad).c_str());
    }
    CounterReading near = fine;
    for (const double bad : {kNan, 1.4, -0.1}) {
        near.near_m = bad;
        QVERIFY(!fitCounters({near}, Attenuation::Linear));
    }
}

void TestShockProperties::moistAir_nonsense_isRefusedByName()
{
    const double good[] = {kAir_Pa, kRoom_K, 0.5, kUsualCarbonDioxide};
    const char *names[]
        = {"pressure", "temperature", "relative humidity", "mole fraction of carbon dioxide"};
    for (std::size_t i = 0; i < 4; ++i) {
        for (const double bad : {kNan, kInfinity, -1.0}) {
            double x[] = {good[0], good[1], good[2], good[3]};
            x[i] = bad;
            const auto refused = moistAir(x[0], x[1], x[2], x[3]);
            QVERIFY(!refused && refused.error().findingId == "SHK-009");
            QVERIFY2(english(refused.error().message).find(names[i]) != std::string::npos,
                english(refused.error().message).c_str());
        }
    }
    QCOMPARE(waterFraction(kAir_Pa, kRoom_K, 0.0), 0.0);
    QVERIFY(near(waterFraction(kAir_Pa, kRoom_K, 0.8), 2.0 * waterFraction(kAir_Pa, kRoom_K, 0.4)));
}

void TestShockProperties::conditions_permuteWithTheShots()
{
    const std::vector<std::pair<double, double>> around{
        {101e3, 294.0}, {99e3, 291.0}, {50e3, 300.0}};
    const std::vector<std::size_t> order{2, 0, 1};
    std::vector<std::pair<double, double>> permuted;
    for (const std::size_t i : order)
        permuted.push_back(around[i]);
    ShockSettings settings = settingsWithVelocity(520.0);
    settings.drivenLength_m = 0.97;
    settings.drivenGas.heatCapacity = kVariableHeatCapacity;
    const auto plain = estimateShockConditions(shotsOf(around), {}, settings);
    const auto other = estimateShockConditions(shotsOf(permuted), {}, settings);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const ShockConditions &a = plain->shots[order[i]], &b = other->shots[i];
        QCOMPARE(b.shot, static_cast<Index>(i) + 1);
        QVERIFY(a.step_Pa == b.step_Pa && a.plateau_s == b.plateau_s && a.step_Pa);
        const auto alone = estimateShockConditions(shotsOf({permuted[i]}), {}, settings);
        QVERIFY(alone->shots[0].step_Pa == b.step_Pa);
    }
}

void TestShockProperties::conditions_ofNonsense_haveNoStep_data()
{
    QTest::addColumn<double>("bad");
    QTest::newRow("not a number") << kNan;
    QTest::newRow("infinite") << kInfinity;
    QTest::newRow("negative") << -512.8;
    QTest::newRow("nothing") << 0.0;
}

void TestShockProperties::conditions_ofNonsense_haveNoStep()
{
    QFETCH(double, bad);
    const auto hasStep = [](const CaptureSet &set, const ShockSettings &settings,
                             const std::vector<DutArrival> &arrivals = {}) {
        const auto result = estimateShockConditions(set, arrivals, settings);
        return result && result->shots[0].step_Pa.has_value();
    };
    const CaptureSet set = shotsOf({{kAir_Pa, kRoom_K}});
    QVERIFY(hasStep(set, settingsWithVelocity(512.8)));
    QVERIFY(!hasStep(set, settingsWithVelocity(bad)));
    QVERIFY(!hasStep(shotsOf({{bad, kRoom_K}}), settingsWithVelocity(512.8)));
    QVERIFY(!hasStep(shotsOf({{kAir_Pa, bad}}), settingsWithVelocity(512.8)));
    for (const auto member : {&ShockSettings::p1_Pa, &ShockSettings::T1_K}) {
        ShockSettings settings = settingsWithVelocity(512.8);
        settings.*member = bad;
        QVERIFY(!hasStep(set, settings));
    }
    ShockSettings gas = settingsWithVelocity(512.8);
    gas.drivenGas = {bad, 0.029, "custom"};
    QVERIFY(!hasStep(set, gas));
    gas.drivenGas = {1.4, bad, "custom"};
    QVERIFY(!hasStep(set, gas));
    ShockSettings sensor;
    sensor.arrivalSensors = {{"side", 0.8, 1e-4, 4.4e-4}};
    QVERIFY(hasStep(set, sensor, {{1, 2e-3}}));
    QVERIFY(bad == 0.0 || !hasStep(set, sensor, {{1, bad}}));
    sensor.arrivalSensors[0].distanceToEndWall_m = bad;
    QVERIFY(!hasStep(set, sensor, {{1, 2e-3}}));
    for (const char *from : {"p2", "p4"}) {
        ShockSettings settings;
        settings.stateFrom = from;
        settings.p2_Pa = settings.p4_Pa = bad;
        QVERIFY(!hasStep(set, settings));
    }
}

void TestShockProperties::tubeOfNonsense_hasNoPlateau()
{
    CaptureSet set = shotsOf({{kAir_Pa, kRoom_K}});
    const auto plateauOf = [&](const char *length) {
        set.tube["driven_length_m"] = length;
        return estimateShockConditions(set, {}, settingsWithVelocity(512.8))->shots[0].plateau_s;
    };
    QVERIFY(plateauOf("0.97").has_value());
    for (const char *length : {"inf", "nan", "-1", "0", "", "0,97", "one"})
        QVERIFY2(!plateauOf(length), length);
    QVERIFY(near(*plateauOf("1.94"), 2.0 * *plateauOf("0.97")));
}

DYNCAL_TEST(TestShockProperties)
#include "tst_shock_properties.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_relations.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace dyncal;

namespace {

/// p5/p2 a second way, as a check of eq 3.5: from the reflected Mach number, which follows from M
/// in closed form (M_R/(M_R^2 - 1) = M/(M^2 - 1) sqrt(1 + 2(g-1)/(g+1)^2 (M^2 - 1)(g + 1/M^2))).
double reflectedMachOf(const Gas &gas, double mach)
{
    const double g = gas.gamma;
    const double excess = (mach - 1.0) * (mach + 1.0);
    const double right = mach / excess
        * std::sqrt(
            1.0 + 2.0 * (g - 1.0) / ((g + 1.0) * (g + 1.0)) * excess * (g + 1.0 / (mach * mach)));
    // M_R/(M_R^2 - 1) = right is M_R^2 - M_R/right - 1 = 0; its positive root.
    const double half = 0.5 / right;
    return half + std::hypot(half, 1.0);
}

double reflectedRatioOf(const Gas &gas, double mach)
{
    const double reflected = reflectedMachOf(gas, mach);
    return 1.0 + 2.0 * gas.gamma / (gas.gamma + 1.0) * (reflected - 1.0) * (reflected + 1.0);
}

const Gas kThesisAir{}; // table 4.1
constexpr double kThesisP1_Pa = 101100.0;
constexpr double kThesisT1_K = 294.15;
constexpr double kThesisT4_K = 295.35;
constexpr double kThesisVelocity_m_s = 512.82; ///< the only four-digit-compatible value that
                                               ///< gives every printed digit of table 4.2

/// Air-like gas with gamma 7/5, for the tables of normal shocks.
const Gas kDiatomic{1.4, 0.028966};

ShockStates statesAtMach(const Gas &gas, double mach)
{
    const double T1_K = 300.0;
    const auto states = shockStates(gas, 1e5, T1_K, mach * soundSpeed_m_s(gas, T1_K));
    return states.value();
}

ShockStates thesisStates(double velocity_m_s)
{
    const auto states = shockStates(kThesisAir, kThesisP1_Pa, kThesisT1_K, velocity_m_s);
    return states.value();
}

double relativeError(double actual, double expected)
{
    return std::abs(actual - expected) / std::abs(expected);
}

/// Rounded to `decimals`, as a table prints it.
QString printed(double value, int decimals)
{
    return QString::number(value, 'f', decimals);
}

/// Independent of eqs 3.5-3.9: Mach number of the reflected shock from the textbook identity
/// M_R/(M_R^2-1) = M/(M^2-1) sqrt(1 + 2(g-1)/(g+1)^2 (M^2-1)(g + 1/M^2)).
double reflectedMachOfIdentity(double gamma, double mach)
{
    const double m2 = mach * mach;
    const double k = mach / (m2 - 1.0)
        * std::sqrt(1.0
            + 2.0 * (gamma - 1.0) / ((gamma + 1.0) * (gamma + 1.0)) * (m2 - 1.0)
                * (gamma + 1.0 / m2));
    return (1.0 + std::sqrt(1.0 + 4.0 * k * k)) / (2.0 * k);
}

} // namespace

class TestShockRelations : public QObject
{
    Q_OBJECT

private slots:
    void thesisTable_velocity51282_everyPrintedDigit();
    void thesisInputs_velocity5128_sixDigits();
    void rationalCase_mach2_exact();
    void diatomicTable_data();
    void diatomicTable();
    void reflectedShock_anyMach_satisfiesIndependentIdentity();
    void conservation_acrossBothShocks_massMomentumEnergy();
    void weakShock_limit_stepDoubles();
    void strongShock_limit_ratioOfEight();
    void plateau_thesisTube_1626us();
    void soundSpeed_thesisAir_sixDigits();
    void mach_atOrBelowOne_blockedNamingWhatToCheck();
    void temperature_celsiusTyped_suggestsKelvin();
    void temperature_outsideRange_blockedWithoutSuggestion();
    void pressure_notPositive_blocked();
    void gas_nonsense_usage();
    void inputs_notFinite_neverYieldStates();
    void driver_unreachable_blocked();
    void driver_helium_needsLessPressure();
    void pressureRatio_turnedRound_givesMachBack();
    void driverPressure_turnedRound_givesVelocityBack_data();
    void driverPressure_turnedRound_givesVelocityBack();
    void driverPressure_notAboveP1_blocked();
    void region3_thesisShot_isTheExpandedDriver();
    void reflectedRatio_bothWays_agree();
};

void TestShockRelations::thesisTable_velocity51282_everyPrintedDigit()
{
    const ShockStates s = thesisStates(kThesisVelocity_m_s);
    const auto p4_Pa = driverPressure_Pa(s, kThesisAir, kThesisAir, kThesisT4_K);
    QVERIFY(p4_Pa.has_value());
    const GasState driver = gasAtRest(kThesisAir, *p4_Pa, kThesisT4_K);
    // Row "Pressure" (p1 is printed 0.101 there and 0.1011 in table 4.1).
    QCOMPARE(printed(s.driven.pressure_Pa / 1e6, 3), QString("0.101"));
    QCOMPARE(printed(s.shocked.pressure_Pa / 1e6, 3), QString("0.245"));
    QCOMPARE(printed(driver.pressure_Pa / 1e6, 3), QString("0.685"));
    QCOMPARE(printed(s.reflected.pressure_Pa / 1e6, 3), QString("0.536"));
    // Row "Temp": 294.15 and 295.35 lie on the rounding edge, so they are compared as numbers.
    QVERIFY(std::abs(s.driven.temperature_K - 294.2) <= 0.0501);
    QCOMPARE(printed(s.shocked.temperature_K, 1), QString("386.9"));
    QVERIFY(std::abs(driver.temperature_K - 295.4) <= 0.0501);
    QCOMPARE(printed(s.reflected.temperature_K, 1), QString("490.7"));
    // Row "Density".
    QCOMPARE(printed(s.driven.density_kg_m3, 3), QString("1.197"));
    QCOMPARE(printed(s.shocked.density_kg_m3, 3), QString("2.209"));
    QCOMPARE(printed(driver.density_kg_m3, 3), QString("8.078"));
    QCOMPARE(printed(s.reflected.density_kg_m3, 3), QString("3.803"));
    // Row "Sound vel." and "Particle vel.".
    QCOMPARE(printed(s.driven.soundSpeed_m_s, 1), QString("344.1"));
    QCOMPARE(printed(s.shocked.soundSpeed_m_s, 1), QString("394.6"));
    QCOMPARE(printed(driver.soundSpeed_m_s, 1), QString("344.8"));
    QCOMPARE(printed(s.reflected.soundSpeed_m_s, 1), QString("444.4"));
    QCOMPARE(printed(s.shocked.velocity_m_s, 1), QString("234.8"));
    QCOMPARE(s.driven.velocity_m_s, 0.0);
    QCOMPARE(s.reflected.velocity_m_s, 0.0);
    // "Approximated initial driver pressure 0.584 MPa" is gauge; "Mach number 1.49" is rounded.
    QCOMPARE(printed((driver.pressure_Pa - kThesisP1_Pa) / 1e6, 3), QString("0.584"));
    QCOMPARE(printed(s.mach, 2), QString("1.49"));
}

void TestShockRelations::thesisInputs_velocity5128_sixDigits()
{
    constexpr double kPrintedDigits = 6e-9; // the oracle is printed to nine significant digits
    const ShockStates s = thesisStates(512.8);
    const auto p4_Pa = driverPressure_Pa(s, kThesisAir, kThesisAir, kThesisT4_K);
    QVERIFY(p4_Pa.has_value());
    const double p1_Pa = kThesisP1_Pa;
    const double pairs[][2] = {{s.mach, 1.49044774}, {s.shocked.pressure_Pa / p1_Pa, 2.42585440},
        {s.shocked.temperature_K / kThesisT1_K, 1.31525256},
        {s.shocked.density_kg_m3 / s.driven.density_kg_m3, 1.84440197},
        {s.shocked.velocity_m_s, 234.769500},
        {s.reflected.pressure_Pa / s.shocked.pressure_Pa, 2.18385156},
        {s.reflected.temperature_K / s.shocked.temperature_K, 1.26829421},
        {s.reflected.density_kg_m3 / s.shocked.density_kg_m3, 1.72188088},
        {s.reflectedVelocity_m_s, 325.219169}, {s.reflectedMach, 1.41919934},
        {*p4_Pa / p1_Pa, 6.77262061}, {s.shocked.pressure_Pa, 0.245253880e6},
        {s.reflected.pressure_Pa, 0.535598068e6}, {*p4_Pa, 0.684711943e6},
        {s.reflected.pressure_Pa - p1_Pa, 434498.068}, {s.shocked.temperature_K, 386.881540},
        {s.reflected.temperature_K, 490.679618}, {s.driven.density_kg_m3, 1.19739280},
        {s.shocked.density_kg_m3, 2.20847364},
        {gasAtRest(kThesisAir, *p4_Pa, kThesisT4_K).density_kg_m3, 8.07653853},
        {s.reflected.density_kg_m3, 3.80272854}, {s.shocked.soundSpeed_m_s, 394.580701},
        {s.reflected.soundSpeed_m_s, 444.371140}};
    for (const auto &[actual, expected] : pairs)
        QVERIFY2(relativeError(actual, expected) < kPrintedDigits,
            qPrintable(QString("%1 against %2").arg(actual, 0, 'g', 12).arg(expected, 0, 'g', 12)));
}

void TestShockRelations::rationalCase_mach2_exact()
{
    constexpr double kRounding = 1e-12; // a dozen roundings of 1e-16
    const ShockStates s = statesAtMach(kDiatomic, 2.0);
    const double a1_m_s = s.driven.soundSpeed_m_s;
    const auto p4_Pa = driverPressure_Pa(s, kDiatomic, kDiatomic, s.driven.temperature_K);
    QVERIFY(p4_Pa.has_value());
    const double pairs[][2] = {{s.shocked.pressure_Pa / s.driven.pressure_Pa, 9.0 / 2.0},
        {s.shocked.temperature_K / s.driven.temperature_K, 27.0 / 16.0},
        {s.shocked.density_kg_m3 / s.driven.density_kg_m3, 8.0 / 3.0},
        {s.shocked.velocity_m_s / a1_m_s, 5.0 / 4.0},
        {s.reflected.pressure_Pa / s.shocked.pressure_Pa, 10.0 / 3.0},
        {s.reflected.pressure_Pa / s.driven.pressure_Pa, 15.0},
        {s.reflected.temperature_K / s.shocked.temperature_K, 40.0 / 27.0},
        {s.reflected.temperature_K / s.driven.temperature_K, 5.0 / 2.0},
        {s.reflected.density_kg_m3 / s.shocked.density_kg_m3, 9.0 / 4.0},
        {s.reflectedMach, std::sqrt(3.0)}, {s.reflectedVelocity_m_s / a1_m_s, 1.0},
        {*p4_Pa / s.driven.pressure_Pa, 4.5 * std::pow(4.0 / 3.0, 7.0)}};
    for (const auto &[actual, expected] : pairs)
        QVERIFY2(relativeError(actual, expected) < kRounding,
            qPrintable(QString("%1 against %2").arg(actual, 0, 'g', 17).arg(expected, 0, 'g', 17)));
}

void TestShockRelations::diatomicTable_data()
{
    QTest::addColumn<double>("mach");
    QTest::addColumn<QList<double>>("ratios");
    // p2/p1, T2/T1, rho2/rho1, u2/a1, p5/p2, p5/p1, T5/T1, M_R, p4/p1
    const auto row = [](double mach, const QList<double> &ratios) {
        QTest::addRow("M %.2f", mach) << mach << ratios;
    };
    row(1.05,
        {1.119583, 1.032843, 1.083982, 0.081349, 1.117575, 1.251218, 1.066216, 1.049180, 1.255812});
    row(1.10,
        {1.245000, 1.064938, 1.169082, 0.159091, 1.236715, 1.539710, 1.131901, 1.096767, 1.561244});
    row(1.20,
        {1.513333, 1.127994, 1.341615, 0.305556, 1.478261, 2.237101, 1.263457, 1.187408, 2.353072});
    row(1.30,
        {1.805000, 1.190873, 1.515695, 0.442308, 1.721973, 3.108161, 1.397396, 1.272334, 3.451852});
    row(1.40,
        {2.120000, 1.254694, 1.689655, 0.571429, 1.965517, 4.166897, 1.535510, 1.351882, 4.957701});
    row(1.50,
        {2.458333, 1.320216, 1.862069, 0.694444, 2.206897, 5.425287, 1.679012, 1.426353, 7.002070});
    row(1.60,
        {2.820000, 1.387969, 2.031746, 0.812500, 2.444444, 6.893333, 1.828750, 1.496026, 9.757878});
    row(1.80,
        {3.613333, 1.531578, 2.359223, 1.037037, 2.902913, 10.489191, 2.149191, 1.622057,
            18.388994});
    row(2.50,
        {7.125000, 2.137500, 3.333333, 1.750000, 4.266667, 30.400000, 3.520000, 1.949359,
            145.342080});
    row(3.00,
        {10.333333, 2.679012, 3.857143, 2.222222, 5.000000, 51.666667, 4.753086, 2.104417,
            632.627366});
}

void TestShockRelations::diatomicTable()
{
    constexpr double kHalfDigit = 0.51e-6; // the table prints six decimals
    QFETCH(double, mach);
    QFETCH(QList<double>, ratios);
    const ShockStates s = statesAtMach(kDiatomic, mach);
    const auto p4_Pa = driverPressure_Pa(s, kDiatomic, kDiatomic, s.driven.temperature_K);
    QVERIFY(p4_Pa.has_value());
    const QList<double> actual{s.shocked.pressure_Pa / s.driven.pressure_Pa,
        s.shocked.temperature_K / s.driven.temperature_K,
        s.shocked.density_kg_m3 / s.driven.density_kg_m3,
        s.shocked.velocity_m_s / s.driven.soundSpeed_m_s,
        s.reflected.pressure_Pa / s.shocked.pressure_Pa,
        s.reflected.pressure_Pa / s.driven.pressure_Pa,
        s.reflected.temperature_K / s.driven.temperature_K, s.reflectedMach,
        *p4_Pa / s.driven.pressure_Pa};
    for (qsizetype i = 0; i < actual.size(); ++i)
        QVERIFY2(std::abs(actual[i] - ratios[i]) < kHalfDigit,
            qPrintable(QString("column %1: %2").arg(i).arg(actual[i], 0, 'f', 8)));
}

void TestShockRelations::reflectedShock_anyMach_satisfiesIndependentIdentity()
{
    constexpr double kRounding = 2e-11; // the identity itself cancels near M = 1
    for (const double gamma : {1.2, 1.4, 1.402, 5.0 / 3.0}) {
        for (double mach = 1.001; mach < 12.0; mach *= 1.07) {
            const ShockStates s = statesAtMach({gamma, 0.028966}, mach);
            const double expected = reflectedMachOfIdentity(gamma, mach);
            QVERIFY2(relativeError(s.reflectedMach, expected) < kRounding,
                qPrintable(QString("gamma %1, M %2").arg(gamma).arg(mach)));
            const double ratio = 1.0 + 2.0 * gamma / (gamma + 1.0) * (expected * expected - 1.0);
            QVERIFY(
                relativeError(s.reflected.pressure_Pa / s.shocked.pressure_Pa, ratio) < kRounding);
        }
    }
}

void TestShockRelations::conservation_acrossBothShocks_massMomentumEnergy()
{
    constexpr double kRounding = 1e-12;
    for (const double mach : {1.01, 1.25, 1.49, 3.0, 8.0}) {
        const ShockStates s = statesAtMach(kThesisAir, mach);
        const double cp = kThesisAir.gamma / (kThesisAir.gamma - 1.0) * kGasConstant_J_molK
            / kThesisAir.molarMass_kg_mol;
        const auto conserved = [&](const GasState &ahead, double v1, const GasState &behind,
                                   double v2) { // velocities relative to the shock
            QVERIFY(relativeError(behind.density_kg_m3 * v2, ahead.density_kg_m3 * v1) < kRounding);
            QVERIFY(relativeError(behind.pressure_Pa + behind.density_kg_m3 * v2 * v2,
                        ahead.pressure_Pa + ahead.density_kg_m3 * v1 * v1)
                < kRounding);
            QVERIFY(relativeError(cp * behind.temperature_K + v2 * v2 / 2.0,
                        cp * ahead.temperature_K + v1 * v1 / 2.0)
                < kRounding);
        };
        conserved(s.driven, s.velocity_m_s, s.shocked, s.velocity_m_s - s.shocked.velocity_m_s);
        conserved(s.shocked, s.reflectedVelocity_m_s + s.shocked.velocity_m_s, s.reflected,
            s.reflectedVelocity_m_s);
    }
}

void TestShockRelations::weakShock_limit_stepDoubles()
{
    for (const double excess : {1e-3, 1e-4, 1e-6}) {
        const ShockStates s = statesAtMach(kThesisAir, 1.0 + excess);
        const double first = s.shocked.pressure_Pa - s.driven.pressure_Pa;
        const double both = s.reflected.pressure_Pa - s.driven.pressure_Pa;
        QVERIFY(std::abs(both / first - 2.0) < 5.0 * excess); // first order in M - 1
        QVERIFY(relativeError(s.reflectedVelocity_m_s, s.driven.soundSpeed_m_s) < 5.0 * excess);
        QVERIFY(s.reflectedMach > 1.0);
    }
}

void TestShockRelations::strongShock_limit_ratioOfEight()
{
    const ShockStates s = statesAtMach(kDiatomic, 1e4);
    QVERIFY(relativeError(s.reflected.pressure_Pa / s.shocked.pressure_Pa, 8.0) < 1e-6);
    QVERIFY(relativeError(s.shocked.density_kg_m3 / s.driven.density_kg_m3, 6.0) < 1e-6);
}

void TestShockRelations::plateau_thesisTube_1626us()
{
    constexpr double kLength_m = 0.97;
    const ShockStates s = thesisStates(512.8);
    const double plateau_s = plateauTime_s(s, kLength_m);
    QCOMPARE(printed(plateau_s * 1e3, 3), QString("1.626"));
    // The stations of the derivation: arrival 1.8915 ms, meeting 0.9391 ms later, 0.3054 m out.
    const double arrival_s = kLength_m / s.velocity_m_s;
    QVERIFY(std::abs(arrival_s - 1.8915e-3) < 1e-7);
    const double meeting_s
        = plateau_s / (1.0 + s.reflectedVelocity_m_s / s.reflected.soundSpeed_m_s);
    QVERIFY(std::abs(meeting_s - 0.9391e-3) < 1e-7);
    QVERIFY(std::abs(s.reflectedVelocity_m_s * meeting_s - 0.3054) < 1e-4);
    QVERIFY(relativeError(plateauTime_s(s, 2.0 * kLength_m), 2.0 * plateau_s) < 1e-14);
}

void TestShockRelations::soundSpeed_thesisAir_sixDigits()
{
    QVERIFY(relativeError(soundSpeed_m_s(kThesisAir, kThesisT1_K), 344.057685) < 3e-9);
    QVERIFY(relativeError(soundSpeed_m_s(kThesisAir, kThesisT4_K), 344.758771) < 3e-9);
}

void TestShockRelations::mach_atOrBelowOne_blockedNamingWhatToCheck()
{
    const double a1_m_s = soundSpeed_m_s(kThesisAir, kThesisT1_K);
    for (const double velocity_m_s : {a1_m_s, 337.0, 51.28, 0.0, -512.8}) {
        const auto states = shockStates(kThesisAir, kThesisP1_Pa, kThesisT1_K, velocity_m_s);
        QVERIFY(!states.has_value());
        QCOMPARE(states.error().kind, ErrorKind::DataBlocked);
        QCOMPARE(states.error().findingId, std::string("SHK-001"));
    }
    const auto slow = shockStates(kThesisAir, kThesisP1_Pa, kThesisT1_K, 51.28);
    const QString text = QString::fromStdString(english(slow.error().message));
    QVERIFY2(text.contains("Mach number 0.149"), qPrintable(text));
    for (const char *word : {"sample rate", "distance", "arrival times", "T1"})
        QVERIFY2(text.contains(word), word);
}

void TestShockRelations::temperature_celsiusTyped_suggestsKelvin()
{
    const auto states = shockStates(kThesisAir, kThesisP1_Pa, 21.0, 512.8);
    QVERIFY(!states.has_value());
    QCOMPARE(states.error().findingId, std::string("SHK-004"));
    QCOMPARE(english(states.error().message),
        std::string(
            "T1 = 21 K? Temperatures are in kelvin here: 21 degrees Celsius are 294.15 K."));
    const ShockStates s = thesisStates(512.8);
    const auto driver = driverPressure_Pa(s, kThesisAir, kThesisAir, 22.2);
    QVERIFY(!driver.has_value());
    QCOMPARE(english(driver.error().message),
        std::string(
            "T4 = 22.2 K? Temperatures are in kelvin here: 22.2 degrees Celsius are 295.35 K."));
}

void TestShockRelations::temperature_outsideRange_blockedWithoutSuggestion()
{
    for (const double T1_K : {-300.0, 199.9, 400.1, 5000.0}) {
        const auto states = shockStates(kThesisAir, kThesisP1_Pa, T1_K, 512.8);
        QVERIFY(!states.has_value());
        QCOMPARE(states.error().findingId, std::string("SHK-004"));
        const std::string text = english(states.error().message);
        QVERIFY2(text.find("200 K to 400 K") != std::string::npos, text.c_str());
    }
    for (const double T1_K : {200.0, 400.0})
        QVERIFY(shockStates(kThesisAir, kThesisP1_Pa, T1_K, 512.8).has_value());
}

void TestShockRelations::pressure_notPositive_blocked()
{
    for (const double p1_Pa : {0.0, -101100.0}) {
        const auto states = shockStates(kThesisAir, p1_Pa, kThesisT1_K, 512.8);
        QVERIFY(!states.has_value());
        QCOMPARE(states.error().kind, ErrorKind::DataBlocked);
        QVERIFY(english(states.error().message).find("absolute") != std::string::npos);
    }
}

void TestShockRelations::gas_nonsense_usage()
{
    const Gas nonsense[]
        = {{1.0, 0.028966}, {0.0, 0.028966}, {2.5, 0.028966}, {1.4, 0.0}, {1.4, 28.966}};
    for (const Gas &gas : nonsense) {
        const auto states = shockStates(gas, kThesisP1_Pa, kThesisT1_K, 512.8);
        QVERIFY(!states.has_value());
        QCOMPARE(states.error().kind, ErrorKind::Usage);
        const auto driver = driverPressure_Pa(thesisStates(512.8), kThesisAir, gas, kThesisT4_K);
        QVERIFY(!driver.has_value());
    }
    const auto grams = shockStates({1.402, 28.966}, kThesisP1_Pa, kThesisT1_K, 512.8);
    QVERIFY(english(grams.error().message).find("g/mol") != std::string::npos);
}

void TestShockRelations::inputs_notFinite_neverYieldStates()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
        QVERIFY(!shockStates(kThesisAir, bad, kThesisT1_K, 512.8).has_value());
        QVERIFY(!shockStates(kThesisAir, kThesisP1_Pa, bad, 512.8).has_value());
        QVERIFY(!shockStates(kThesisAir, kThesisP1_Pa, kThesisT1_K, bad).has_value());
        QVERIFY(!shockStates({bad, 0.028966}, kThesisP1_Pa, kThesisT1_K, 512.8).has_value());
        QVERIFY(!shockStates({1.402, bad}, kThesisP1_Pa, kThesisT1_K, 512.8).has_value());
    }
}

void TestShockRelations::driver_unreachable_blocked()
{
    // Air driving air cannot exceed a Mach number of about 6.2 at equal temperatures.
    const ShockStates s = statesAtMach(kDiatomic, 7.0);
    const auto p4_Pa = driverPressure_Pa(s, kDiatomic, kDiatomic, 300.0);
    QVERIFY(!p4_Pa.has_value());
    QCOMPARE(p4_Pa.error().kind, ErrorKind::DataBlocked);
    QVERIFY(english(p4_Pa.error().message).find("Mach 7") != std::string::npos);
}

void TestShockRelations::driver_helium_needsLessPressure()
{
    const Gas helium{5.0 / 3.0, 0.0040026};
    const ShockStates s = thesisStates(512.8);
    const auto withHelium = driverPressure_Pa(s, kThesisAir, helium, kThesisT4_K);
    const auto withAir = driverPressure_Pa(s, kThesisAir, kThesisAir, kThesisT4_K);
    QVERIFY(withHelium.has_value());
    QVERIFY(*withHelium < *withAir);
    QVERIFY(*withHelium > s.shocked.pressure_Pa);
}

void TestShockRelations::pressureRatio_turnedRound_givesMachBack()
{
    for (const double mach : {1.0001, 1.2, 1.49, 3.0, 9.0}) {
        const ShockStates s = statesAtMach(kThesisAir, mach);
        const auto found
            = machOfPressureRatio(kThesisAir, s.shocked.pressure_Pa / s.driven.pressure_Pa);
        QVERIFY(relativeError(found.value(), mach) < 1e-12);
    }
    for (const double ratio : {1.0, 0.5, -1.0, std::nan("")}) {
        const auto failed = machOfPressureRatio(kThesisAir, ratio);
        QVERIFY(!failed);
        QCOMPARE(failed.error().findingId, std::string("SHK-001"));
    }
}

void TestShockRelations::driverPressure_turnedRound_givesVelocityBack_data()
{
    QTest::addColumn<double>("gamma4");
    QTest::addColumn<double>("molarMass4");
    QTest::addRow("air") << 1.402 << 0.028966;
    QTest::addRow("helium") << 5.0 / 3.0 << 0.0040026;
    QTest::addRow("argon") << 5.0 / 3.0 << 0.039948;
}

void TestShockRelations::driverPressure_turnedRound_givesVelocityBack()
{
    QFETCH(double, gamma4);
    QFETCH(double, molarMass4);
    const Gas driver{gamma4, molarMass4};
    for (const double velocity_m_s : {350.0, 430.0, 512.82, 900.0}) {
        const ShockStates s = thesisStates(velocity_m_s);
        const auto p4_Pa = driverPressure_Pa(s, kThesisAir, driver, kThesisT4_K);
        QVERIFY(p4_Pa.has_value());
        const auto found = velocityOfDriverPressure_m_s(
            kThesisAir, kThesisP1_Pa, kThesisT1_K, driver, *p4_Pa, kThesisT4_K);
        QVERIFY(relativeError(found.value(), velocity_m_s) < 1e-12);
    }
}

void TestShockRelations::driverPressure_notAboveP1_blocked()
{
    const auto failed = velocityOfDriverPressure_m_s(
        kThesisAir, kThesisP1_Pa, kThesisT1_K, kThesisAir, 0.9e5, kThesisT4_K);
    QVERIFY(!failed);
    QVERIFY(english(failed.error().message).find("gauge") != std::string::npos);
    const auto celsius = velocityOfDriverPressure_m_s(
        kThesisAir, kThesisP1_Pa, kThesisT1_K, kThesisAir, 6e5, 22.2);
    QVERIFY(!celsius);
    QCOMPARE(celsius.error().findingId, std::string("SHK-004"));
    // Any pressure above p1 makes a shock; a huge one only approaches the largest Mach number.
    const auto huge = velocityOfDriverPressure_m_s(
        kThesisAir, kThesisP1_Pa, kThesisT1_K, kThesisAir, 1e30, kThesisT4_K);
    QVERIFY(huge.value() / soundSpeed_m_s(kThesisAir, kThesisT1_K) < 6.5);
}

void TestShockRelations::region3_thesisShot_isTheExpandedDriver()
{
    const ShockStates s = thesisStates(512.8);
    const double p4_Pa = driverPressure_Pa(s, kThesisAir, kThesisAir, kThesisT4_K).value();
    const GasState three = expandedDriver(s, kThesisAir, p4_Pa, kThesisT4_K);
    QCOMPARE(three.pressure_Pa, s.shocked.pressure_Pa);
    QCOMPARE(three.velocity_m_s, s.shocked.velocity_m_s);
    // Riemann invariant of the expansion: a4 = a3 + (gamma - 1)/2 u3.
    const double a4_m_s = soundSpeed_m_s(kThesisAir, kThesisT4_K);
    QVERIFY(relativeError(three.soundSpeed_m_s + 0.201 * three.velocity_m_s, a4_m_s) < 1e-12);
}

void TestShockRelations::reflectedRatio_bothWays_agree()
{
    for (double mach = 1.001; mach < 12.0; mach *= 1.1) {
        const ShockStates s = statesAtMach(kThesisAir, mach);
        QVERIFY(relativeError(reflectedMachOf(kThesisAir, mach), s.reflectedMach) < 1e-11);
        QVERIFY(relativeError(reflectedRatioOf(kThesisAir, mach),
                    s.reflected.pressure_Pa / s.shocked.pressure_Pa)
            < 1e-11);
    }
}

DYNCAL_TEST(TestShockRelations)
#include "tst_shock_relations.moc"

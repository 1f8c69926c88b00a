// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/mach_ways.h"

#include "core/base/constants.h"
#include "core/shock/variable_shock.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace dyncal;

namespace {

GasBefore diatomic()
{
    GasModel gas;
    gas.constants = {1.4, 0.028966};
    return {gas, 1e5, 300.0};
}

} // namespace

class TestMachWays : public QObject
{
    Q_OBJECT

private slots:
    void stepRatio_machTwo_exact()
    {
        // gamma 7/5, M 2: p2/p1 = 9/2, p5/p1 = 15, so that r = 10.5/3.5.
        QVERIFY(std::abs(*machOfStepRatio(diatomic(), 3.0, 1.0) - 2.0) < 1e-10);
    }

    void velocityRatio_machTwo_exact()
    {
        // W_R/a1 = 1 there.
        QVERIFY(std::abs(*machOfVelocityRatio(diatomic(), 2.0) - 2.0) < 1e-10);
    }

    void bothRatios_giveTheMachNumberBack_alsoWithVariableHeatCapacity()
    {
        GasBefore before = diatomic();
        for (const bool isVariable : {false, true}) {
            if (isVariable)
                before.gas = gasModel(
                    {1.4, 0.0280134, "n2", kVariableHeatCapacity}, {1e5, 300.0, 0.0, 0.0})
                                 .value();
            const double a1 = soundSpeed_m_s(before.gas.constants, 300.0);
            for (const double mach : {1.05, 1.2, 1.5, 1.9}) {
                const auto s = shockStatesOf(before.gas, 1e5, 300.0, mach * a1).value();
                const double r = (s.reflected.pressure_Pa - s.shocked.pressure_Pa)
                    / (s.shocked.pressure_Pa - 1e5);
                QVERIFY(std::abs(*machOfStepRatio(before, r, 1.0) - mach) < 1e-8);
                QVERIFY(
                    std::abs(*machOfVelocityRatio(before, s.velocity_m_s / s.reflectedVelocity_m_s)
                        - mach)
                    < 1e-8);
            }
        }
    }

    void fasterAtTheSensor_isTakenOff()
    {
        // 1 % faster there than at the wall, by a shock that slows down.
        const GasBefore before = diatomic();
        const double a1 = soundSpeed_m_s(before.gas.constants, 300.0);
        const auto wall = shockStates(before.gas.constants, 1e5, 300.0, 1.5 * a1).value();
        const auto local = shockStates(before.gas.constants, 1e5, 300.0, 1.515 * a1).value();
        const double r = (wall.reflected.pressure_Pa - local.shocked.pressure_Pa)
            / (local.shocked.pressure_Pa - 1e5);
        QVERIFY(std::abs(*machOfStepRatio(before, r, 1.01) - 1.5) < 1e-9);
        QVERIFY(std::abs(*machOfStepRatio(before, r, 1.0) - 1.5) > 1e-3);
    }

    void monatomicGas_machTwo_exact()
    {
        // gamma 5/3, M 2: p2/p1 = 19/4, p5/p2 = 22/7, so that r = 19/7; u2/a1 = 9/8 and
        // rho5/rho2 = 19/10, so that W_R/a1 = 5/4.
        GasBefore before = diatomic();
        before.gas.constants = {5.0 / 3.0, 0.039948};
        QVERIFY(std::abs(*machOfStepRatio(before, 19.0 / 7.0, 1.0) - 2.0) < 1e-10);
        QVERIFY(std::abs(*machOfVelocityRatio(before, 1.6) - 2.0) < 1e-10);
    }

    void machBeyondThree_isFound()
    {
        const GasBefore before = diatomic();
        const double a1 = soundSpeed_m_s(before.gas.constants, 300.0);
        for (const double mach : {3.5, 6.0}) {
            const auto s = shockStates(before.gas.constants, 1e5, 300.0, mach * a1).value();
            const double r
                = (s.reflected.pressure_Pa - s.shocked.pressure_Pa) / (s.shocked.pressure_Pa - 1e5);
            QVERIFY(std::abs(*machOfStepRatio(before, r, 1.0) - mach) < 1e-8);
            QVERIFY(std::abs(*machOfVelocityRatio(before, s.velocity_m_s / s.reflectedVelocity_m_s)
                        - mach)
                < 1e-8);
        }
    }

    void slowerAtTheSensor_isTakenOff_data()
    {
        QTest::addColumn<double>("mach");
        QTest::addColumn<double>("localFactor");
        // A shock that still forms, within the usual range of -0.5 % per metre and beyond it.
        QTest::newRow("weak") << 1.3 << 0.998;
        QTest::newRow("usual") << 1.5 << 0.996;
        QTest::newRow("long way") << 1.5 << 0.98;
        QTest::newRow("strong") << 2.8 << 0.97;
        QTest::newRow("beyond three") << 3.5 << 0.99;
    }

    void slowerAtTheSensor_isTakenOff()
    {
        QFETCH(double, mach);
        QFETCH(double, localFactor);
        const GasBefore before = diatomic();
        const double a1 = soundSpeed_m_s(before.gas.constants, 300.0);
        const auto wall = shockStates(before.gas.constants, 1e5, 300.0, mach * a1).value();
        const auto local
            = shockStates(before.gas.constants, 1e5, 300.0, localFactor * mach * a1).value();
        const double r = (wall.reflected.pressure_Pa - local.shocked.pressure_Pa)
            / (local.shocked.pressure_Pa - 1e5);
        const auto found = machOfStepRatio(before, r, localFactor);
        QVERIFY(found);
        QVERIFY(std::abs(*found - mach) < 1e-8);
    }

    void gasThatLeavesItsRangeEarly_hasAMachNumberWithin_data()
    {
        QTest::addColumn<QString>("substance");
        QTest::addColumn<double>("T1_K");
        QTest::addColumn<double>("mach");
        // At M 3 all of these are hotter than the 1500 K that a variable heat capacity is good for.
        QTest::newRow("argon") << "ar" << 295.0 << 1.6;
        QTest::newRow("helium, near the limit") << "he" << 295.0 << 2.2;
        QTest::newRow("hot nitrogen") << "n2" << 390.0 << 2.0;
    }

    void gasThatLeavesItsRangeEarly_hasAMachNumberWithin()
    {
        QFETCH(QString, substance);
        QFETCH(double, T1_K);
        QFETCH(double, mach);
        const NamedGas &named = *std::ranges::find_if(
            knownGases(), [&](const NamedGas &gas) { return substance.toStdString() == gas.name; });
        const GasModel gas
            = gasModel({named.gamma, named.molarMass_kg_mol, named.name, kVariableHeatCapacity},
                {1e5, T1_K, 0.0, 0.0})
                  .value();
        const GasBefore before{gas, 1e5, T1_K};
        const double a1 = soundSpeed_m_s(gas.constants, T1_K);
        QVERIFY(!shockStatesOf(gas, 1e5, T1_K, 3.0 * a1));
        const auto s = shockStatesOf(gas, 1e5, T1_K, mach * a1).value();
        const double r
            = (s.reflected.pressure_Pa - s.shocked.pressure_Pa) / (s.shocked.pressure_Pa - 1e5);
        const auto ofSteps = machOfStepRatio(before, r, 1.0);
        const auto ofVelocities
            = machOfVelocityRatio(before, s.velocity_m_s / s.reflectedVelocity_m_s);
        QVERIFY(ofSteps && ofVelocities);
        QVERIFY(std::abs(*ofSteps - mach) < 1e-8);
        QVERIFY(std::abs(*ofVelocities - mach) < 1e-8);
        QVERIFY(!machOfStepRatio(before, 20.0, 1.0)); // would be hotter than the gas is known for
    }

    void machBelowTheRange_isNone()
    {
        const GasBefore before = diatomic();
        const double a1 = soundSpeed_m_s(before.gas.constants, 300.0);
        for (const auto &[mach, isInside] : {std::pair{1.0011, true}, std::pair{1.0009, false}}) {
            const auto s = shockStates(before.gas.constants, 1e5, 300.0, mach * a1).value();
            const double r
                = (s.reflected.pressure_Pa - s.shocked.pressure_Pa) / (s.shocked.pressure_Pa - 1e5);
            QCOMPARE(machOfStepRatio(before, r, 1.0).has_value(), isInside);
            QCOMPARE(
                machOfVelocityRatio(before, s.velocity_m_s / s.reflectedVelocity_m_s).has_value(),
                isInside);
        }
    }

    void ratioOfNoShock_hasNoMachNumber()
    {
        QVERIFY(!machOfStepRatio(diatomic(), 0.9, 1.0));
        QVERIFY(!machOfStepRatio(diatomic(), 0.9, 0.99));
        QVERIFY(!machOfStepRatio(diatomic(), kUnknown, 1.0));
        QVERIFY(!machOfVelocityRatio(diatomic(), 0.9));
        QVERIFY(!machOfVelocityRatio(diatomic(), 50.0));
    }
};

DYNCAL_TEST(TestMachWays)
#include "tst_mach_ways.moc"

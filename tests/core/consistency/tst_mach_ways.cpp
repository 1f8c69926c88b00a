// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/mach_ways.h"
#include "core/shock/variable_shock.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <cmath>

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

    void ratioOfNoShock_hasNoMachNumber()
    {
        QVERIFY(!machOfStepRatio(diatomic(), 0.9, 1.0));
        QVERIFY(!machOfVelocityRatio(diatomic(), 0.9));
        QVERIFY(!machOfVelocityRatio(diatomic(), 50.0));
    }
};

DYNCAL_TEST(TestMachWays)
#include "tst_mach_ways.moc"

// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/consistency/faults.h"

#include "core/shock/gas_model.h"
#include "tests/support/made_evidence.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using C = FindingCause;
using Names = std::set<std::string>;

const std::vector<std::string> kSensors{"side 1", "side 2"};

/// The one of that cause; several of one cause come in the order of the list.
Fault faultOf(C cause, int which = 0)
{
    for (const Fault &fault : possibleFaults(kSensors))
        if (fault.cause == cause && which-- == 0)
            return fault;
    throw std::runtime_error("no such fault");
}

/// Share of a gas in the one used.
Fault mixtureWith(const std::string &name)
{
    const auto &gases = knownGases();
    const auto found
        = std::ranges::find_if(gases, [&](const NamedGas &gas) { return name == gas.name; });
    return faultOf(C::Gas, 1 + static_cast<int>(found - gases.begin()));
}

/// A shot with something that every fault acts on.
ShotEvidence evidenceOfAll()
{
    ShotEvidence evidence = madeEvidence({.typedVelocity_m_s = 500.0});
    evidence.measurement->gas.substance = kMoistAir;
    evidence.measurement->state.relativeHumidity = 0.4;
    return evidence;
}

/// What a point holds, by name.
std::map<std::string, std::vector<double>> contentOf(const CheckPoint &p)
{
    const auto list
        = [](const Eigen::VectorXd &v) { return std::vector<double>(v.begin(), v.end()); };
    const SectionState &state = p.step.state;
    return {{"p1", {state.pressure_Pa}}, {"T1", {state.temperature_K}},
        {"humidity", {state.relativeHumidity}}, {"CO2", {state.carbonDioxide}},
        {"gamma", {p.step.gammaShift}}, {"molar mass", {p.step.molarMassShift_kg_mol}},
        {"velocity", {p.step.velocityShift_m_s}}, {"step", {p.step.stepFactor}},
        {"distances", list(p.step.distance_m)}, {"times", list(p.step.time_s)},
        {"delays", list(p.step.delay_s)}, {"attenuation", {p.step.attenuation_per_m}},
        {"gain", list(p.gain)}, {"step ratio", list(p.stepRatio)}, {"clock", {p.timeFactor}},
        {"velocity ratio", {p.velocityRatio}}, {"p4", {p.p4}}, {"level", {p.level}},
        {"card", {p.card}}};
}

CheckPoint nominalOf(const ShotEvidence &evidence)
{
    const std::vector<StatedUncertainty> stated;
    return ShotWays(evidence, stated).nominal();
}

struct Taken
{
    bool possible = false;
    CheckPoint before;
    CheckPoint after;

    Names changed() const
    {
        Names names;
        const auto old = contentOf(before);
        for (const auto &[name, value] : contentOf(after))
            if (value != old.at(name))
                names.insert(name);
        return names;
    }
};

Taken taken(const Fault &fault, const ShotEvidence &evidence, double size)
{
    Taken result{false, nominalOf(evidence), nominalOf(evidence)};
    result.possible = fault.takeBack(evidence, size, result.after);
    return result;
}

bool isNear(double value, double expected)
{
    return std::abs(value - expected) <= 1e-12 * std::abs(expected);
}

} // namespace

class TestFaults : public QObject
{
    Q_OBJECT

private slots:
    void everyFault_changesWhatItClaimsAlone_data();
    void everyFault_changesWhatItClaimsAlone();
    void noFault_changesAnythingAtSizeZero();
    void factors_areExponentials();
    void differences_areAdded();
    void molarMass_actsOnTheSpeedOfSound();
    void mixture_isThatOfMoles();
    void wholeShare_isTheOtherGas();
    void shares_lieBetweenNothingAndAll();
    void distance_movesItsSensorAlone();
    void distance_isAboveZero();
    void delays_areThoseOfTheSideSensors();
    void typedDelays_areThoseThatWereTyped();
    void counters_moveTheVelocity();
    void typedStep_goesBeforeTheTypedVelocity();
    void nothingToActOn_changesNothing();
    void humidity_staysBetweenDryAndSaturated();
    void everyFault_isListedOnce();
    void takenBack_theShotsAgreeAgain_data();
    void takenBack_theShotsAgreeAgain();
};

void TestFaults::everyFault_changesWhatItClaimsAlone_data()
{
    QTest::addColumn<C>("cause");
    QTest::addColumn<int>("which");
    QTest::addColumn<Names>("changes");
    QTest::newRow("typed") << C::Typed << 0 << Names{"velocity"};
    QTest::newRow("rate") << C::Rate << 0 << Names{"clock"};
    QTest::newRow("gas: molar mass") << C::Gas << 0 << Names{"molar mass"};
    QTest::newRow("gas: mixture") << C::Gas << 3 << Names{"gamma", "molar mass"};
    QTest::newRow("temperature") << C::Temperature << 0 << Names{"T1"};
    QTest::newRow("humidity") << C::Humidity << 0 << Names{"humidity"};
    QTest::newRow("pressure") << C::Pressure << 0 << Names{"p1"};
    QTest::newRow("scale of the DUT") << C::Scale << 0 << Names{"level"};
    QTest::newRow("scale of the side sensors") << C::Scale << 1 << Names{"gain"};
    QTest::newRow("attenuation") << C::Attenuation << 0 << Names{"attenuation"};
    QTest::newRow("delay") << C::Delay << 0 << Names{"delays"};
    QTest::newRow("distance") << C::Distance << 0 << Names{"distances"};
}

void TestFaults::everyFault_changesWhatItClaimsAlone()
{
    QFETCH(C, cause);
    QFETCH(int, which);
    QFETCH(Names, changes);
    const Fault fault = faultOf(cause, which);
    const ShotEvidence evidence = evidenceOfAll();
    const Taken half = taken(fault, evidence, 0.5 * fault.usual);
    QVERIFY(half.possible);
    QCOMPARE(half.changed(), changes);
}

void TestFaults::noFault_changesAnythingAtSizeZero()
{
    const ShotEvidence evidence = evidenceOfAll();
    for (const Fault &fault : possibleFaults(kSensors)) {
        const Taken nothing = taken(fault, evidence, 0.0);
        QVERIFY(nothing.possible);
        for (const auto &[name, value] : contentOf(nothing.after)) {
            const auto before = contentOf(nothing.before).at(name);
            for (std::size_t i = 0; i < value.size(); ++i)
                QVERIFY(std::abs(value[i] - before[i]) < 1e-15); // of gamma, by its cp
        }
    }
}

void TestFaults::factors_areExponentials()
{
    const ShotEvidence evidence = evidenceOfAll();
    const double factor = std::exp(0.3);
    QVERIFY(isNear(taken(faultOf(C::Rate), evidence, 0.3).after.timeFactor, factor));
    QVERIFY(isNear(taken(faultOf(C::Rate), evidence, -0.3).after.timeFactor, 1.0 / factor));
    QVERIFY(isNear(taken(faultOf(C::Pressure), evidence, 0.3).after.step.state.pressure_Pa,
        kMadeP1_Pa * factor));
    QVERIFY(isNear(taken(faultOf(C::Scale), evidence, 0.3).after.level, factor));
    for (const double gain : taken(faultOf(C::Scale, 1), evidence, 0.3).after.gain)
        QVERIFY(isNear(gain, factor));
    QVERIFY(isNear(taken(faultOf(C::Typed), evidence, 0.3).after.step.velocityShift_m_s,
        500.0 * (factor - 1.0)));
}

void TestFaults::differences_areAdded()
{
    const ShotEvidence evidence = evidenceOfAll();
    QVERIFY(isNear(taken(faultOf(C::Temperature), evidence, -7.0).after.step.state.temperature_K,
        kMadeT1_K - 7.0));
    QVERIFY(isNear(
        taken(faultOf(C::Attenuation), evidence, 0.004).after.step.attenuation_per_m, 0.004));
    QVERIFY(isNear(
        taken(faultOf(C::Humidity), evidence, 0.25).after.step.state.relativeHumidity, 0.65));
}

void TestFaults::molarMass_actsOnTheSpeedOfSound()
{
    // By its size, as ln a1: a molar mass of M exp(-2 s).
    const ShotEvidence evidence = evidenceOfAll();
    const CheckPoint after = taken(faultOf(C::Gas), evidence, 0.1).after;
    Gas changed = evidence.gas;
    changed.molarMass_kg_mol += after.step.molarMassShift_kg_mol;
    QVERIFY(isNear(
        soundSpeed_m_s(changed, 300.0), std::exp(0.1) * soundSpeed_m_s(evidence.gas, 300.0)));
}

void TestFaults::mixture_isThatOfMoles()
{
    // A quarter of argon, cp/R = 5/2, in air of 1.402.
    const CheckPoint after = taken(mixtureWith("ar"), evidenceOfAll(), 0.25).after;
    const double cp = 0.75 * (1.402 / 0.402) + 0.25 * 2.5;
    QVERIFY(std::abs(1.402 + after.step.gammaShift - cp / (cp - 1.0)) < 1e-14);
    QVERIFY(
        std::abs(0.028966 + after.step.molarMassShift_kg_mol - (0.75 * 0.028966 + 0.25 * 0.039948))
        < 1e-16);
}

void TestFaults::wholeShare_isTheOtherGas()
{
    for (const NamedGas &gas : knownGases()) {
        const Taken all = taken(mixtureWith(gas.name), evidenceOfAll(), 1.0);
        QVERIFY(all.possible);
        QVERIFY(std::abs(1.402 + all.after.step.gammaShift - gas.gamma) < 1e-14);
        QVERIFY(std::abs(0.028966 + all.after.step.molarMassShift_kg_mol - gas.molarMass_kg_mol)
            < 1e-16);
    }
}

void TestFaults::shares_lieBetweenNothingAndAll()
{
    const ShotEvidence evidence = evidenceOfAll();
    for (const NamedGas &gas : knownGases()) {
        QVERIFY(!taken(mixtureWith(gas.name), evidence, -0.01).possible);
        QVERIFY(!taken(mixtureWith(gas.name), evidence, 1.01).possible);
    }
}

void TestFaults::distance_movesItsSensorAlone()
{
    const ShotEvidence evidence = evidenceOfAll();
    const Eigen::VectorXd second
        = taken(faultOf(C::Distance, 1), evidence, 0.01).after.step.distance_m;
    QVERIFY(isNear(second[0], 0.8) && isNear(second[1], 0.51) && second[2] == 0.0);
    // The same sensor where it comes first, because the other one saw nothing.
    ShotEvidence alone = madeEvidence({.places_m = {0.5}});
    alone.readings[0].channel = alone.measurement->velocity.sightings[0].channel = "side 2";
    QVERIFY(isNear(taken(faultOf(C::Distance, 1), alone, 0.01).after.step.distance_m[0], 0.51));
    QVERIFY(taken(faultOf(C::Distance, 0), alone, 0.01).changed().empty());
}

void TestFaults::distance_isAboveZero()
{
    const ShotEvidence evidence = evidenceOfAll();
    QVERIFY(taken(faultOf(C::Distance, 1), evidence, -0.49).possible);
    QVERIFY(!taken(faultOf(C::Distance, 1), evidence, -0.5).possible);
    ShotEvidence wall = evidenceOfAll();
    wall.readings[2].channel = "side 1";
    wall.readings[0].channel = "other";
    QVERIFY(taken(faultOf(C::Distance, 0), wall, 0.01).changed().empty()); // that is the DUT
}

void TestFaults::delays_areThoseOfTheSideSensors()
{
    const Eigen::VectorXd delays
        = taken(faultOf(C::Delay), evidenceOfAll(), 3e-6).after.step.delay_s;
    QCOMPARE(delays.size(), Index(3));
    QCOMPARE(delays[0], 3e-6);
    QCOMPARE(delays[1], 3e-6);
    QCOMPARE(delays[2], 0.0); // the DUT's onset has none
}

void TestFaults::typedDelays_areThoseThatWereTyped()
{
    ShotEvidence evidence = evidenceOfAll();
    const Fault typed = faultOf(C::Delay, 1);
    QVERIFY(taken(typed, evidence, 1e-5).changed().empty());
    evidence.readings[1].isDelayTyped = true;
    const Taken moved = taken(typed, evidence, 1e-5);
    QCOMPARE(moved.changed(), Names{"delays"});
    const Eigen::VectorXd by = moved.after.step.delay_s - moved.before.step.delay_s;
    QCOMPARE(by[0], 0.0);
    QVERIFY(isNear(by[1], 1e-5));
}

void TestFaults::counters_moveTheVelocity()
{
    ShotEvidence evidence = madeEvidence({});
    const Fault typed = faultOf(C::Typed);
    QVERIFY(taken(typed, evidence, 0.1).changed().empty()); // of arrivals: nothing typed
    evidence.measurement->counters = {{.far_m = 0.8, .near_m = 0.3, .time_s = 1e-3}};
    QCOMPARE(taken(typed, evidence, 0.1).changed(), Names{"velocity"});
}

void TestFaults::typedStep_goesBeforeTheTypedVelocity()
{
    ShotEvidence evidence = evidenceOfAll();
    evidence.typedStep_Pa = evidence.measurement->typedStep_Pa = 4e5;
    const Taken step = taken(faultOf(C::Typed), evidence, 0.2);
    QCOMPARE(step.changed(), Names{"step"});
    QVERIFY(isNear(step.after.step.stepFactor, std::exp(0.2)));
    const Taken alone = taken(faultOf(C::Typed), madeOfTypedStep(1e-8), -0.2);
    QVERIFY(isNear(alone.after.step.stepFactor, std::exp(-0.2)));
}

void TestFaults::nothingToActOn_changesNothing()
{
    // Other shots of the calibration may have it, so that the fault itself is possible.
    const ShotEvidence measured = madeEvidence({}); // in air of typed constants
    for (const C cause : {C::Typed, C::Humidity}) {
        const Taken nothing = taken(faultOf(cause), measured, 0.3);
        QVERIFY(nothing.possible && nothing.changed().empty());
    }
    const ShotEvidence typed = madeOfTypedStep(1e-8);
    for (const C cause : {C::Delay, C::Distance, C::Humidity}) {
        const Taken nothing = taken(faultOf(cause), typed, 1e-6);
        QVERIFY(nothing.possible && nothing.changed().empty());
    }
}

void TestFaults::humidity_staysBetweenDryAndSaturated()
{
    ShotEvidence evidence = evidenceOfAll();
    for (const char *gas : {"moist-air", "humid-air"}) {
        evidence.measurement->gas.substance = gas;
        QVERIFY(taken(faultOf(C::Humidity), evidence, 0.6).possible);
        QVERIFY(taken(faultOf(C::Humidity), evidence, -0.4).possible);
        QVERIFY(!taken(faultOf(C::Humidity), evidence, 0.61).possible);
        QVERIFY(!taken(faultOf(C::Humidity), evidence, -0.41).possible);
    }
}

void TestFaults::everyFault_isListedOnce()
{
    std::map<C, std::size_t> count;
    for (const Fault &fault : possibleFaults(kSensors)) {
        ++count[fault.cause];
        QVERIFY(fault.usual > 0.0 && fault.usual <= fault.largest);
        QCOMPARE(fault.perShot, fault.cause == C::Typed);
    }
    for (const C once :
        {C::Typed, C::Rate, C::Temperature, C::Humidity, C::Pressure, C::Attenuation})
        QCOMPARE(count[once], std::size_t(1));
    QCOMPARE(count[C::Scale], std::size_t(2));
    QCOMPARE(count[C::Delay], std::size_t(2)); // of all side sensors, and of those typed
    QCOMPARE(count[C::Gas], 1 + knownGases().size());
    QCOMPARE(count[C::Distance], kSensors.size());
    QCOMPARE(possibleFaults({}).size(), possibleFaults(kSensors).size() - 2);
}

void TestFaults::takenBack_theShotsAgreeAgain_data()
{
    QTest::addColumn<MadeShot>("made");
    QTest::addColumn<C>("cause");
    QTest::addColumn<int>("which");
    QTest::addColumn<double>("size");
    QTest::newRow("clock 20 % slow")
        << MadeShot{.timeFactor = 0.8} << C::Rate << 0 << -std::log(0.8);
    QTest::newRow("lighter gas") << MadeShot{.gas = {1.402, 0.028966 * std::exp(-0.1)}} << C::Gas
                                 << 0 << 0.05;
    QTest::newRow("nitrogen for air") << MadeShot{.gas = {1.4, 0.028014}} << C::Gas << 2 << 1.0;
    QTest::newRow("warmer") << MadeShot{.trueT1_K = kMadeT1_K + 12.0} << C::Temperature << 0
                            << 12.0;
    QTest::newRow("more pressure")
        << MadeShot{.trueP1_Pa = 1.1 * kMadeP1_Pa} << C::Pressure << 0 << std::log(1.1);
    QTest::newRow("first sensor noted too near")
        << MadeShot{.distanceShift_m = -0.015} << C::Distance << 0 << 0.015;
    QTest::newRow("side sensors read too much")
        << MadeShot{.sideGain = 1.2} << C::Scale << 1 << -std::log(1.2);
    QTest::newRow("DUT reads too much")
        << MadeShot{.dutGain = 1.5} << C::Scale << 0 << -std::log(1.5);
    QTest::newRow("typed too fast") << MadeShot{.typedVelocity_m_s = 530.0} << C::Typed << 0
                                    << std::log(kMadeVelocity_m_s / 530.0);
}

void TestFaults::takenBack_theShotsAgreeAgain()
{
    QFETCH(MadeShot, made);
    QFETCH(C, cause);
    QFETCH(int, which);
    QFETCH(double, size);
    const MadeComparison shots(std::vector<MadeShot>{made});
    QVERIFY(shots.compared->differences().cwiseAbs().maxCoeff() > 0.01);
    std::vector<CheckPoint> points{shots.ways[0]->nominal()};
    QVERIFY(faultOf(cause, which).takeBack(*shots.evidence[0], size, points[0]));
    const Eigen::VectorXd left = shots.compared->differencesAt(points);
    QCOMPARE(left.size(), shots.compared->differences().size());
    QVERIFY(left.cwiseAbs().maxCoeff() < 1e-8);
}

DYNCAL_TEST(TestFaults)
#include "tst_faults.moc"

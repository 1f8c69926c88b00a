// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/shock/shock_conditions.h"
#include "core/shock/shock_estimate.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dyncal;

namespace {

constexpr double kVelocity_m_s = 512.8;
constexpr double kAtWall_s = 2e-3;

CaptureSet thesisSet()
{
    CaptureSet set;
    Shot shot;
    shot.environment.p1_Pa = 101100.0;
    shot.environment.u_p1_Pa = 30.0;
    shot.environment.T1_K = 294.15;
    shot.environment.u_T1_K = 0.3;
    shot.environment.T4_K = 295.35;
    set.shots.push_back(shot);
    set.tube["driven_length_m"] = "0.97";
    set.tube["driver_length_m"] = "0.97";
    set.tube["inner_diameter_m"] = "0.1";
    return set;
}

ShockSettings typedVelocity()
{
    ShockSettings settings;
    settings.drivenGas = settings.driverGas = GasSettings(); // dry air, as in the thesis
    settings.velocity_m_s = kVelocity_m_s;
    return settings;
}

/// Sensors whose arrivals are typed, as the cursors of the workbench do.
ShockSettings typedArrivals(const std::vector<double> &distances_m)
{
    ShockSettings settings;
    settings.attenuation = "none";
    for (const double x : distances_m)
        settings.arrivalSensors.push_back(
            {"toa " + std::to_string(x), x, 2e-4, kAtWall_s - x / kVelocity_m_s, 1e-7, 0.0, 0.0});
    return settings;
}

const Finding *findingWithId(const ShockConditionsSet &set, const char *id)
{
    const auto found = std::find_if(
        set.findings.begin(), set.findings.end(), [&](const Finding &f) { return f.id == id; });
    return found != set.findings.end() ? &*found : nullptr;
}

ShockConditionsSet estimated(const CaptureSet &set, const ShockSettings &settings,
    const std::vector<DutArrival> &arrivals = {}, const UncertaintyRequest &request = {})
{
    return estimateShockConditions(set, arrivals, settings, request).value();
}

UncertaintyRequest budget()
{
    UncertaintyRequest request;
    request.evaluate = true;
    return request;
}

} // namespace

class TestShockFindings : public QObject
{
    Q_OBJECT

private slots:
    void celsius_offersKelvin();
    void celsiusOfTheDriver_offersKelvin();
    void psiForPascal_offersPascal();
    void typedBesideRecorded_isTold_data();
    void typedBesideRecorded_isTold();
    void swappedChannels_offerTheExchange();
    void uncorrectedDut_isWarnedAbout();
    void scatteringArrivals_chiSquare();
    void uncertainVelocity_namesFactor();
    void stateFromDriverOrP2_givesTheVelocityBack();
    void unreachableOrMissingPressures_areFindings();
    void humidAir_usesItsHumidity_orHalf();
    void variableHeatCapacity_reachesTheStep();
    void typedArrivals_threeSensors_velocityAndBudget();
    void sideWall_plateauUntilTheReflectedShock();
    void guard_isTakenOff();
    void tube_diagramAndCandidatesAreThere();
    void typedStep_hasNoUncertaintyOfTheStep();
    void typedStep_hasTheUStated();
    void oneNumberForSeveralShots_isSaid();
    void oneArrivalForSeveralShots_isSaid();
    void listOfTheWrongLength_isRefused();
    void beyondTheTube_blocks();
};

void TestShockFindings::celsius_offersKelvin()
{
    ShockSettings settings = typedVelocity();
    settings.T1_K = 21.0;
    const auto result = estimated(thesisSet(), settings);
    const Finding *finding = findingWithId(result, "SHK-004");
    QVERIFY(finding && finding->severity == Severity::Block && finding->correction);
    QCOMPARE(finding->correction->key, std::string("shock.t1_k"));
    QCOMPARE(finding->correction->value, std::string("294.15"));
    QCOMPARE(english(finding->correction->label), std::string("Use 294.15 K"));
    settings.T1_K = 500.0; // nothing to offer
    QVERIFY(!findingWithId(estimated(thesisSet(), settings), "SHK-004")->correction);
}

void TestShockFindings::celsiusOfTheDriver_offersKelvin()
{
    ShockSettings settings = typedVelocity();
    settings.T4_K = 22.0;
    const auto result = estimated(thesisSet(), settings);
    const Finding *finding = findingWithId(result, "SHK-004");
    QVERIFY(finding && finding->severity == Severity::Caution && finding->correction);
    QCOMPARE(finding->correction->key, std::string("shock.t4_k"));
    QVERIFY(result.shots[0].step_Pa.has_value());
}

void TestShockFindings::psiForPascal_offersPascal()
{
    ShockSettings settings = typedVelocity();
    const std::pair<double, double> typed[]
        = {{14.66, 14.66 * 6894.757}, {1.011, 101100.0}, {101.1, 101100.0}, {1011.0, 101100.0}};
    for (const auto &[value, pascals] : typed) {
        settings.p1_Pa = value;
        const auto result = estimated(thesisSet(), settings);
        const Finding *finding = findingWithId(result, "SHK-011");
        QVERIFY(finding && finding->correction);
        QCOMPARE(finding->correction->key, std::string("shock.p1_pa"));
        QCOMPARE(finding->causes.front(), FindingCause::Pressure);
        QVERIFY(std::abs(std::stod(finding->correction->value) / pascals - 1.0) < 1e-12);
    }
    for (const double fine : {101100.0, 454.0, 50e3}) {
        settings.p1_Pa = fine;
        QVERIFY(!findingWithId(estimated(thesisSet(), settings), "SHK-011"));
    }
}

void TestShockFindings::typedBesideRecorded_isTold_data()
{
    QTest::addColumn<double>("p1_Pa");
    QTest::addColumn<double>("T1_K");
    QTest::addColumn<double>("u_p1_Pa");
    QTest::addColumn<bool>("isTold");
    QTest::addColumn<QString>("effect");
    QTest::newRow("as recorded") << 101100.0 << 294.15 << 30.0 << false << "";
    QTest::newRow("a reading beside it") << 101500.0 << 294.9 << 30.0 << false << "";
    QTest::newRow("of the weather service") << 98000.0 << 294.15 << 30.0 << true << "3.16 %";
    QTest::newRow("the same, recorded roughly") << 98000.0 << 294.15 << 1000.0 << false << "";
    QTest::newRow("nothing stated of the recorded one")
        << 98000.0 << 294.15 << 0.0 << true << "3.16 %";
    QTest::newRow("of another day") << 101100.0 << 288.15 << 30.0 << true << "%";
}

void TestShockFindings::typedBesideRecorded_isTold()
{
    QFETCH(double, p1_Pa);
    QFETCH(double, T1_K);
    QFETCH(double, u_p1_Pa);
    QFETCH(bool, isTold);
    QFETCH(QString, effect);
    CaptureSet set = thesisSet();
    set.shots[0].environment.u_p1_Pa = u_p1_Pa;
    ShockSettings settings = typedVelocity();
    settings.p1_Pa = p1_Pa;
    settings.T1_K = T1_K;
    const auto result = estimated(set, settings);
    const Finding *finding = findingWithId(result, "SHK-020");
    QCOMPARE(finding != nullptr, isTold);
    if (finding) {
        QCOMPARE(finding->causes.front(), FindingCause::Typed);
        const QString text = QString::fromStdString(english(finding->message));
        QVERIFY2(text.contains(effect), qPrintable(text));
    }
    set.shots[0].environment.p1_Pa = set.shots[0].environment.T1_K = std::nan("");
    QVERIFY(!findingWithId(estimated(set, settings), "SHK-020"));
}

void TestShockFindings::swappedChannels_offerTheExchange()
{
    CaptureSet set = thesisSet();
    Channel side, dut;
    side.name = "ch 1";
    side.role = ChannelRole::DrivenSide;
    dut.name = "ch 2";
    dut.role = ChannelRole::Dut;
    set.shots[0].channels = {dut, side};
    ShockSettings settings;
    settings.arrivalSensors = {{side.name, 0.8, 2e-4, 2e-3, 1e-7, 0.0, 0.0}};
    const auto result = estimated(set, settings, {{1, 0.5e-3}});
    const Finding *finding = findingWithId(result, "SHK-001");
    QVERIFY(finding && finding->correction);
    QCOMPARE(finding->correction->key, std::string("import.channels"));
    const std::string exchanged = "{\"ch 1\":\"dut\",\"ch 2\":\"driven_side\"}";
    QCOMPARE(finding->correction->value, exchanged);
}

void TestShockFindings::uncorrectedDut_isWarnedAbout()
{
    const ShockSettings settings = typedArrivals({0.8});
    const auto corrected = estimated(thesisSet(), settings, {{1, kAtWall_s, 1e-9, true}});
    QVERIFY(!findingWithId(corrected, "SHK-008"));
    const auto late = estimated(thesisSet(), settings, {{1, kAtWall_s, 0.0, false}});
    const Finding *finding = findingWithId(late, "SHK-008");
    QVERIFY(finding && finding->severity == Severity::Caution);
    // 1 us of 1.56 ms is 0.064 %, times 4.65 on the step.
    const std::string text = english(finding->message);
    QVERIFY2(text.find("0.064 %") != std::string::npos, text.c_str());
    QVERIFY2(text.find("0.3 %") != std::string::npos, text.c_str());
    ShockSettings without = typedArrivals({0.8, 0.3});
    without.useDutArrival = false;
    QVERIFY(
        !findingWithId(estimated(thesisSet(), without, {{1, kAtWall_s, 0.0, false}}), "SHK-008"));
}

void TestShockFindings::scatteringArrivals_chiSquare()
{
    ShockSettings settings = typedArrivals({0.9, 0.5, 0.1});
    settings.attenuation = "none";
    QVERIFY(!findingWithId(estimated(thesisSet(), settings), "SHK-010"));
    *settings.arrivalSensors[1].arrival_s += 5e-6; // an order above what is stated
    const auto result = estimated(thesisSet(), settings);
    const Finding *finding = findingWithId(result, "SHK-010");
    QVERIFY(finding && *finding->value < 0.01);
}

void TestShockFindings::uncertainVelocity_namesFactor()
{
    UncertaintyRequest request = budget();
    request.stated = {{"velocity_m_s", 0.0033 * kVelocity_m_s, Distribution::Normal, {}}};
    const auto result = estimated(thesisSet(), typedVelocity(), {}, request);
    const Finding *finding = findingWithId(result, "SHK-003");
    QVERIFY(finding);
    QCOMPARE(english(finding->message),
        std::string(
            "Velocity uncertainty 0.33 % gives 1.5 % on the pressure step (factor 4.65); the budget says where it comes from."));
}

void TestShockFindings::stateFromDriverOrP2_givesTheVelocityBack()
{
    const ShockConditions direct = estimated(thesisSet(), typedVelocity()).shots[0];
    ShockSettings fromDriver;
    fromDriver.drivenGas = fromDriver.driverGas = GasSettings();
    fromDriver.stateFrom = "p4";
    fromDriver.p4_Pa = direct.driver->pressure_Pa;
    ShockSettings fromShocked;
    fromShocked.drivenGas = GasSettings();
    fromShocked.stateFrom = "p2";
    fromShocked.p2_Pa = direct.states->shocked.pressure_Pa;
    for (const ShockSettings &settings : {fromDriver, fromShocked}) {
        const ShockConditions found = estimated(thesisSet(), settings).shots[0];
        QVERIFY(std::abs(found.states->velocity_m_s / kVelocity_m_s - 1.0) < 1e-12);
        QVERIFY(std::abs(*found.step_Pa / *direct.step_Pa - 1.0) < 1e-11);
    }
}

void TestShockFindings::unreachableOrMissingPressures_areFindings()
{
    ShockSettings settings;
    settings.stateFrom = "p4"; // none is known
    const auto none = estimated(thesisSet(), settings);
    QVERIFY(findingWithId(none, "SHK-001") && !none.shots[0].step_Pa);
    settings.p4_Pa = 0.5e5;
    QVERIFY(!estimated(thesisSet(), settings).shots[0].step_Pa);
    ShockSettings fast;
    fast.velocity_m_s = 2500.0; // no driver of air can make that
    const auto unreachable = estimated(thesisSet(), fast);
    const Finding *finding = findingWithId(unreachable, "SHK-006");
    QVERIFY(finding && finding->severity == Severity::Caution);
    QVERIFY(!unreachable.shots[0].driver);
}

void TestShockFindings::humidAir_usesItsHumidity_orHalf()
{
    ShockSettings settings = typedVelocity();
    settings.drivenGas.substance = "humid-air";
    const auto unknown = estimated(thesisSet(), settings).shots[0];
    settings.relativeHumidity = 0.5;
    const auto known = estimated(thesisSet(), settings).shots[0];
    QVERIFY(std::abs(known.states->driven.soundSpeed_m_s - 344.6135) < 1e-4);
    QCOMPARE(known.drivenGas->name, std::string("humid-air"));
    QCOMPARE(*unknown.step_Pa, *known.step_Pa); // nothing known: half, from 0 to 1
    QVERIFY(known.driver.has_value()); // the driver's pressure is beyond Cramer's range
    CaptureSet warm = thesisSet();
    warm.shots[0].environment.T1_K = 310.0;
    QVERIFY(findingWithId(estimated(warm, settings), "SHK-009"));
}

void TestShockFindings::variableHeatCapacity_reachesTheStep()
{
    ShockSettings settings = typedVelocity();
    settings.drivenGas.heatCapacity = kVariableHeatCapacity;
    const auto varying = estimated(thesisSet(), settings).shots[0];
    const auto thesis = estimated(thesisSet(), typedVelocity()).shots[0];
    const double percent = 100.0
        * (varying.states->reflected.pressure_Pa / thesis.states->reflected.pressure_Pa - 1.0);
    QVERIFY(std::abs(percent - 0.24955) < 1e-3);
    settings.drivenGas.substance = "custom";
    QVERIFY(!estimateShockConditions(thesisSet(), {}, settings));
}

void TestShockFindings::typedArrivals_threeSensors_velocityAndBudget()
{
    const auto result
        = estimated(thesisSet(), typedArrivals({0.9, 0.5, 0.1}), {}, budget()).shots[0];
    QVERIFY(std::abs(result.states->velocity_m_s / kVelocity_m_s - 1.0) < 1e-10);
    QCOMPARE(result.sightings.size(), std::size_t(3));
    QVERIFY(std::abs(result.velocityFit->arrivalAtWall_s - kAtWall_s) < 1e-12);
    QVERIFY(result.uncertainty && result.uncertainty->u(StepResult::Step));
    QVERIFY(result.measurement.has_value());
    // u(W)/W = sqrt(u_x^2 + (u_t W)^2)/sqrt(sum of squares of the levers).
    const double each_m = std::hypot(2e-4, 1e-7 * kVelocity_m_s);
    const double expected = each_m / std::sqrt(0.32);
    QVERIFY(std::abs(*result.uncertainty->u(StepResult::Velocity) / kVelocity_m_s / expected - 1.0)
        < 1e-5);
}

void TestShockFindings::sideWall_plateauUntilTheReflectedShock()
{
    ShockSettings settings = typedVelocity();
    settings.dutPosition = kSideWall;
    settings.dutDistance_m = 0.3;
    settings.dutDiameter_m = 5.5e-3;
    const auto result = estimated(thesisSet(), settings);
    const ShockConditions &c = result.shots[0];
    QVERIFY(std::abs(*c.plateau_s - (0.3 / 512.8 + 0.3 / 325.219169)) < 1e-9);
    QCOMPARE(*c.plateauEnd, PlateauEnd::ReflectedShock);
    QVERIFY(std::abs(*c.sideWallLimit_Hz - 48e3) < 500.0);
    QVERIFY(std::abs(*c.step_Pa - (245253.880 - 101100.0)) < 1e-2);
    QVERIFY(english(findingWithId(result, "SHK-005")->message).find("passes the DUT")
        != std::string::npos);
}

void TestShockFindings::guard_isTakenOff()
{
    ShockSettings settings = typedVelocity();
    const double full_s = *estimated(thesisSet(), settings).shots[0].plateau_s;
    settings.plateauGuard_s = 1e-4;
    QVERIFY(std::abs(*estimated(thesisSet(), settings).shots[0].plateau_s - full_s + 1e-4) < 1e-15);
    settings.plateauGuard_s = 1.0;
    QCOMPARE(*estimated(thesisSet(), settings).shots[0].plateau_s, 0.0);
    settings.plateauGuard_s = 0.0;
    settings.driverLength_m = 0.2;
    const auto shortDriver = estimated(thesisSet(), settings);
    QCOMPARE(*shortDriver.shots[0].plateauEnd, PlateauEnd::DriverRarefaction);
    QVERIFY(english(findingWithId(shortDriver, "SHK-005")->message).find("longer driver")
        != std::string::npos);
}

void TestShockFindings::tube_diagramAndCandidatesAreThere()
{
    const auto c
        = estimated(thesisSet(), typedArrivals({0.8}), {{1, kAtWall_s, 1e-9, true}}).shots[0];
    QVERIFY(c.diagram.has_value());
    QCOMPARE(c.diagram->sensors.size(), std::size_t(2));
    QVERIFY(std::abs(*c.diagram->sensors[0].arrival_s - c.diagram->sensors[0].expected_s) < 1e-9);
    QVERIFY(std::abs(c.diagram->burst_s - (kAtWall_s - 0.97 / kVelocity_m_s)) < 1e-9);
    QCOMPARE(c.resonances.size(), std::size_t(4 * 3 + 12));
    // Without lengths there is neither, and the step stands.
    CaptureSet bare = thesisSet();
    bare.tube.clear();
    const auto without = estimated(bare, typedVelocity()).shots[0];
    QVERIFY(without.step_Pa && !without.diagram && without.resonances.empty());
}

void TestShockFindings::typedStep_hasNoUncertaintyOfTheStep()
{
    ShockSettings settings;
    settings.step_Pa = 4e5;
    const auto c = estimated(thesisSet(), settings, {}, budget()).shots[0];
    QVERIFY(c.stepTyped && !c.uncertainty);
}

void TestShockFindings::typedStep_hasTheUStated()
{
    UncertaintyRequest request = budget();
    request.stated = {{"step_relative", 0.004, Distribution::Normal, {}}};
    for (const bool knowsVelocity : {false, true}) {
        ShockSettings settings;
        settings.drivenGas = settings.driverGas = GasSettings();
        settings.step_Pa = 4e5;
        if (knowsVelocity)
            settings.velocity_m_s = kVelocity_m_s;
        const auto c = estimated(thesisSet(), settings, {}, request).shots[0];
        QVERIFY(c.uncertainty);
        QVERIFY(std::abs(*c.uncertainty->u(StepResult::Step) - 1600.0) < 1e-6);
        QVERIFY(!c.uncertainty->u(StepResult::Velocity)); // its u is not stated
    }
}

void TestShockFindings::oneNumberForSeveralShots_isSaid()
{
    CaptureSet set = thesisSet();
    QVERIFY(!findingWithId(estimated(set, typedVelocity()), "SHK-018")); // one shot
    set.shots.push_back(set.shots.front());
    const auto common = estimated(set, typedVelocity());
    const Finding *said = findingWithId(common, "SHK-018");
    QVERIFY(said && said->severity == Severity::Caution && said->shot == 0);
    QCOMPARE(said->causes, std::vector<FindingCause>{FindingCause::Typed});
    ShockSettings listed = typedVelocity();
    listed.velocity_m_s = PerShot({kVelocity_m_s, 450.0});
    const auto each = estimated(set, listed);
    QVERIFY(!findingWithId(each, "SHK-018"));
    QCOMPARE(each.shots[0].states->velocity_m_s, kVelocity_m_s);
    QCOMPARE(each.shots[1].states->velocity_m_s, 450.0);
    listed.step_Pa = PerShot({std::nullopt, 3e5});
    const auto mixed = estimated(set, listed);
    QVERIFY(!mixed.shots[0].stepTyped && mixed.shots[1].stepTyped);
    QCOMPARE(*mixed.shots[1].step_Pa, 3e5);
}

void TestShockFindings::oneArrivalForSeveralShots_isSaid()
{
    CaptureSet set = thesisSet();
    set.shots.push_back(set.shots.front());
    ShockSettings settings = typedVelocity();
    settings.velocity_m_s = PerShot({kVelocity_m_s, kVelocity_m_s});
    settings.arrivalSensors = {{.channel = "side", .distanceToEndWall_m = 0.8, .arrival_s = -1e-3}};
    const auto once = estimated(set, settings);
    const Finding *said = findingWithId(once, "SHK-018");
    QVERIFY(said && english(said->message).find("-1 ms") != std::string::npos);
    settings.arrivalSensors[0].shotArrival_s = {-1e-3, -1.1e-3};
    QVERIFY(!findingWithId(estimated(set, settings), "SHK-018"));
}

void TestShockFindings::listOfTheWrongLength_isRefused()
{
    ShockSettings settings = typedVelocity();
    settings.velocity_m_s = PerShot({500.0, 510.0});
    const auto refused = estimateShockConditions(thesisSet(), {}, settings);
    QVERIFY(!refused && refused.error().kind == ErrorKind::Usage);
    QVERIFY(english(refused.error().message).find("shock.velocity_m_s") != std::string::npos);
}

void TestShockFindings::beyondTheTube_blocks()
{
    CaptureSet set = thesisSet();
    ShockSettings settings = typedVelocity();
    QVERIFY(!findingWithId(estimated(set, settings), "SHK-019"));
    settings.largestMach = 1.4; // the shock has Mach 1.49
    const auto fast = estimated(set, settings);
    const Finding *mach = findingWithId(fast, "SHK-019");
    QVERIFY(mach && mach->severity == Severity::Block);
    QVERIFY(std::abs(*mach->value - 1.4904) < 1e-3);
    settings = typedVelocity();
    set.shots[0].environment.p4_Pa = 2e5; // the shock needs 0.685 MPa
    const auto strong = estimated(set, settings);
    QVERIFY(findingWithId(strong, "SHK-019") && !findingWithId(strong, "SHK-006"));
    settings.step_Pa = 4e5; // stands without a velocity
    const auto typed = estimated(set, settings);
    QCOMPARE(findingWithId(typed, "SHK-019")->severity, Severity::Caution);
    settings = typedVelocity();
    set.shots[0].environment.p4_Pa = 6.8e5;
    settings.largestDriverPressure_Pa = 6e5;
    QVERIFY(findingWithId(estimated(set, settings), "SHK-019"));
}

DYNCAL_TEST(TestShockFindings)
#include "tst_shock_findings.moc"
